#include "libvehicle/matrix/matrix_form.h"

#include <utility>
#include <vector>

#include "libvehicle/matrix/assembly.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Rows of A and B are walked from left to right at every evaluation.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;

class AssembledForm final : public MatrixForm {
 public:
  AssembledForm(Topology topology, double gravity)
      : topology_(std::move(topology)),
        rest_(restOf(topology_, gravity)),
        matrices_(assemble(topology_, rest_)),
        states_(stateChannels(topology_)),
        outputs_(resultChannels(topology_)) {
    const Eigen::Index n = topology_.coordinates;
    const Eigen::VectorXd inverse_mass = matrices_.M.diagonal().cwiseInverse();
    from_state_.resize(n, 2 * n);
    from_state_ << -(inverse_mass.asDiagonal() * matrices_.K), -(inverse_mass.asDiagonal() * matrices_.C);
    from_input_.resize(n, 2 * matrices_.B0.cols());
    from_input_ << inverse_mass.asDiagonal() * matrices_.B0, inverse_mass.asDiagonal() * matrices_.B1;
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
  const SecondOrder& matrices() const override { return matrices_; }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    const Eigen::Index n = topology_.coordinates;
    for (Eigen::Index i = 0; i < n; ++i) {
      dx[static_cast<std::size_t>(i)] = x[static_cast<std::size_t>(n + i)];
      dx[static_cast<std::size_t>(n + i)] = acceleration(i, x, u);
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
    const Eigen::Index n = topology_.coordinates;
    const Eigen::Index w = matrices_.B0.cols();
    StateSpace made{Eigen::MatrixXd::Zero(2 * n, 2 * n), Eigen::MatrixXd::Zero(2 * n, 2 * w)};
    made.A.topRightCorner(n, n).setIdentity();
    made.A.bottomRows(n) = from_state_;
    made.B.bottomRows(n) = from_input_;
    return made;
  }

 private:
  double acceleration(Eigen::Index i, std::span<const double> x, std::span<const double> u) const {
    // x and u may be longer than needed (accelerations of the rail behind): the maps take what the matrices have.
    return from_state_.row(i).dot(ConstVector(x.data(), from_state_.cols())) +
           from_input_.row(i).dot(ConstVector(u.data(), from_input_.cols()));
  }

  /// Displacement (order 0), velocity (1) or acceleration (2) of a coordinate; 0 where it does not move.
  double motion(int index, int order, std::span<const double> x, std::span<const double> u) const {
    if (index < 0) return 0.0;
    return order < 2 ? x[at(index + order * topology_.coordinates)] : acceleration(index, x, u);
  }

  /// Elongation (order 0) or its rate (1), dynamic part.
  double elongation(std::size_t s, std::span<const double> x, std::span<const double> u, int order) const {
    const Elongation& each = elongations_[s];
    const double bodies = each.row.dot(ConstVector(x.data() + order * topology_.coordinates, topology_.coordinates));
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
  SecondOrder matrices_;
  std::vector<Channel> states_;
  std::vector<Channel> outputs_;
  Rows from_state_;  // (N x 2 N) [-M^-1 K, -M^-1 C]
  Rows from_input_;  // (N x 2 w) [M^-1 B0, M^-1 B1]
  std::vector<Elongation> elongations_;              // (suspensions)
  std::vector<std::vector<int>> wheel_suspensions_;  // (wheelsets) those that stand on it
};

}  // namespace

std::unique_ptr<MatrixForm> buildMatrixForm(const Vehicle& vehicle, double gravity) {
  return std::make_unique<AssembledForm>(topologyOf(vehicle), gravity);
}

}  // namespace vehicle
