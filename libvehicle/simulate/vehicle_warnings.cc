#include "libvehicle/simulate/vehicle_warnings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "libvehicle/matrix/assembly.h"
#include "libvehicle/model/laws.h"
#include "libvehicle/model/topology_part.h"

namespace vehicle {

namespace {

// Below this share of the stiffest motion an eigenvalue of K is what rounding leaves of zero.
constexpr double kZeroStiffness = 1e-11;

std::size_t at(Eigen::Index index) { return static_cast<std::size_t>(index); }

struct Coordinate {
  std::string part;
  std::string motion;
  Origin origin;
};

std::vector<Coordinate> coordinatesOf(const Topology& topology) {
  std::vector<Coordinate> all(static_cast<std::size_t>(topology.coordinates));
  for (const TopologyBody& body : topology.bodies) {
    if (body.z_index >= 0) all[at(body.z_index)] = {body.name, "bounce", body.origin};
    if (body.pitch_index >= 0) all[at(body.pitch_index)] = {body.name, "pitch", body.origin};
  }
  for (const TopologyWheelset& wheelset : topology.wheelsets) {
    if (wheelset.z_index >= 0) all[at(wheelset.z_index)] = {wheelset.name, "bounce", wheelset.origin};
  }
  return all;
}

/// M^-1/2 K M^-1/2: its eigenvalues are squared frequencies, its vectors weigh metres and radians alike.
Eigen::MatrixXd normalisedStiffness(const Topology& topology, const Rest& rest) {
  const SparseSecondOrder matrices = assemble(topology, rest, lawsOf(topology));
  const auto n = static_cast<Eigen::Index>(matrices.mass.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const SecondOrderEntry& each : matrices.own[at(i)]) {
      stiffness(i, each.column) = each.stiffness / std::sqrt(matrices.mass[at(i)] * matrices.mass[at(each.column)]);
    }
  }
  return stiffness;
}

/// A soft motion of a part of the topology that holds together.
void addStance(const Topology& topology, const Rest& rest, Warnings& warnings) {
  if (topology.coordinates == 0) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(normalisedStiffness(topology, rest));
  const Eigen::VectorXd& squared = solver.eigenvalues();  // ascending
  const double zero = kZeroStiffness * squared.cwiseAbs().maxCoeff();
  const std::vector<Coordinate> coordinates = coordinatesOf(topology);
  for (Eigen::Index k = 0; k < squared.size() && squared(k) <= zero; ++k) {
    Eigen::Index leads = 0;
    solver.eigenvectors().col(k).cwiseAbs().maxCoeff(&leads);
    const Coordinate& coordinate = coordinates[at(leads)];
    Warning warning;
    warning.place = coordinate.origin;
    warning.subject = fmt::format("{} {}", coordinate.part, coordinate.motion);
    if (squared(k) < -zero) {
      const double rate = std::sqrt(-squared(k));
      warning.code = WarningCode::kCannotStand;
      warning.value = rate;
      warning.unit = std::string("1/s");
      warning.message = fmt::format(
          "the vehicle cannot stand: springs and heights leave a negative stiffness, a push doubles every {:.3g} s",
          std::numbers::ln2 / rate);
      warning.remedy = "lower the centre of gravity, or make its springs stiffer or wider apart";
    } else {
      warning.code = WarningCode::kFreeMode;
      warning.message = "nothing holds this motion: it has no stiffness and no rest position";
      warning.remedy = "give it a spring, or leave the motion out";
    }
    warnings.push_back(std::move(warning));
  }
}

/// A part of a topology that stands by itself, with its share of the rest.
Rest restOfPart(const TopologyPart& part, const Rest& rest) {
  Rest own;
  for (const int b : part.bodies) own.pitch_stiffness.push_back(rest.pitch_stiffness[at(b)]);
  for (const int j : part.wheelsets) {
    own.contact_stiffness.push_back(rest.contact_stiffness[at(j)]);
    own.wheel_load.push_back(rest.wheel_load[at(j)]);
  }
  return own;
}

void addGivenLoads(const TopologyPart& part, const Rest& rest, double gravity, Warnings& warnings) {
  double mass = 0.0, load = 0.0;
  const TopologyWheelset* given = nullptr;
  for (const TopologyBody& body : part.topology.bodies) mass += body.mass;
  for (std::size_t j = 0; j < part.wheelsets.size(); ++j) {
    const TopologyWheelset& wheelset = part.topology.wheelsets[j];
    mass += wheelset.mass;
    load += rest.wheel_load[j];
    if (wheelset.load && given == nullptr) given = &wheelset;
  }
  const double weight = mass * gravity;
  if (given == nullptr || std::abs(load - weight) <= kMostLoadError * weight) return;
  Warning warning;
  warning.code = WarningCode::kGivenLoads;
  warning.place = given->origin;
  warning.subject = given->name + ".load";
  warning.value = load - weight;
  warning.unit = std::string("N");
  warning.message =
      fmt::format("the wheel loads that the file gives sum to {:.5g} kN with the others, the weight is {:.5g} kN",
                  load / 1e3, weight / 1e3);
  warning.remedy = "give loads that carry the weight, or leave them out: statics finds them";
  warnings.push_back(std::move(warning));
}

void addRestDeflections(const Topology& topology, const Rest& rest, Warnings& warnings) {
  for (std::size_t s = 0; s < topology.suspensions.size(); ++s) {
    const TopologySuspension& suspension = topology.suspensions[s];
    if (!(suspension.stiffness > 0.0)) continue;
    const double deflection = rest.suspension_load[s] / suspension.stiffness;
    if (std::abs(deflection) <= kMostRestDeflection) continue;
    Warning warning;
    warning.code = WarningCode::kRestDeflection;
    warning.place = suspension.origin;
    warning.subject = suspension.name;
    warning.value = deflection;
    warning.unit = std::string("m");
    warning.message =
        fmt::format("comes down by {:.4g} mm at rest under {:.4g} kN; railway springs have less travel than {:g} mm",
                    1e3 * deflection, rest.suspension_load[s] / 1e3, 1e3 * kMostRestDeflection);
    warning.remedy = "look at its stiffness and at the masses that it carries";
    warnings.push_back(std::move(warning));
  }
}

/// Equal vehicles of a train come from one place of one file: the first of them stands for all.
Warnings eachPlaceOnce(Warnings warnings) {
  Warnings once;
  for (Warning& each : warnings) {
    const bool is_said =
        each.place.line > 0 && std::any_of(once.begin(), once.end(), [&](const Warning& other) {
          return other.code == each.code && other.place.line == each.place.line && other.place.file == each.place.file;
        });
    if (!is_said) once.push_back(std::move(each));
  }
  return once;
}

}  // namespace

Warnings restWarnings(const CompiledModel& model) {
  const Topology& topology = model.topology;
  const Rest& rest = model.rest;
  Warnings warnings;
  // Couplings carry no load and only add stiffness: a train stands where each of its vehicles does.
  std::vector<char> cut;
  for (const TopologySuspension& each : topology.suspensions) cut.push_back(each.preload == 0.0 ? 1 : 0);
  Warnings alone;
  std::vector<TopologyPart> parts = partsOf(topology, cut);
  for (const TopologyPart& part : parts) addStance(part.topology, restOfPart(part, rest), alone);
  if (!alone.empty() && parts.size() > 1) {
    // One of them does not: perhaps the couplings hold it.
    addStance(topology, rest, warnings);
  } else {
    warnings = std::move(alone);
  }
  for (const TopologyPart& part : parts) addGivenLoads(part, restOfPart(part, rest), model.gravity, warnings);
  addRestDeflections(topology, rest, warnings);
  return eachPlaceOnce(std::move(warnings));
}

Warnings motionWarnings(const MotionRates& rates, bool can_stand) {
  Warnings warnings;
  if (const double growth = rates.growth(); growth > 0.0 && can_stand) {
    Warning warning;
    warning.code = WarningCode::kUnstableMode;
    warning.value = growth;
    warning.unit = std::string("1/s");
    warning.message = fmt::format("a motion grows by itself, by e every {:.3g} s", 1.0 / growth);
    warning.remedy = "`vehicle modes` names it";
    warnings.push_back(std::move(warning));
  }
  // A slow motion is the small difference of terms as large as the fast one.
  constexpr double kVisible = 1e-6;
  const double rounding = std::numeric_limits<double>::epsilon() * rates.spread();
  if (rounding > kVisible) {
    Warning warning;
    warning.code = WarningCode::kIllConditioned;
    warning.value = rounding;
    warning.message =
        fmt::format("the fastest motion is {:.1e} times as fast as the slowest: rounding may reach {:.1e} of a result",
                    rates.spread(), rounding);
    warning.remedy = "look for a stiffness or damping that is many powers of ten too large";
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace vehicle
