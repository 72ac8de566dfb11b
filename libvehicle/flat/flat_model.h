#pragma once

#include <array>

#include "libvehicle/flat/equations.h"

namespace vehicle {

/// The 4-DOF vehicle in numbers: carbody (z, pitch) on two bogies (z) on four wheels that follow the rail.
/// Wheels 1, 2 stand under the front bogie (the one of larger x), 3, 4 under the rear one; 1 and 3 lead.
struct FlatParameters {
  double mk = 0.0;             // [kg]      > 0 carbody
  double Jk = 0.0;             // [kg m^2]  > 0 its pitch inertia
  double m1 = 0.0, m2 = 0.0;   // [kg]      > 0 front and rear bogie
  double lf = 0.0, lr = 0.0;   // [m]       secondary ahead of / behind the carbody's CG
  double cs1 = 0.0, bs1 = 0.0; // [N/m, N s/m] >= 0 front secondary
  double cs2 = 0.0, bs2 = 0.0; // [N/m, N s/m] >= 0 rear secondary
  std::array<double, 4> cp{};  // [N/m]     >= 0 primary of each wheel
  std::array<double, 4> bp{};  // [N s/m]   >= 0
  double k_g = 0.0;            // [N m/rad] what static loads at heights add to the carbody's pitch stiffness
};

/// Parameters as the equations want them: inverse masses, sums over a bogie's axles.
[[nodiscard]] inline FlatCoefficients<double> coefficientsOf(const FlatParameters& v) {
  return {.inv_mk = 1.0 / v.mk, .inv_Jk = 1.0 / v.Jk, .inv_m1 = 1.0 / v.m1, .inv_m2 = 1.0 / v.m2,
          .lf = v.lf, .lr = v.lr,
          .ck1 = v.cs1, .bk1 = v.bs1, .ck2 = v.cs2, .bk2 = v.bs2,
          .cb1 = v.cp[0], .bb1 = v.bp[0], .cb2 = v.cp[1], .bb2 = v.bp[1],
          .cb3 = v.cp[2], .bb3 = v.bp[2], .cb4 = v.cp[3], .bb4 = v.bp[3],
          .cb12 = v.cp[0] + v.cp[1], .bb12 = v.bp[0] + v.bp[1],
          .cb34 = v.cp[2] + v.cp[3], .bb34 = v.bp[2] + v.bp[3],
          .kg = v.k_g};
}

/// x' = f(x, u) of the 4-DOF vehicle, without virtual call and of fixed size, for steppers that are templates
/// over their right-hand side. Immutable: one object serves any number of threads.
///
/// State x = (zk, phi, z1, z2, zk', phi', z1', z2'), input u = (eta1..eta4, eta1'..eta4'). This is the flat
/// form's inner order; FlatForm tells where each entry stands in a vehicle's own order.
class FlatRhs {
 public:
  static constexpr int kStates = 8;
  static constexpr int kInputs = 8;

  explicit FlatRhs(const FlatParameters& parameters) : p_(coefficientsOf(parameters)) {}

  /// @param x  (8)   @param u  (8)   @param dx  (8)
  [[gnu::always_inline]] inline void operator()(const double* x, const double* u, double* dx) const {
    const FlatState<double> s{x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]};
    const FlatRail<double> rail{u[0], u[1], u[2], u[3], u[4], u[5], u[6], u[7]};
    // All four before the first store: dx might overlap p_ for all the compiler knows, and what the equations share
    // would be computed again after each store.
    const double bounce = carbodyBounce(p_, s);           // (2)
    const double pitch = carbodyPitch(p_, s);             // (3)
    const double front = frontBogieBounce(p_, s, rail);   // (4)
    const double rear = rearBogieBounce(p_, s, rail);     // (5)
    dx[0] = s.dzk;
    dx[1] = s.dphi;
    dx[2] = s.dz1;
    dx[3] = s.dz2;
    dx[4] = bounce;
    dx[5] = pitch;
    dx[6] = front;
    dx[7] = rear;
  }

 private:
  FlatCoefficients<double> p_;
};

}  // namespace vehicle
