#include "libvehicle/flat/printed_form.h"

#include <array>
#include <cstddef>

#include "libvehicle/flat/first_order.h"
#include "libvehicle/flat/flat_statics.h"
#include "libvehicle/flat/ordered_form.h"
#include "libvehicle/flat/printed_variants.h"

namespace vehicle {
namespace {

/// The paper's letters of a symmetric vehicle.
PaperCoefficients<double> paperCoefficients(const FlatParameters& v) {
  return {.inv_mk = 1.0 / v.mk,
          .inv_Jk = 1.0 / v.Jk,
          .inv_mb = 1.0 / v.m1,
          .inv_cb = 1.0 / v.cp[0],
          .ak = v.lf,
          .ck = v.cs1,
          .bk = v.bs1,
          .cb = v.cp[0],
          .bb = v.bp[0]};
}

/// x' = f(x, u) as printed, in inner order; called as FlatRhs is.
class PrintedEquations {
 public:
  PrintedEquations(const FlatParameters& parameters, FlatVariant variant)
      : variant_(variant),
        paper_(paperCoefficients(parameters)),
        seven_(equation7(lettersOf(parameters, Mapping::kPrinted))) {}

  void operator()(const double* x, const double* u, double* dx) const {
    if (variant_ == FlatVariant::kPrinted7) {
      seven(x, u, dx);
    } else {
      literal(x, u, dx);
    }
  }

 private:
  void literal(const double* x, const double* u, double* dx) const {
    const FlatState<double> s{x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]};
    const FlatRail<double> rail{u[0], u[1], u[2], u[3], u[4], u[5], u[6], u[7]};
    const double inv_inertia_of_4 = variant_ == FlatVariant::kLiteral ? paper_.inv_cb : paper_.inv_mb;
    dx[0] = s.dzk;
    dx[1] = s.dphi;
    dx[2] = s.dz1;
    dx[3] = s.dz2;
    dx[4] = printedCarbodyBounce(paper_, s);
    dx[5] = printedCarbodyPitch(paper_, s);
    dx[6] = printedFrontBogieBounce(paper_, s, rail, inv_inertia_of_4);
    dx[7] = printedRearBogieBounce(paper_, s, rail);
  }

  void seven(const double* x, const double* u, double* dx) const {
    // Place of (z1, z1', z2, z2', zk, zk', phi, phi') in the inner state.
    static constexpr std::array<std::size_t, 8> kPlace = {2, 6, 3, 7, 0, 4, 1, 5};
    for (std::size_t row = 0; row < 8; ++row) {
      double sum = 0.0;
      for (std::size_t col = 0; col < 8; ++col) {
        sum += seven_.A[row][col] * x[kPlace[col]] + seven_.B[row][col] * u[col];
      }
      dx[kPlace[row]] = sum;
    }
  }

  FlatVariant variant_;
  PaperCoefficients<double> paper_;
  Equation7 seven_;
};

class PrintedForm final : public OrderedForm<PrintedEquations> {
 public:
  PrintedForm(const CompiledModel& model, const FlatLayout& layout, const FlatLoads& loads,
              const FlatParameters& parameters, FlatVariant variant)
      : OrderedForm(model, layout, loads, parameters, PrintedEquations(parameters, variant)), variant_(variant) {}

  FlatVariant variant() const override { return variant_; }
  const FlatRhs* rhs() const override { return nullptr; }

 private:
  FlatVariant variant_;
};

}  // namespace

std::unique_ptr<FlatForm> buildPrintedForm(const CompiledModel& model, const FlatLayout& layout, FlatVariant variant) {
  const FlatLoads loads = flatLoads(model, layout);
  return std::make_unique<PrintedForm>(model, layout, loads, flatParameters(model.topology, layout, loads), variant);
}

}  // namespace vehicle
