#include "libvehicle/mbs/mbs_form.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/definition/topology.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/mbs/simbody_model.h"
#include "libvehicle/statics/rest.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// The vehicle in the words of the seam. Bodies come first, then the wheelsets that move on their own; links are
/// the suspensions, then the contacts of those wheelsets.
struct Assembled {
  SimbodyAssembly assembly;
  std::vector<int> wheel_body;     // (wheelsets) among the assembly's bodies; -1: follows the rail
  std::vector<int> wheel_contact;  // (wheelsets) among its links; -1: follows the rail
};

SimbodyLink linkOf(const TopologySuspension& suspension, double preload, const std::vector<int>& wheel_body) {
  SimbodyLink link;
  link.stiffness = suspension.stiffness;
  link.damping = suspension.damping;
  link.preload = preload;
  link.upper.body = suspension.upper;
  link.upper.arm = suspension.arm_upper;
  link.upper.height = suspension.height_upper;
  if (suspension.lower_body >= 0) {
    link.lower.body = suspension.lower_body;
    link.lower.arm = suspension.arm_lower;
    link.lower.height = suspension.height_lower;
  } else if (wheel_body[at(suspension.lower_wheelset)] >= 0) {
    link.lower.body = wheel_body[at(suspension.lower_wheelset)];
  } else {
    link.lower.channel = suspension.lower_wheelset;
  }
  return link;
}

Assembled assemble(const Topology& topology, const Rest& rest, double gravity, MbsLaw law) {
  Assembled made;
  SimbodyAssembly& assembly = made.assembly;
  assembly.coordinates = topology.coordinates;
  assembly.channels = static_cast<int>(topology.wheelsets.size());
  assembly.gravity = gravity;
  assembly.geometry = law == MbsLaw::kLinear ? SimbodyGeometry::kLinear : SimbodyGeometry::kTrue;
  for (std::size_t i = 0; i < topology.bodies.size(); ++i) {
    const TopologyBody& body = topology.bodies[i];
    assembly.bodies.push_back(
        {body.mass, body.pitch_inertia, body.x, body.z, body.z_index, body.pitch_index, rest.pitch_stiffness[i]});
  }
  for (const TopologyWheelset& wheelset : topology.wheelsets) {
    made.wheel_body.push_back(wheelset.z_index >= 0 ? static_cast<int>(assembly.bodies.size()) : -1);
    if (wheelset.z_index < 0) continue;
    assembly.bodies.push_back({wheelset.mass, 0.0, wheelset.x, wheelset.z, wheelset.z_index, -1, 0.0});
  }
  for (std::size_t i = 0; i < topology.suspensions.size(); ++i) {
    assembly.links.push_back(linkOf(topology.suspensions[i], rest.suspension_load[i], made.wheel_body));
  }
  for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
    const TopologyWheelset& wheelset = topology.wheelsets[j];
    made.wheel_contact.push_back(wheelset.z_index >= 0 ? static_cast<int>(assembly.links.size()) : -1);
    if (wheelset.z_index < 0) continue;
    SimbodyLink contact;
    contact.stiffness = rest.contact_stiffness[j];
    contact.damping = wheelset.contact_damping;
    // What rests on the contact, not the wheelset's `load`: a load given by hand is what unloading refers to and
    // need not be in balance with the masses.
    contact.preload = wheelset.mass * gravity;
    for (std::size_t i = 0; i < topology.suspensions.size(); ++i) {
      if (topology.suspensions[i].lower_wheelset == static_cast<int>(j)) contact.preload += rest.suspension_load[i];
    }
    contact.upper.body = made.wheel_body[j];
    contact.lower.channel = static_cast<int>(j);
    assembly.links.push_back(contact);
  }
  return made;
}

class SimbodyForm : public MbsForm {
 public:
  SimbodyForm(Topology topology, Rest rest, double gravity, MbsLaw law)
      : topology_(std::move(topology)),
        rest_(std::move(rest)),
        law_(law),
        assembled_(assemble(topology_, rest_, gravity, law)),
        states_(stateChannels(topology_)),
        outputs_(resultChannels(topology_)),
        acceleration_(at(topology_.coordinates)),
        model_(std::make_unique<SimbodyModel>(assembled_.assembly)) {}

  int channels() const override { return assembled_.assembly.channels; }
  const std::vector<Channel>& states() const override { return states_; }
  const std::vector<Channel>& outputs() const override { return outputs_; }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    const std::size_t n = at(topology_.coordinates);
    std::copy_n(x.begin() + topology_.coordinates, n, dx.begin());
    model_->accelerations(x.data(), u.data(), dx.data() + n);
  }

  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const override;
  std::optional<StateSpace> linear() const override;
  Statistics runSimbody(const Input& input, const Schedule& schedule, double accuracy, std::span<const double> x0,
                        const Observer& observe) const override;

 private:
  double wheelLoad(std::size_t wheelset, double rail_acceleration) const;
  void requireNumbers(double t, std::span<const double> x) const;

  Topology topology_;
  Rest rest_;
  MbsLaw law_;
  Assembled assembled_;
  std::vector<Channel> states_;
  std::vector<Channel> outputs_;
  mutable std::vector<double> acceleration_;  // [m/s^2, rad/s^2] (N) scratch
  std::unique_ptr<SimbodyModel> model_;       // scratch behind const: why one object serves one thread
};

/// [N] Q0 - what the links above pull (or the contact itself), plus m eta'' of a mass that follows the rail.
double SimbodyForm::wheelLoad(std::size_t wheelset, double rail_acceleration) const {
  const double static_load = rest_.wheel_load[wheelset];
  if (assembled_.wheel_contact[wheelset] >= 0) return static_load - model_->force(assembled_.wheel_contact[wheelset]);
  double pull = 0.0;
  for (std::size_t i = 0; i < topology_.suspensions.size(); ++i) {
    if (topology_.suspensions[i].lower_wheelset == static_cast<int>(wheelset)) {
      pull += model_->force(static_cast<int>(i));
    }
  }
  return static_load - pull + topology_.wheelsets[wheelset].mass * rail_acceleration;
}

void SimbodyForm::output(std::span<const double> x, std::span<const double> u, std::span<double> y) const {
  const std::size_t n = at(topology_.coordinates), w = topology_.wheelsets.size();
  model_->accelerations(x.data(), u.data(), acceleration_.data());
  std::size_t column = 0;
  const auto put = [&](double value) { y[column++] = value; };
  const auto put_each = [&](std::span<const double> from, int z_index, int pitch_index) {
    if (z_index >= 0) put(from[at(z_index)]);
    if (pitch_index >= 0) put(from[at(pitch_index)]);
  };
  for (const TopologyBody& body : topology_.bodies) {
    put_each(x.first(n), body.z_index, body.pitch_index);
    put_each(x.subspan(n, n), body.z_index, body.pitch_index);
    put_each(acceleration_, body.z_index, body.pitch_index);
  }
  for (std::size_t i = 0; i < topology_.suspensions.size(); ++i) {
    put(model_->deflection(static_cast<int>(i)));
    put(model_->force(static_cast<int>(i)));
  }
  for (std::size_t j = 0; j < w; ++j) {
    put(u[j]);
    const int z = topology_.wheelsets[j].z_index;
    put_each(x.first(n), z, -1);
    put_each(x.subspan(n, n), z, -1);
    put_each(acceleration_, z, -1);
    put(wheelLoad(j, u[2 * w + j]));
  }
  for (const TopologyPoint& point : topology_.points) {
    const SimbodyMotion motion = model_->motion(point.body, point.arm);
    put(motion.z);
    put(motion.vz);
    put(motion.az);
  }
}

std::optional<StateSpace> SimbodyForm::linear() const {
  requireDense("mbs", size());
  if (law_ != MbsLaw::kLinear) return std::nullopt;
  // f(0, 0) = 0 and f is linear, so a unit vector gives a column without a difference: exact up to rounding.
  const Eigen::Index n = 2 * topology_.coordinates, w = channels();
  StateSpace made{Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, 2 * w)};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n), u = Eigen::VectorXd::Zero(2 * w), dx(n);
  const auto column = [&](Eigen::VectorXd& probed, Eigen::Index i, Eigen::MatrixXd& into) {
    probed[i] = 1.0;
    derivative({x.data(), at(static_cast<int>(n))}, {u.data(), at(static_cast<int>(2 * w))},
               {dx.data(), at(static_cast<int>(n))});
    into.col(i) = dx;
    probed[i] = 0.0;
  };
  for (Eigen::Index i = 0; i < n; ++i) column(x, i, made.A);
  for (Eigen::Index i = 0; i < 2 * w; ++i) column(u, i, made.B);
  return made;
}

void SimbodyForm::requireNumbers(double t, std::span<const double> x) const {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isfinite(x[i])) continue;
    throw RunFailed(fmt::format("simbody_rkm: {} is {} at t = {} s", states_[i].name, x[i], t));
  }
}

Statistics SimbodyForm::runSimbody(const Input& input, const Schedule& schedule, double accuracy,
                                   std::span<const double> x0, const Observer& observe) const {
  if (!(accuracy > 0.0 && accuracy < 1.0)) {
    throw std::invalid_argument(fmt::format("simbody_rkm: accuracy = {}, must be > 0 and < 1", accuracy));
  }
  if (x0.size() != states_.size()) {
    throw std::invalid_argument(
        fmt::format("simbody_rkm: the initial state has {} numbers, must be {}", x0.size(), states_.size()));
  }
  if (input.channels() != channels()) {
    throw std::invalid_argument(
        fmt::format("simbody_rkm: the input has {} wheelsets, must be {}", input.channels(), channels()));
  }
  const Stretch start = schedule.stretches().front();
  int segment = start.segment;
  double reached = start.begin;
  const auto rail = [&input, &segment, size = 2 * at(channels())](double t, double* u) {
    input.evaluate(segment, t, {u, size});
  };
  // Only what Simbody throws is told as a failure of the integrator; an observer's exceptions pass untouched.
  const auto simbody = [&reached](const auto& call) {
    try {
      call();
    } catch (const std::exception& failure) {
      throw RunFailed(fmt::format("simbody_rkm: gave up after t = {} s: {}", reached, failure.what()));
    }
  };
  std::vector<double> x(x0.begin(), x0.end());
  requireNumbers(reached, x);
  Statistics statistics;
  simbody([&] { model_->startRun(accuracy, schedule.outputStep(), reached, x.data(), rail); });
  statistics.stopped = !observe(0, segment, reached, x);
  for (const Stretch stretch : schedule.stretches()) {
    if (statistics.stopped) break;
    if (stretch.segment != segment) {
      segment = stretch.segment;
      model_->passKink();
    }
    simbody([&] { model_->advanceTo(stretch.end); });
    reached = stretch.end;
    if (stretch.sample < 0) continue;
    model_->readState(x.data());
    requireNumbers(reached, x);
    statistics.stopped = !observe(stretch.sample, stretch.next, reached, x);
  }
  const SimbodyCost cost = model_->cost();
  statistics.steps = cost.steps;
  statistics.evaluations = cost.evaluations;
  statistics.rejected = cost.rejected;
  return statistics;
}

}  // namespace

std::unique_ptr<MbsForm> buildMbsForm(const Vehicle& vehicle, double gravity, MbsLaw law) {
  Topology topology = topologyOf(vehicle);
  Rest rest = restOf(topology, gravity);
  return std::make_unique<SimbodyForm>(std::move(topology), std::move(rest), gravity, law);
}

}  // namespace vehicle
