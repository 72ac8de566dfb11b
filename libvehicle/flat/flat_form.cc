#include "libvehicle/flat/flat_form.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/flat/first_order.h"
#include "libvehicle/flat/flat_equation_set.h"
#include "libvehicle/flat/flat_layout.h"
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

/// Columns of a result where each part's first number stands; the others follow as resultChannels() says.
struct Columns {
  int carbody = 0;
  std::array<int, 2> bogie{};
  std::array<int, 2> secondary{};
  std::array<int, 4> primary{};
  std::array<int, 4> wheelset{};
};

/// A measuring point: z + arm phi of its body.
struct PointPlace {
  int column = 0;
  int inner = 0;     // inner coordinate of the body's z: 0 carbody, 2 front, 3 rear bogie
  double arm = 0.0;  // [m] 0 on a bogie, which does not pitch
};

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
        outputs_(resultChannels(topology)) {
    const TopologyBody& carbody = topology.bodies[at(layout.carbody)];
    const std::array<int, 4> place = {carbody.z_index, carbody.pitch_index,
                                      topology.bodies[at(layout.bogie[0])].z_index,
                                      topology.bodies[at(layout.bogie[1])].z_index};
    for (std::size_t i = 0; i < 4; ++i) {
      state_order_[i] = place[i];
      state_order_[i + 4] = place[i] + 4;
      wheel_order_[i] = layout.wheelset[i];
      wheelset_mass_[i] = topology.wheelsets[at(layout.wheelset[i])].mass;
    }
    if (variant_ == FlatVariant::kConsistent) {
      std::vector<int> cut_order;
      for (std::size_t i = 0; i < 4; ++i) cut_order.insert(cut_order.end(), {state_order_[i], state_order_[i + 4]});
      const FlatBodyNames names = {carbody.name, topology.bodies[at(layout.bogie[0])].name,
                                   topology.bodies[at(layout.bogie[1])].name};
      equations_.emplace(std::vector{parameters_}, std::vector<FlatCoupling>{}, std::vector{names},
                         std::move(cut_order), std::vector<int>(wheel_order_.begin(), wheel_order_.end()));
    }
    columns_.carbody = column(carbody.name + ".z");
    for (std::size_t i = 0; i < 2; ++i) {
      columns_.bogie[i] = column(topology.bodies[at(layout.bogie[i])].name + ".z");
      columns_.secondary[i] = column(topology.suspensions[at(layout.secondary[i])].name + ".deflection");
    }
    for (std::size_t i = 0; i < 4; ++i) {
      columns_.primary[i] = column(topology.suspensions[at(layout.primary[i])].name + ".deflection");
      columns_.wheelset[i] = column(topology.wheelsets[at(layout.wheelset[i])].name + ".rail_z");
    }
    for (const TopologyPoint& point : topology.points) {
      const bool on_carbody = point.body == layout.carbody;
      points_.push_back({column(point.name + ".z"), on_carbody ? 0 : point.body == layout.bogie[0] ? 2 : 3,
                         on_carbody ? point.arm : 0.0});
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
    const auto& [zk, phi, z1, z2, dzk, dphi, dz1, dz2] = inner.x;
    const std::array<double, 4> eta = {inner.u[0], inner.u[1], inner.u[2], inner.u[3]};
    const std::array<double, 4> deta = {inner.u[4], inner.u[5], inner.u[6], inner.u[7]};
    const FlatParameters& v = parameters_;

    writeFrom(y, columns_.carbody, {zk, phi, dzk, dphi, inner.dx[4], inner.dx[5]});
    writeFrom(y, columns_.bogie[0], {z1, dz1, inner.dx[6]});
    writeFrom(y, columns_.bogie[1], {z2, dz2, inner.dx[7]});

    const double front = zk + v.lf * phi - z1;
    const double rear = zk - v.lr * phi - z2;
    writeFrom(y, columns_.secondary[0], {front, v.cs1 * front + v.bs1 * (dzk + v.lf * dphi - dz1)});
    writeFrom(y, columns_.secondary[1], {rear, v.cs2 * rear + v.bs2 * (dzk - v.lr * dphi - dz2)});
    for (std::size_t wheel = 0; wheel < 4; ++wheel) {
      const double elongation = (wheel < 2 ? z1 : z2) - eta[wheel];
      const double force = v.cp[wheel] * elongation + v.bp[wheel] * ((wheel < 2 ? dz1 : dz2) - deta[wheel]);
      writeFrom(y, columns_.primary[wheel], {elongation, force});
      // Newton for the wheelset: load - static load + force = m eta''.
      const double rail_acceleration = u[8 + at(wheel_order_[wheel])];
      writeFrom(y, columns_.wheelset[wheel],
                {eta[wheel], loads_.wheel[wheel] - force + wheelset_mass_[wheel] * rail_acceleration});
    }
    for (const PointPlace& point : points_) {
      const std::size_t z = at(point.inner);
      writeFrom(y, point.column, {inner.x[z] + point.arm * phi, inner.x[z + 4] + point.arm * dphi,
                                  inner.dx[z + 4] + point.arm * inner.dx[5]});
    }
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

  int column(const std::string& name) const {
    const auto found = std::find_if(outputs_.begin(), outputs_.end(), [&](const Channel& c) { return c.name == name; });
    assert(found != outputs_.end());  // resultChannels() names every part of the topology
    return static_cast<int>(found - outputs_.begin());
  }

  static void writeFrom(std::span<double> y, int column, std::initializer_list<double> values) {
    std::copy(values.begin(), values.end(), y.begin() + column);
  }

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
  std::array<double, 4> wheelset_mass_{};  // [kg] in inner order
  std::optional<FlatEquationSet> equations_;  // of the consistent variant
  Columns columns_;
  std::vector<PointPlace> points_;
};

}  // namespace

ProblemList flatMisfits(const Vehicle& vehicle, FlatVariant variant) {
  ProblemList problems = check(vehicle);
  if (!problems.empty()) return problems;
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
