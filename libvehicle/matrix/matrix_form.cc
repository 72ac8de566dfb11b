#include "libvehicle/matrix/matrix_form.h"

#include <utility>
#include <vector>

#include "libvehicle/matrix/assembly.h"
#include "libvehicle/matrix/matrix_equation_set.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

class AssembledForm final : public MatrixForm {
 public:
  AssembledForm(Topology topology, double gravity)
      : topology_(std::move(topology)),
        rest_(restOf(topology_, gravity)),
        matrices_(assemble(topology_, rest_)),
        equations_(topology_, matrices_),
        states_(stateChannels(topology_)),
        outputs_(resultChannels(topology_)) {
    for (const TopologySuspension& suspension : topology_.suspensions) {
      elongations_.push_back(elongationOf(suspension, topology_));
    }
    wheel_suspensions_.resize(topology_.wheelsets.size());
    for (std::size_t s = 0; s < topology_.suspensions.size(); ++s) {
      const int wheelset = topology_.suspensions[s].lower_wheelset;
      if (wheelset >= 0) wheel_suspensions_[at(wheelset)].push_back(static_cast<int>(s));
    }
  }

  int channels() const override { return static_cast<int>(topology_.wheelsets.size()); }
  const std::vector<Channel>& states() const override { return states_; }
  const std::vector<Channel>& outputs() const override { return outputs_; }
  const EquationSet* equations() const override { return &equations_; }
  SecondOrder matrices() const override {
    requireDense("matrix", size());
    return withZeros(matrices_, channels());
  }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    const int n = topology_.coordinates;
    for (int i = 0; i < n; ++i) {
      dx[at(i)] = x[at(n + i)];
      dx[at(n + i)] = equations_.acceleration(i, x.data(), u.data());
    }
  }

  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const override {
    auto next = y.begin();
    const auto put = [&next](double value) { *next++ = value; };
    for (const TopologyBody& body : topology_.bodies) putBody(body, x, u, put);
    for (std::size_t s = 0; s < topology_.suspensions.size(); ++s) {
      put(elongation(s, x, u, 0));
      put(force(s, x, u));
    }
    for (std::size_t j = 0; j < topology_.wheelsets.size(); ++j) putWheelset(j, x, u, put);
    for (const TopologyPoint& point : topology_.points) {
      for (int order = 0; order < 3; ++order) {
        const TopologyBody& body = topology_.bodies[at(point.body)];
        put(motion(body.z_index, order, x, u) + point.arm * motion(body.pitch_index, order, x, u));
      }
    }
  }

  std::optional<StateSpace> linear() const override {
    const SecondOrder dense = matrices();
    const Eigen::Index n = topology_.coordinates;
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
  double motion(int index, int order, std::span<const double> x, std::span<const double> u) const {
    if (index < 0) return 0.0;
    return order < 2 ? x[at(index + order * topology_.coordinates)]
                     : equations_.acceleration(index, x.data(), u.data());
  }

  /// Elongation (order 0) or its rate (1), dynamic part.
  double elongation(std::size_t s, std::span<const double> x, std::span<const double> u, int order) const {
    const Elongation& each = elongations_[s];
    const double* q = x.data() + order * topology_.coordinates;
    double bodies = 0.0;
    for (int i = 0; i < each.count; ++i) bodies += each.terms[at(i)].arm * q[each.terms[at(i)].q];
    return each.channel < 0 ? bodies : bodies - u[at(each.channel + order * channels())];
  }

  double force(std::size_t s, std::span<const double> x, std::span<const double> u) const {
    return topology_.suspensions[s].stiffness * elongation(s, x, u, 0) +
           topology_.suspensions[s].damping * elongation(s, x, u, 1);
  }

  template <class Put>
  void putBody(const TopologyBody& body, std::span<const double> x, std::span<const double> u, const Put& put) const {
    for (int order = 0; order < 3; ++order) {
      if (body.z_index >= 0) put(motion(body.z_index, order, x, u));
      if (body.pitch_index >= 0) put(motion(body.pitch_index, order, x, u));
    }
  }

  template <class Put>
  void putWheelset(std::size_t j, std::span<const double> x, std::span<const double> u, const Put& put) const {
    const TopologyWheelset& wheelset = topology_.wheelsets[j];
    const std::size_t w = topology_.wheelsets.size();
    put(u[j]);
    if (wheelset.z_index >= 0) {
      for (int order = 0; order < 3; ++order) put(motion(wheelset.z_index, order, x, u));
      put(rest_.wheel_load[j] + rest_.contact_stiffness[j] * (u[j] - motion(wheelset.z_index, 0, x, u)) +
          wheelset.contact_damping * (u[w + j] - motion(wheelset.z_index, 1, x, u)));
      return;
    }
    // Newton for the wheelset: load - static load + forces = m eta''. An elongated suspension lifts it.
    double load = rest_.wheel_load[j] + wheelset.mass * u[2 * w + j];
    for (const int s : wheel_suspensions_[j]) load -= force(at(s), x, u);
    put(load);
  }

  Topology topology_;
  Rest rest_;
  SparseSecondOrder matrices_;
  MatrixEquationSet equations_;
  std::vector<Channel> states_;
  std::vector<Channel> outputs_;
  std::vector<Elongation> elongations_;              // (suspensions)
  std::vector<std::vector<int>> wheel_suspensions_;  // (wheelsets) those that stand on it
};

}  // namespace

std::unique_ptr<MatrixForm> buildMatrixForm(const Vehicle& vehicle, double gravity) {
  return std::make_unique<AssembledForm>(topologyOf(vehicle), gravity);
}

}  // namespace vehicle
