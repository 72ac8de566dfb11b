#include "libvehicle/flat/printed_form.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "libvehicle/flat/first_order.h"
#include "libvehicle/flat/flat_order.h"
#include "libvehicle/flat/flat_output.h"
#include "libvehicle/flat/flat_statics.h"
#include "libvehicle/flat/flat_unit_response.h"
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

class PrintedForm final : public FlatForm {
 public:
  PrintedForm(const CompiledModel& model, const FlatLayout& layout, FlatVariant variant)
      : model_(model),
        variant_(variant),
        order_(model, layout),
        loads_(flatLoads(model, layout)),
        parameters_(flatParameters(model.topology, layout, loads_)),
        paper_(paperCoefficients(parameters_)),
        seven_(equation7(lettersOf(parameters_, Mapping::kPrinted))),
        output_(model, layout, parameters_, loads_) {}

  int channels() const override { return model_.inputs.channels; }
  StateLayout layout() const override { return model_.states; }
  const std::vector<Channel>& states() const override { return model_.state_channels; }
  const std::vector<Channel>& outputs() const override { return model_.outputs.channels(); }
  FlatVariant variant() const override { return variant_; }
  const FlatParameters& parameters() const override { return parameters_; }
  const FlatRhs* rhs() const override { return nullptr; }
  const std::array<int, 8>& stateOrder() const override { return order_.state; }
  const std::array<int, 4>& wheelOrder() const override { return order_.wheel; }
  std::optional<StateSpace> linear() const override { return unitResponses(*this); }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    const Inner inner = innerDerivative(x, u.first(8));
    order_.scatterState(inner.dx, dx);
  }

  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const override {
    const Inner inner = innerDerivative(x, u.first(8));
    std::array<double, 12> rail;
    order_.gatherRail(u, rail);
    output_.write(inner.x.data(), inner.dx.data(), rail.data(), y);
  }

 private:
  /// State, input and derivative counted from the front.
  struct Inner {
    std::array<double, 8> x;
    std::array<double, 8> u;
    std::array<double, 8> dx;
  };

  Inner innerDerivative(std::span<const double> x, std::span<const double> u) const {
    Inner inner;
    order_.gatherState(x, inner.x);
    order_.gatherRail(u, inner.u);
    if (variant_ == FlatVariant::kPrinted7) {
      seven(inner);
    } else {
      literal(inner, variant_ == FlatVariant::kLiteral ? paper_.inv_cb : paper_.inv_mb);
    }
    return inner;
  }

  void literal(Inner& inner, double inv_inertia_of_4) const {
    const auto& x = inner.x;
    const auto& u = inner.u;
    const FlatState<double> s{x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]};
    const FlatRail<double> rail{u[0], u[1], u[2], u[3], u[4], u[5], u[6], u[7]};
    inner.dx = {s.dzk,
                s.dphi,
                s.dz1,
                s.dz2,
                printedCarbodyBounce(paper_, s),
                printedCarbodyPitch(paper_, s),
                printedFrontBogieBounce(paper_, s, rail, inv_inertia_of_4),
                printedRearBogieBounce(paper_, s, rail)};
  }

  void seven(Inner& inner) const {
    // Place of (z1, z1', z2, z2', zk, zk', phi, phi') in the inner state.
    static constexpr std::array<std::size_t, 8> kPlace = {2, 6, 3, 7, 0, 4, 1, 5};
    for (std::size_t row = 0; row < 8; ++row) {
      double sum = 0.0;
      for (std::size_t col = 0; col < 8; ++col) {
        sum += seven_.A[row][col] * inner.x[kPlace[col]] + seven_.B[row][col] * inner.u[col];
      }
      inner.dx[kPlace[row]] = sum;
    }
  }

  CompiledModel model_;
  FlatVariant variant_;
  FlatOrder order_;
  FlatLoads loads_;
  FlatParameters parameters_;
  PaperCoefficients<double> paper_;
  Equation7 seven_;
  FlatOutput output_;
};

}  // namespace

std::unique_ptr<FlatForm> buildPrintedForm(const CompiledModel& model, const FlatLayout& layout, FlatVariant variant) {
  return std::make_unique<PrintedForm>(model, layout, variant);
}

}  // namespace vehicle
