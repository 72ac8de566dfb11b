#include "libvehicle/mbs/mbs_form.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/law/linear_spring_damper.h"
#include "libvehicle/mbs/simbody_model.h"
#include "libvehicle/mbs/simbody_steps.h"

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

SimbodyLink linkOf(const CompiledModel& model, std::size_t index, const std::vector<int>& wheel_body) {
  const TopologySuspension& suspension = model.topology.suspensions[index];
  SimbodyLink link;
  link.law = model.laws[index];
  link.preload = model.rest.suspension_load[index];
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

Assembled assemble(const CompiledModel& model, MbsLaw law) {
  const Topology& topology = model.topology;
  const Rest& rest = model.rest;
  Assembled made;
  SimbodyAssembly& assembly = made.assembly;
  assembly.coordinates = model.states.coordinates;
  assembly.channels = model.inputs.channels;
  assembly.gravity = model.gravity;
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
    assembly.links.push_back(linkOf(model, i, made.wheel_body));
  }
  for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
    const TopologyWheelset& wheelset = topology.wheelsets[j];
    made.wheel_contact.push_back(wheelset.z_index >= 0 ? static_cast<int>(assembly.links.size()) : -1);
    if (wheelset.z_index < 0) continue;
    SimbodyLink contact;
    contact.law = std::make_shared<const LinearSpringDamper>(rest.contact_stiffness[j], wheelset.contact_damping);
    // What rests on the contact, not the wheelset's `load`: a load given by hand is what unloading refers to and
    // need not be in balance with the masses.
    contact.preload = wheelset.mass * model.gravity;
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
  SimbodyForm(const CompiledModel& model, MbsLaw law)
      : model_(model),
        law_(law),
        assembled_(assemble(model_, law)),
        acceleration_(at(model_.states.coordinates)),
        simbody_(std::make_unique<SimbodyModel>(assembled_.assembly)) {}

  int channels() const override { return model_.inputs.channels; }
  StateLayout layout() const override { return model_.states; }
  const std::vector<Channel>& states() const override { return model_.state_channels; }
  const std::vector<Channel>& outputs() const override { return model_.outputs.channels(); }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    const std::size_t n = at(model_.states.coordinates);
    std::copy_n(x.begin() + model_.states.rate(0), n, dx.begin());
    simbody_->accelerations(x.data(), u.data(), dx.data() + n);
  }

  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const override;
  std::optional<StateSpace> linear() const override;
  std::unique_ptr<Integrator> bySimbody(const RunProblem& problem, double accuracy) const override {
    return std::make_unique<SimbodySteps>(*simbody_, problem, accuracy);
  }

 private:
  double wheelLoad(std::size_t wheelset, double rail_acceleration) const;

  CompiledModel model_;
  MbsLaw law_;
  Assembled assembled_;
  mutable std::vector<double> acceleration_;  // [m/s^2, rad/s^2] (N) scratch
  std::unique_ptr<SimbodyModel> simbody_;     // scratch behind const: why one object serves one thread
};

/// [N] Q0 - what the links above pull (or the contact itself), plus m eta'' of a mass that follows the rail.
double SimbodyForm::wheelLoad(std::size_t wheelset, double rail_acceleration) const {
  const double static_load = model_.rest.wheel_load[wheelset];
  if (assembled_.wheel_contact[wheelset] >= 0) return static_load - simbody_->force(assembled_.wheel_contact[wheelset]);
  double pull = 0.0;
  for (std::size_t i = 0; i < model_.topology.suspensions.size(); ++i) {
    if (model_.topology.suspensions[i].lower_wheelset == static_cast<int>(wheelset)) {
      pull += simbody_->force(static_cast<int>(i));
    }
  }
  return static_load - pull + model_.topology.wheelsets[wheelset].mass * rail_acceleration;
}

void SimbodyForm::output(std::span<const double> x, std::span<const double> u, std::span<double> y) const {
  simbody_->accelerations(x.data(), u.data(), acceleration_.data());
  const auto put = [&](PartKind part, int index, Quantity quantity, double value) {
    y[at(model_.outputs.column(part, index, quantity))] = value;
  };
  const auto putHeight = [&](PartKind part, int index, int z) {
    if (z < 0) return;
    put(part, index, Quantity::kZ, x[at(z)]);
    put(part, index, Quantity::kZRate, x[at(model_.states.rate(z))]);
    put(part, index, Quantity::kZAcceleration, acceleration_[at(z)]);
  };
  for (int b = 0; b < static_cast<int>(model_.topology.bodies.size()); ++b) {
    putHeight(PartKind::kBody, b, model_.topology.bodies[at(b)].z_index);
    const int pitch = model_.topology.bodies[at(b)].pitch_index;
    if (pitch < 0) continue;
    put(PartKind::kBody, b, Quantity::kPitch, x[at(pitch)]);
    put(PartKind::kBody, b, Quantity::kPitchRate, x[at(model_.states.rate(pitch))]);
    put(PartKind::kBody, b, Quantity::kPitchAcceleration, acceleration_[at(pitch)]);
  }
  for (int s = 0; s < static_cast<int>(model_.topology.suspensions.size()); ++s) {
    put(PartKind::kSuspension, s, Quantity::kDeflection, simbody_->deflection(s));
    put(PartKind::kSuspension, s, Quantity::kForce, simbody_->force(s));
  }
  for (int j = 0; j < channels(); ++j) {
    put(PartKind::kWheelset, j, Quantity::kRailZ, u[at(j)]);
    putHeight(PartKind::kWheelset, j, model_.topology.wheelsets[at(j)].z_index);
    put(PartKind::kWheelset, j, Quantity::kLoad, wheelLoad(at(j), u[at(model_.inputs.acceleration(j))]));
  }
  for (int p = 0; p < static_cast<int>(model_.topology.points.size()); ++p) {
    const TopologyPoint& point = model_.topology.points[at(p)];
    const SimbodyMotion motion = simbody_->motion(point.body, point.arm);
    put(PartKind::kPoint, p, Quantity::kZ, motion.z);
    put(PartKind::kPoint, p, Quantity::kZRate, motion.vz);
    put(PartKind::kPoint, p, Quantity::kZAcceleration, motion.az);
  }
}

std::optional<StateSpace> SimbodyForm::linear() const {
  requireDense("mbs", size());
  if (law_ != MbsLaw::kLinear) return std::nullopt;
  // f(0, 0) = 0 and f is linear, so a unit vector gives a column without a difference: exact up to rounding.
  const Eigen::Index n = model_.states.size(), w = channels();
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

}  // namespace

std::unique_ptr<MbsForm> buildMbsForm(const CompiledModel& model, MbsLaw law) {
  return std::make_unique<SimbodyForm>(model, law);
}

}  // namespace vehicle
