#include "libvehicle/flat/first_order.h"

namespace vehicle {

Equation7Letters lettersOf(const FlatParameters& parameters, Mapping mapping) {
  const double bb = parameters.bp[0];
  const double bk = parameters.bs1;
  const bool printed = mapping == Mapping::kPrinted;
  return {.mk = parameters.mk,
          .j2 = parameters.Jk,
          .mb = parameters.m1,
          .a2 = parameters.lf,
          .c1 = parameters.cp[0],
          .b1 = printed ? bk : bb,
          .c2 = parameters.cs1,
          .b2 = printed ? bb : bk};
}

Equation7 equation7(const Equation7Letters& letters) {
  const auto [mk, j2, mb, a2, c1, b1, c2, b2] = letters;
  const double stiff = (2 * c1 + c2) / mb;
  const double damp = (2 * b1 + b2) / mb;
  const double arm = a2 * a2;
  Equation7 system;
  auto& A = system.A;
  // clang-format off
  // columns z1       z1'      z2       z2'      zk            zk'           phi            phi'
  A[0] = {0,       1,       0,       0,       0,            0,            0,             0};
  A[1] = {-stiff,  -damp,   0,       0,       c2 / mb,      b2 / mb,      a2 * c2 / mb,  a2 * b2 / mb};
  A[2] = {0,       0,       0,       1,       0,            0,            0,             0};
  A[3] = {0,       0,       -stiff,  -damp,   c2 / mb,      b2 / mb,      -a2 * c2 / mb, -a2 * b2 / mb};
  A[4] = {0,       0,       0,       0,       0,            1,            0,             0};
  A[5] = {c2 / mk, b2 / mk, c2 / mk, b2 / mk, -2 * c2 / mk, -2 * b2 / mk, 0,             0};
  A[6] = {0,       0,       0,       0,       0,            0,            0,             1};
  A[7] = {a2 * c2 / j2, a2 * b2 / j2, -a2 * c2 / j2, -a2 * b2 / j2, 0, 0, -2 * arm * c2 / j2, -2 * arm * b2 / j2};
  // clang-format on
  // columns      eta1     eta2     eta3     eta4     eta1'    eta2'    eta3'    eta4'
  system.B[1] = {c1 / mb, c1 / mb, 0,       0,       b1 / mb, b1 / mb, 0,       0};
  system.B[3] = {0,       0,       c1 / mb, c1 / mb, 0,       0,       b1 / mb, b1 / mb};
  return system;
}

}  // namespace vehicle
