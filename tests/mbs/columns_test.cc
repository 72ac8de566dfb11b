// The columns of a result: values of one hand-calculated state, in the order that every form shares.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/mbs/mbs_form.h"
#include "libvehicle/model/layout.h"
#include "libvehicle/model/rest.h"
#include "libvehicle/model/topology.h"
#include "tests/support/columns.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

TEST(MbsColumns, AreThoseOfEveryForm) {
  for (const MbsLaw law : {MbsLaw::kLinear, MbsLaw::kTrue}) {
    const auto form = buildMbsForm(compile(contactVehicle(), kGravity), law);
    const Topology topology = topologyOf(contactVehicle());
    EXPECT_EQ(form->states(), stateChannels(topology));
    EXPECT_EQ(form->outputs(), resultChannels(topology));
    EXPECT_EQ(form->channels(), 4);
  }
}

TEST(MbsColumns, CarryStateAccelerationAndSuspensionForce) {
  const auto form = buildMbsForm(compile(paperVehicle(), kGravity), MbsLaw::kLinear);
  const std::vector<double> x = {2e-3, 1e-3, -1e-3, 3e-3, 0.02, -0.01, 0.03, 0.05};
  const std::vector<double> u = {1e-3, 2e-3, -1e-3, 4e-3, 0.1, 0.2, -0.1, 0.3, 1.0, 2.0, 3.0, 4.0};
  const Columns y(*form, x, u);
  std::vector<double> dx(8);
  form->derivative(x, {u.data(), 8}, dx);
  EXPECT_EQ(y["carbody.z"], x[0]);
  EXPECT_EQ(y["carbody.pitch"], x[1]);
  EXPECT_EQ(y["carbody.vz"], x[4]);
  EXPECT_EQ(y["carbody.pitch_rate"], x[5]);
  EXPECT_EQ(y["carbody.az"], dx[4]);
  EXPECT_EQ(y["carbody.pitch_acc"], dx[5]);
  EXPECT_EQ(y["rear_bogie.vz"], x[7]);
  EXPECT_EQ(y["rear_bogie.az"], dx[7]);
  // Rounding of three products; the terms are 1e-3.
  EXPECT_WITHIN(y["secondary_front.deflection"], 2e-3 + 3.725 * 1e-3 - (-1e-3), 1e-17);
  EXPECT_WITHIN(y["secondary_rear.deflection"], 2e-3 - 3.725 * 1e-3 - 3e-3, 1e-17);
  // Rounding of terms of 1e4 N.
  EXPECT_WITHIN(y["secondary_front.force"], 2660e3 * 6.725e-3 + 100e3 * (0.02 - 3.725 * 0.01 - 0.03), 1e-10);
  EXPECT_WITHIN(y["primary_3.force"], 3040e3 * (3e-3 + 1e-3) + 30e3 * (0.05 + 0.1), 1e-10);
  EXPECT_EQ(y["wheelset_2.rail_z"], 2e-3);
}

// A quarter of 57 t and two bogies of 9 t rest on each wheelset; a spring that pulls takes load off it.
TEST(MbsColumns, WheelLoadIsTheStaticLoadLessThePullOfThePrimary) {
  const auto form = buildMbsForm(compile(paperVehicle(), kGravity), MbsLaw::kLinear);
  const std::vector<double> u(12, 0.0);
  const double static_load = 75e3 / 4.0 * kGravity;
  EXPECT_WITHIN((Columns(*form, std::vector<double>(8, 0.0), u)["wheelset_1.load"]), static_load, 1e-9);  // rounding
  const std::vector<double> lifted = {0.0, 0.0, 1e-3, 0.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_WITHIN((Columns(*form, lifted, u)["wheelset_1.load"]), static_load - 3040.0, 1e-9);
  EXPECT_WITHIN((Columns(*form, lifted, u)["wheelset_4.load"]), static_load, 1e-9);
}

TEST(MbsColumns, WheelLoadOfAMassThatFollowsTheRailHoldsItsInertia) {
  for (const MbsLaw law : {MbsLaw::kLinear, MbsLaw::kTrue}) {
    const auto form = buildMbsForm(compile(bogiePitchVehicle(), kGravity), law);
    const std::vector<double> x(12, 0.0);
    std::vector<double> u(12, 0.0);
    const double still = Columns(*form, x, u)["wheelset_3.load"];
    u[8 + 2] = 2.5;
    // Rounding of a load of 1e5 N.
    EXPECT_WITHIN((Columns(*form, x, u)["wheelset_3.load"]), still + 1813.0 * 2.5, 1e-9);
    EXPECT_EQ((Columns(*form, x, u)["wheelset_1.load"]), still);
  }
}

TEST(MbsColumns, WheelLoadOverAContactIsItsCompression) {
  for (const MbsLaw law : {MbsLaw::kLinear, MbsLaw::kTrue}) {
    const auto form = buildMbsForm(compile(contactVehicle(), kGravity), law);
    const Rest rest = restOf(topologyOf(contactVehicle()), kGravity);
    std::vector<double> x(20, 0.0), u(12, 0.0);
    x[6] = 1e-5;         // wheelset_1.z
    u[0] = 3e-5;         // its rail has come up further
    u[4] = 0.02;         // and still comes
    const Columns y(*form, x, u);
    EXPECT_EQ(y["wheelset_1.z"], 1e-5);
    // Rounding of loads of 1e5 N; in kTrue also of a height of 0.5 m times 2.4e9 N/m (no heights here: zero).
    EXPECT_WITHIN(y["wheelset_1.load"], rest.wheel_load[0] + 2.4e9 * 2e-5 + 20e3 * 0.02, 1e-9);
    // The compressed contact throws the wheelset up; its primary (8e3 N s/m, still) holds 2.44e6 x 1e-5 N of it.
    EXPECT_WITHIN(y["wheelset_1.az"], (2.4e9 * 2e-5 + 20e3 * 0.02 - 2440e3 * 1e-5) / 1813.0, 1e-11);
  }
}

// On the true body a point runs on a circle: z = a sin(phi), az = a (phi'' cos(phi) - phi'^2 sin(phi)).
TEST(MbsColumns, PointOfATrueBodyMovesOnACircle) {
  Vehicle made = paperVehicle();
  made.points = {pointOn("floor", "carbody", 2.0)};
  const std::vector<double> x = {0.01, 0.3, 0.0, 0.0, 0.1, 0.7, 0.0, 0.0}, u(12, 0.0);
  const auto form = buildMbsForm(compile(made, kGravity), MbsLaw::kTrue);
  const Columns y(*form, x, u);
  // Rounding of sums of about 1 m, 1 m/s and, over the springs, 1e3 m/s^2.
  EXPECT_WITHIN(y["floor.z"], 0.01 + 2.0 * std::sin(0.3), 2e-15);
  EXPECT_WITHIN(y["floor.vz"], 0.1 + 2.0 * 0.7 * std::cos(0.3), 2e-15);
  EXPECT_WITHIN(y["floor.az"],
                y["carbody.az"] + 2.0 * (y["carbody.pitch_acc"] * std::cos(0.3) - 0.49 * std::sin(0.3)), 1e-11);
}

TEST(MbsColumns, PointOfALinearBodyMovesOnALine) {
  Vehicle made = paperVehicle();
  made.points = {pointOn("floor", "carbody", 2.0)};
  const std::vector<double> x = {0.01, 0.3, 0.0, 0.0, 0.1, 0.7, 0.0, 0.0}, u(12, 0.0);
  const auto form = buildMbsForm(compile(made, kGravity), MbsLaw::kLinear);
  const Columns y(*form, x, u);
  EXPECT_EQ(y["floor.z"], 0.01 + 2.0 * 0.3);
  EXPECT_EQ(y["floor.vz"], 0.1 + 2.0 * 0.7);
  EXPECT_EQ(y["floor.az"], y["carbody.az"] + 2.0 * y["carbody.pitch_acc"]);
}

TEST(MbsColumns, AContradictoryVehicleIsRefused) {
  Vehicle made = paperVehicle();
  named(made.suspensions, "primary_1").upper = "no_such_body";
  EXPECT_THROW((void)buildMbsForm(compile(made, kGravity), MbsLaw::kLinear), InvalidInput);
}

}  // namespace
}  // namespace vehicle::test
