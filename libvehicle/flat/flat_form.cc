#include "libvehicle/flat/flat_form.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/flat/first_order.h"
#include "libvehicle/flat/flat_equation_set.h"
#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/flat/flat_output.h"
#include "libvehicle/flat/flat_statics.h"
#include "libvehicle/flat/printed_variants.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// The paper's letters of a symmetric vehicle.
PaperCoefficients<double> paperCoefficients(const FlatParameters& v) {
  return {.inv_mk = 1.0 / v.mk, .inv_Jk = 1.0 / v.Jk, .inv_mb = 1.0 / v.m1, .inv_cb = 1.0 / v.cp[0],
          .ak = v.lf, .ck = v.cs1, .bk = v.bs1, .cb = v.cp[0], .bb = v.bp[0]};
}

class PaperForm final : public FlatForm {
 public:
  PaperForm(const Topology& topology, const FlatLayout& layout, double gravity, FlatVariant variant)
      : variant_(variant),
        loads_(flatLoads(topology, layout, gravity)),
        parameters_(flatParameters(topology, layout, loads_)),
        rhs_(parameters_),
        paper_(paperCoefficients(parameters_)),
        seven_(equation7(lettersOf(parameters_, Mapping::kPrinted))),
        states_(stateChannels(topology)),
        outputs_(resultChannels(topology)),
        output_(topology, resultPlacesOf(topology), layout, parameters_, loads_) {
    const TopologyBody& carbody = topology.bodies[at(layout.carbody)];
    const std::array<int, 4> place = {carbody.z_index, carbody.pitch_index,
                                      topology.bodies[at(layout.bogie[0])].z_index,
                                      topology.bodies[at(layout.bogie[1])].z_index};
    for (std::size_t i = 0; i < 4; ++i) {
      state_order_[i] = place[i];
      state_order_[i + 4] = place[i] + 4;
      wheel_order_[i] = layout.wheelset[i];
    }
    if (variant_ == FlatVariant::kConsistent) {
      std::vector<int> cut_order;
      for (std::size_t i = 0; i < 4; ++i) cut_order.insert(cut_order.end(), {state_order_[i], state_order_[i + 4]});
      const FlatBodyNames names = {carbody.name, topology.bodies[at(layout.bogie[0])].name,
                                   topology.bodies[at(layout.bogie[1])].name};
      equations_.emplace(std::vector{parameters_}, std::vector<FlatCoupling>{}, std::vector{names},
                         std::move(cut_order), std::vector<int>(wheel_order_.begin(), wheel_order_.end()));
    }
  }

  int channels() const override { return 4; }
  const std::vector<Channel>& states() const override { return states_; }
  const std::vector<Channel>& outputs() const override { return outputs_; }
  FlatVariant variant() const override { return variant_; }
  const FlatParameters& parameters() const override { return parameters_; }
  const FlatRhs* rhs() const override { return variant_ == FlatVariant::kConsistent ? &rhs_ : nullptr; }
  const std::array<int, 8>& stateOrder() const override { return state_order_; }
  const std::array<int, 4>& wheelOrder() const override { return wheel_order_; }
  const EquationSet* equations() const override { return equations_ ? &*equations_ : nullptr; }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    const Inner inner = innerDerivative(x, u);
    for (std::size_t i = 0; i < 8; ++i) dx[at(state_order_[i])] = inner.dx[i];
  }

  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const override {
    const Inner inner = innerDerivative(x, u);
    std::array<double, 12> rail;
    std::copy(inner.u.begin(), inner.u.end(), rail.begin());
    for (std::size_t i = 0; i < 4; ++i) rail[8 + i] = u[8 + at(wheel_order_[i])];
    output_.write(inner.x.data(), inner.dx.data(), rail.data(), y);
  }

  std::optional<StateSpace> linear() const override {
    // The equations have no constant term, so the answer to a unit vector is a column of the matrices, exactly.
    StateSpace matrices{Eigen::MatrixXd(8, 8), Eigen::MatrixXd(8, 8)};
    const std::array<double, 8> zero{};
    for (Eigen::Index i = 0; i < 8; ++i) {
      std::array<double, 8> unit{};
      unit[static_cast<std::size_t>(i)] = 1.0;
      derivative(unit, zero, {matrices.A.col(i).data(), 8});
      derivative(zero, unit, {matrices.B.col(i).data(), 8});
    }
    return matrices;
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
    for (std::size_t i = 0; i < 8; ++i) inner.x[i] = x[at(state_order_[i])];
    for (std::size_t i = 0; i < 4; ++i) {
      inner.u[i] = u[at(wheel_order_[i])];
      inner.u[i + 4] = u[at(wheel_order_[i]) + 4];
    }
    switch (variant_) {
      case FlatVariant::kConsistent:
        rhs_(inner.x.data(), inner.u.data(), inner.dx.data());
        break;
      case FlatVariant::kPrinted7:
        printedSeven(inner);
        break;
      case FlatVariant::kLiteral:
        literal(inner, paper_.inv_cb);
        break;
      case FlatVariant::kLiteralMb:
        literal(inner, paper_.inv_mb);
        break;
    }
    return inner;
  }

  void literal(Inner& inner, double inv_inertia_of_4) const {
    const auto& x = inner.x;
    const auto& u = inner.u;
    const FlatState<double> s{x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]};
    const FlatRail<double> rail{u[0], u[1], u[2], u[3], u[4], u[5], u[6], u[7]};
    inner.dx = {s.dzk, s.dphi, s.dz1, s.dz2, printedCarbodyBounce(paper_, s), printedCarbodyPitch(paper_, s),
                printedFrontBogieBounce(paper_, s, rail, inv_inertia_of_4), printedRearBogieBounce(paper_, s, rail)};
  }

  void printedSeven(Inner& inner) const {
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

  FlatVariant variant_;
  FlatLoads loads_;
  FlatParameters parameters_;
  FlatRhs rhs_;
  PaperCoefficients<double> paper_;
  Equation7 seven_;
  std::vector<Channel> states_;
  std::vector<Channel> outputs_;
  std::array<int, 8> state_order_{};
  std::array<int, 4> wheel_order_{};
  std::optional<FlatEquationSet> equations_;  // of the consistent variant
  FlatOutput output_;
};

}  // namespace

ProblemList flatMisfits(const Vehicle& vehicle, FlatVariant variant) {
  ProblemList problems = check(vehicle);
  if (!problems.empty()) return problems;
  if (vehicle.units.size() > 1 && variant != FlatVariant::kConsistent) {
    problems.add({vehicle.origin, "<train name=\"" + vehicle.name + "\">",
                  "is a train; the printed equations are of one vehicle", "take the form flat"});
    return problems;
  }
  const Topology topology = topologyOf(vehicle);
  const FlatReading reading = readLayout(vehicle, topology);
  problems.append(reading.problems);
  if (problems.empty() && variant != FlatVariant::kConsistent) {
    problems.append(asymmetries(vehicle, topology, reading.layout));
  }
  return problems;
}

std::unique_ptr<FlatForm> buildFlatForm(const Vehicle& vehicle, double gravity, FlatVariant variant) {
  ProblemList problems = flatMisfits(vehicle, variant);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  const Topology topology = topologyOf(vehicle);
  return std::make_unique<PaperForm>(topology, readLayout(vehicle, topology).layout, gravity, variant);
}

}  // namespace vehicle
