#include "libvehicle/matrix/matrix_form.h"

#include <array>
#include <vector>

#include "libvehicle/matrix/assembly.h"
#include "libvehicle/matrix/matrix_equation_set.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

class AssembledForm final : public MatrixForm {
 public:
  explicit AssembledForm(const CompiledModel& model)
      : model_(model), matrices_(assemble(model.topology, model.rest, model.laws)), equations_(model, matrices_) {
    const Topology& topology = model_.topology;
    for (const TopologySuspension& suspension : topology.suspensions) {
      elongations_.push_back(elongationOf(suspension, topology));
    }
    wheel_suspensions_.resize(topology.wheelsets.size());
    for (std::size_t s = 0; s < topology.suspensions.size(); ++s) {
      const int wheelset = topology.suspensions[s].lower_wheelset;
      if (wheelset >= 0) wheel_suspensions_[at(wheelset)].push_back(static_cast<int>(s));
    }
  }

  int channels() const override { return model_.inputs.channels; }
  StateLayout layout() const override { return model_.states; }
  const std::vector<Channel>& states() const override { return model_.state_channels; }
  const std::vector<Channel>& outputs() const override { return model_.outputs.channels(); }
  const EquationSet* equations() const override { return &equations_; }
  SecondOrder matrices() const override {
    requireDense("matrix", size());
    return withZeros(matrices_, channels());
  }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    for (int i = 0; i < model_.states.coordinates; ++i) {
      const std::size_t rate = at(model_.states.rate(i));
      dx[at(i)] = x[rate];
      dx[rate] = equations_.acceleration(i, x.data(), u.data());
    }
  }

  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const override {
    const Motion motion{*this, x, u};
    for (std::size_t b = 0; b < model_.topology.bodies.size(); ++b) putBody(static_cast<int>(b), motion, y);
    for (std::size_t s = 0; s < model_.topology.suspensions.size(); ++s) {
      const int suspension = static_cast<int>(s);
      put(PartKind::kSuspension, suspension, Quantity::kDeflection, elongation(s, x, u, 0), y);
      put(PartKind::kSuspension, suspension, Quantity::kForce, force(s, x, u), y);
    }
    for (std::size_t j = 0; j < model_.topology.wheelsets.size(); ++j) putWheelset(j, motion, y);
    for (std::size_t p = 0; p < model_.topology.points.size(); ++p) putPoint(static_cast<int>(p), motion, y);
  }

  std::optional<StateSpace> linear() const override {
    const SecondOrder dense = matrices();
    const Eigen::Index n = model_.states.coordinates;
    const Eigen::Index w = dense.B0.cols();
    const Eigen::VectorXd inverse_mass = dense.M.diagonal().cwiseInverse();
    StateSpace made{Eigen::MatrixXd::Zero(2 * n, 2 * n), Eigen::MatrixXd::Zero(2 * n, 2 * w)};
    made.A.topRightCorner(n, n).setIdentity();
    made.A.bottomRows(n) << -(inverse_mass.asDiagonal() * dense.K), -(inverse_mass.asDiagonal() * dense.C);
    made.B.bottomRows(n) << inverse_mass.asDiagonal() * dense.B0, inverse_mass.asDiagonal() * dense.B1;
    return made;
  }

 private:
  /// Displacement (order 0), velocity (1) or acceleration (2) of a coordinate; 0 where it does not move.
  struct Motion {
    const AssembledForm& form;
    std::span<const double> x;
    std::span<const double> u;
    double operator()(int index, int order) const {
      if (index < 0) return 0.0;
      if (order == 2) return form.equations_.acceleration(index, x.data(), u.data());
      return x[at(order == 0 ? index : form.model_.states.rate(index))];
    }
  };

  static constexpr std::array kHeights = {Quantity::kZ, Quantity::kZRate, Quantity::kZAcceleration};
  static constexpr std::array kPitches = {Quantity::kPitch, Quantity::kPitchRate, Quantity::kPitchAcceleration};

  void put(PartKind part, int index, Quantity quantity, double value, std::span<double> y) const {
    y[at(model_.outputs.column(part, index, quantity))] = value;
  }

  /// Elongation (order 0) or its rate (1), dynamic part.
  double elongation(std::size_t s, std::span<const double> x, std::span<const double> u, int order) const {
    const Elongation& each = elongations_[s];
    const double* q = x.data() + (order == 0 ? 0 : model_.states.rate(0));
    double bodies = 0.0;
    for (int i = 0; i < each.count; ++i) bodies += each.terms[at(i)].arm * q[each.terms[at(i)].q];
    if (each.channel < 0) return bodies;
    return bodies - u[at(order == 0 ? each.channel : model_.inputs.rate(each.channel))];
  }

  double force(std::size_t s, std::span<const double> x, std::span<const double> u) const {
    return model_.laws[s]->force({.elongation = elongation(s, x, u, 0), .rate = elongation(s, x, u, 1)});
  }

  void putBody(int index, const Motion& motion, std::span<double> y) const {
    const TopologyBody& body = model_.topology.bodies[at(index)];
    for (int order = 0; order < 3; ++order) {
      if (body.z_index >= 0) put(PartKind::kBody, index, kHeights[at(order)], motion(body.z_index, order), y);
      if (body.pitch_index >= 0) put(PartKind::kBody, index, kPitches[at(order)], motion(body.pitch_index, order), y);
    }
  }

  void putPoint(int index, const Motion& motion, std::span<double> y) const {
    const TopologyPoint& point = model_.topology.points[at(index)];
    const TopologyBody& body = model_.topology.bodies[at(point.body)];
    for (int order = 0; order < 3; ++order) {
      const double value = motion(body.z_index, order) + point.arm * motion(body.pitch_index, order);
      put(PartKind::kPoint, index, kHeights[at(order)], value, y);
    }
  }

  void putWheelset(std::size_t j, const Motion& motion, std::span<double> y) const {
    const TopologyWheelset& wheelset = model_.topology.wheelsets[j];
    const int index = static_cast<int>(j);
    const std::span<const double> u = motion.u;
    put(PartKind::kWheelset, index, Quantity::kRailZ, u[j], y);
    if (wheelset.z_index >= 0) {
      for (int order = 0; order < 3; ++order) {
        put(PartKind::kWheelset, index, kHeights[at(order)], motion(wheelset.z_index, order), y);
      }
      put(PartKind::kWheelset, index, Quantity::kLoad,
          model_.rest.wheel_load[j] + model_.rest.contact_stiffness[j] * (u[j] - motion(wheelset.z_index, 0)) +
              wheelset.contact_damping * (u[at(model_.inputs.rate(index))] - motion(wheelset.z_index, 1)),
          y);
      return;
    }
    // Newton for the wheelset: load - static load + forces = m eta''. An elongated suspension lifts it.
    double load = model_.rest.wheel_load[j] + wheelset.mass * u[at(model_.inputs.acceleration(index))];
    for (const int s : wheel_suspensions_[j]) load -= force(at(s), motion.x, u);
    put(PartKind::kWheelset, index, Quantity::kLoad, load, y);
  }

  CompiledModel model_;
  SparseSecondOrder matrices_;
  MatrixEquationSet equations_;
  std::vector<Elongation> elongations_;              // (suspensions)
  std::vector<std::vector<int>> wheel_suspensions_;  // (wheelsets) those that stand on it
};

}  // namespace

std::unique_ptr<MatrixForm> buildMatrixForm(const CompiledModel& model) {
  return std::make_unique<AssembledForm>(model);
}

}  // namespace vehicle
