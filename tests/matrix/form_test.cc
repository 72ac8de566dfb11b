// The matrix form as a System: columns, action and reaction, orders, refusals.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/matrix/matrix_form.h"
#include "libvehicle/model/layout.h"
#include "libvehicle/model/topology.h"
#include "tests/support/allocations.h"
#include "tests/support/columns.h"
#include "tests/support/random_state.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

std::vector<Vehicle> allVehicles() {
  return {paperVehicle(),   asymmetricVehicle(), bogiePitchVehicle(), asymmetricBogiePitchVehicle(),
          contactVehicle(), hertzVehicle()};
}

std::vector<RandomState> statesFor(const System& form, int count) {
  return randomStates(count, static_cast<std::size_t>(form.size()), static_cast<std::size_t>(form.channels()));
}

TEST(MatrixForm, NamesStatesAndColumnsAsEveryForm) {
  for (const Vehicle& vehicle : allVehicles()) {
    const auto form = buildMatrixForm(compile(vehicle, kGravity));
    EXPECT_EQ(form->states(), stateChannels(topologyOf(vehicle)));
    EXPECT_EQ(form->outputs(), resultChannels(topologyOf(vehicle)));
    EXPECT_EQ(form->channels(), 4);
    const Columns y(*form, std::vector<double>(form->states().size(), 0.1), std::vector<double>(12, 0.1));
    for (const double each : y.all()) EXPECT_FALSE(std::isnan(each));
  }
}

// Newton and Euler for every body and wheelset, from the columns alone: what the suspensions say is what moves them.
TEST(MatrixColumns, SuspensionForcesAreThoseThatAccelerateTheBodies) {
  for (const Vehicle& vehicle : allVehicles()) {
    const auto form = buildMatrixForm(compile(vehicle, kGravity));
    const Topology topology = topologyOf(vehicle);
    const Columns rest(*form, std::vector<double>(form->states().size(), 0.0), std::vector<double>(12, 0.0));
    for (const RandomState& state : statesFor(*form, 100)) {
      const Columns y(*form, state.x, state.u);
      // Contacts carry up to 1e7 N, arms are up to 10 m: roundings of these.
      const double rounding = topology.wheelsets[0].z_index < 0 ? 1e-9 : 1e-7;
      for (std::size_t b = 0; b < topology.bodies.size(); ++b) {
        const TopologyBody& body = topology.bodies[b];
        double force = 0.0;
        double moment = 0.0;
        for (const TopologySuspension& suspension : topology.suspensions) {
          const double pull = y[suspension.name + ".force"];
          if (suspension.upper == static_cast<int>(b)) {
            force -= pull;
            moment -= pull * suspension.arm_upper;
          }
          if (suspension.lower_body == static_cast<int>(b)) {
            force += pull;
            moment += pull * suspension.arm_lower;
          }
        }
        EXPECT_WITHIN(body.mass * y[body.name + ".az"], force, rounding) << vehicle.name << ' ' << body.name;
        if (body.pitch_index < 0) continue;
        EXPECT_WITHIN(body.pitch_inertia * y[body.name + ".pitch_acc"], moment, 10 * rounding)
            << vehicle.name << ' ' << body.name;
      }
      for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
        const TopologyWheelset& wheelset = topology.wheelsets[j];
        double force = y[wheelset.name + ".load"] - rest[wheelset.name + ".load"];
        for (const TopologySuspension& suspension : topology.suspensions) {
          if (suspension.lower_wheelset == static_cast<int>(j)) force += y[suspension.name + ".force"];
        }
        const double acceleration = wheelset.z_index < 0 ? state.u[8 + j] : y[wheelset.name + ".az"];
        EXPECT_WITHIN(wheelset.mass * acceleration, force, rounding) << vehicle.name << ' ' << wheelset.name;
      }
    }
  }
}

TEST(MatrixColumns, OfAContactAreItsCompressionTimesItsStiffness) {
  const auto form = buildMatrixForm(compile(contactVehicle(), kGravity));
  std::vector<double> x(20, 0.0), u(12, 0.0);
  x[6] = -2e-5;   // wheelset_1.z: 20 um into the rail
  x[16] = -1e-2;  // wheelset_1.vz
  u[0] = 1e-5;    // the rail comes up by 10 um
  u[4] = 3e-2;
  const Columns y(*form, x, u);
  const double q0 = (32e3 / 4 + 2615.0 / 2 + 1813.0) * kGravity;
  EXPECT_WITHIN(y["wheelset_1.load"], q0 + 2.4e9 * 3e-5 + 20e3 * 4e-2, 1e-9);
  EXPECT_EQ(y["wheelset_1.rail_z"], 1e-5);
  EXPECT_EQ(y["wheelset_1.z"], -2e-5);
  // The primary above intervals by what the wheelset went down.
  EXPECT_WITHIN(y["primary_1.deflection"], 2e-5, 1e-20);
  EXPECT_WITHIN(y["primary_1.force"], 2440e3 * 2e-5 + 8e3 * 1e-2, 1e-12);
}

TEST(MatrixColumns, OfAPointFollowItsPitchingBody) {
  Vehicle vehicle = bogiePitchVehicle();
  Point tip;
  tip.name = "tip";
  tip.body = "front_bogie";
  tip.x = 11.5;  // 2 m ahead of the bogie's CG
  vehicle.points = {tip};
  const auto form = buildMatrixForm(compile(vehicle, kGravity));
  const RandomState state = statesFor(*form, 1).front();
  const Columns y(*form, state.x, state.u);
  EXPECT_WITHIN(y["tip.z"], y["front_bogie.z"] + 2.0 * y["front_bogie.pitch"], 1e-17);
  EXPECT_WITHIN(y["tip.vz"], y["front_bogie.vz"] + 2.0 * y["front_bogie.pitch_rate"], 1e-16);
  EXPECT_WITHIN(y["tip.az"], y["front_bogie.az"] + 2.0 * y["front_bogie.pitch_acc"], 1e-13);
}

TEST(MatrixForm, LinearIsTheRightHandSide) {
  for (const Vehicle& vehicle : allVehicles()) {
    const auto form = buildMatrixForm(compile(vehicle, kGravity));
    const StateSpace matrices = form->linear().value();
    for (const RandomState& state : statesFor(*form, 100)) {
      Eigen::VectorXd dx(form->size());
      form->derivative(state.x, state.u, {dx.data(), state.x.size()});
      const Eigen::VectorXd product =
          matrices.A * Eigen::Map<const Eigen::VectorXd>(state.x.data(), form->size()) +
          matrices.B * Eigen::Map<const Eigen::VectorXd>(state.u.data(), 2 * form->channels());
      EXPECT_WITHIN((dx - product).norm(), 0.0, 1e-14 * dx.norm());  // another order of the same sums
    }
  }
}

// The order of parts in a file is a matter of taste. Sums over suspensions change their order with it: roundings.
TEST(MatrixForm, ReorderedFilePermutesTheResultsAndChangesNothingElse) {
  const Vehicle vehicle = asymmetricBogiePitchVehicle();
  Vehicle turned = vehicle;
  std::reverse(turned.bodies.begin(), turned.bodies.end());
  std::rotate(turned.wheelsets.begin(), turned.wheelsets.begin() + 1, turned.wheelsets.end());
  std::reverse(turned.suspensions.begin(), turned.suspensions.end());
  const auto form = buildMatrixForm(compile(vehicle, kGravity));
  const auto other = buildMatrixForm(compile(turned, kGravity));
  for (const RandomState& state : statesFor(*form, 100)) {
    std::vector<double> x(12), u(12);
    for (std::size_t i = 0; i < 12; ++i) {
      const auto found = std::find(other->states().begin(), other->states().end(), form->states()[i]);
      x[static_cast<std::size_t>(found - other->states().begin())] = state.x[i];
    }
    for (std::size_t j = 0; j < 4; ++j) {
      // Wheelset j of the file stands one place earlier, cyclically, in the other.
      for (std::size_t order = 0; order < 3; ++order) u[4 * order + (j + 3) % 4] = state.u[4 * order + j];
    }
    const Columns one(*form, state.x, state.u);
    const Columns two(*other, x, u);
    for (const Channel& channel : form->outputs()) {
      const double scale = channel.unit == "N" ? 1e5 : channel.unit.ends_with("/s^2") ? 100.0 : 0.1;
      EXPECT_WITHIN(one[channel.name], two[channel.name], 1e-14 * scale) << channel.name;
    }
  }
}

TEST(MatrixForm, KeepsAGivenWheelLoad) {
  Vehicle vehicle = bogiePitchVehicle();
  vehicle.wheelsets[1].load = 123e3;
  const auto form = buildMatrixForm(compile(vehicle, kGravity));
  const Columns y(*form, std::vector<double>(12, 0.0), std::vector<double>(12, 0.0));
  EXPECT_EQ(y["wheelset_2.load"], 123e3);
}

TEST(BuildMatrixForm, RefusesAContradictoryVehicleWithItsProblems) {
  Vehicle vehicle = paperVehicle();
  vehicle.bodies[0].mass = -57e3;
  try {
    static_cast<void>(buildMatrixForm(compile(vehicle, kGravity)));
    FAIL() << "a negative mass was accepted";
  } catch (const InvalidInput& wrong) {
    EXPECT_EQ(wrong.problems().text(), check(vehicle).text());
  }
}

TEST(BuildMatrixForm, RefusesAVehicleThatNothingMoves) {
  Vehicle vehicle = paperVehicle();
  for (Body& each : vehicle.bodies) each.motion = {Motion::kRoll};
  EXPECT_THROW(static_cast<void>(buildMatrixForm(compile(vehicle, kGravity))), InvalidInput);
}

TEST(MatrixForm, DerivativeAndOutputNeverAllocate) {
  const auto form = buildMatrixForm(compile(hertzVehicle(), kGravity));
  const RandomState state = statesFor(*form, 1).front();
  std::vector<double> dx(state.x.size()), y(form->outputs().size());
  const long before = allocations();
  form->derivative(state.x, state.u, dx);
  form->output(state.x, state.u, y);
  EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace vehicle::test
