// The flat form as a System: orders, columns, static loads.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/flat/flat_statics.h"
#include "libvehicle/model/rest.h"
#include "tests/support/allocations.h"
#include "tests/support/columns.h"
#include "tests/support/random_state.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

std::size_t indexOf(const FlatForm& form, const std::string& state) {
  const auto& states = form.states();
  const auto found = std::find_if(states.begin(), states.end(), [&](const Channel& c) { return c.name == state; });
  if (found == states.end()) throw std::invalid_argument("no state " + state);
  return static_cast<std::size_t>(found - states.begin());
}

TEST(FlatForm, NamesStatesAndColumnsAsEveryForm) {
  const Vehicle vehicle = asymmetricVehicle();
  const auto form = buildFlatForm(compile(vehicle, kGravity));
  EXPECT_EQ(form->states(), stateChannels(topologyOf(vehicle)));
  EXPECT_EQ(form->outputs(), resultChannels(topologyOf(vehicle)));
  EXPECT_EQ(form->channels(), 4);
}

TEST(FlatForm, InnerOrderIsTheVehiclesOwnWhereTheFileGoesFromFrontToRear) {
  const auto form = buildFlatForm(compile(paperVehicle(), kGravity));
  EXPECT_EQ(form->stateOrder(), (std::array<int, 8>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(form->wheelOrder(), (std::array<int, 4>{0, 1, 2, 3}));
}

TEST(FlatForm, FindsFrontAndRearByPlaceAndNotByTheFilesOrder) {
  const auto form = buildFlatForm(compile(asymmetricVehicle(), kGravity));
  // File: rear_bogie.z, carbody.z, carbody.pitch, front_bogie.z; wheelsets 3, 1, 4, 2.
  EXPECT_EQ(form->stateOrder(), (std::array<int, 8>{1, 2, 3, 0, 5, 6, 7, 4}));
  EXPECT_EQ(form->wheelOrder(), (std::array<int, 4>{1, 3, 0, 2}));
  const FlatParameters& v = form->parameters();
  EXPECT_EQ(v.m1, 10.2e3);
  EXPECT_EQ(v.m2, 7.5e3);
  EXPECT_WITHIN(v.lf, 3.7, 1e-15);  // 6.0 - 2.3
  EXPECT_WITHIN(v.lr, 4.8, 1e-15);  // 2.3 + 2.5
  EXPECT_EQ(v.cs1, 3.1e6);
  EXPECT_EQ(v.bs2, 85e3);
  EXPECT_EQ(v.cp, (std::array<double, 4>{2.7e6, 3.4e6, 2.2e6, 3.9e6}));
  EXPECT_EQ(v.bp, (std::array<double, 4>{21e3, 33e3, 45e3, 12e3}));
  EXPECT_EQ(v.k_g, 0.0);
}

TEST(FlatRhs, GivesTheBitsOfDerivative) {
  const auto form = buildFlatForm(compile(asymmetricVehicle(), kGravity));
  for (const RandomState& state : randomStates(100, 8, 4)) {
    std::array<double, 8> x{}, u{}, inner{};
    std::vector<double> outer(8);
    for (std::size_t i = 0; i < 8; ++i) x[i] = state.x[static_cast<std::size_t>(form->stateOrder()[i])];
    for (std::size_t i = 0; i < 4; ++i) {
      u[i] = state.u[static_cast<std::size_t>(form->wheelOrder()[i])];
      u[i + 4] = state.u[static_cast<std::size_t>(form->wheelOrder()[i] + 4)];
    }
    (*form->rhs())(x.data(), u.data(), inner.data());
    form->derivative(state.x, state.u, outer);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(inner[i], outer[static_cast<std::size_t>(form->stateOrder()[i])]);
  }
}

TEST(FlatRhs, IsThereForTheConsistentEquationsOnly) {
  EXPECT_NE(buildFlatForm(compile(paperVehicle(), kGravity))->rhs(), nullptr);
  for (const FlatVariant variant : {FlatVariant::kPrinted7, FlatVariant::kLiteral, FlatVariant::kLiteralMb}) {
    EXPECT_EQ(buildFlatForm(compile(paperVehicle(), kGravity), variant)->rhs(), nullptr);
  }
}

// The order of parts in a file is a matter of taste: every column keeps its bits.
TEST(FlatForm, ReorderedFilePermutesTheResultsAndChangesNothingElse) {
  const Vehicle vehicle = asymmetricVehicle();
  Vehicle turned = vehicle;
  std::reverse(turned.bodies.begin(), turned.bodies.end());
  std::rotate(turned.wheelsets.begin(), turned.wheelsets.begin() + 1, turned.wheelsets.end());
  std::reverse(turned.suspensions.begin(), turned.suspensions.end());
  const auto form = buildFlatForm(compile(vehicle, kGravity));
  const auto other = buildFlatForm(compile(turned, kGravity));
  for (const RandomState& state : randomStates(20, 8, 4)) {
    std::vector<double> x(8), u(12);
    for (std::size_t i = 0; i < 8; ++i) x[indexOf(*other, form->states()[i].name)] = state.x[i];
    for (std::size_t j = 0; j < 4; ++j) {
      // Wheelset j of the file stands one place earlier, cyclically, in the other.
      for (std::size_t order = 0; order < 3; ++order) u[4 * order + (j + 3) % 4] = state.u[4 * order + j];
    }
    const Columns one(*form, state.x, state.u);
    const Columns two(*other, x, u);
    for (const Channel& channel : form->outputs()) EXPECT_EQ(one[channel.name], two[channel.name]) << channel.name;
  }
}

TEST(FlatColumns, CarryStateForceAndLoadOfAHandCalculatedState) {
  Vehicle vehicle = paperVehicle();
  vehicle.wheelsets[0].mass = 1500.0;
  vehicle.points = {pointOn("cab", "carbody", 7.0), pointOn("on_rear", "rear_bogie", -4.0)};
  const auto form = buildFlatForm(compile(vehicle, kGravity));
  //                            zk    phi   z1    z2    zk'   phi'  z1'   z2'
  const std::vector<double> x = {2e-3, 1e-3, 3e-3, -1e-3, 0.04, 0.02, 0.01, -0.03};
  //                            eta1  eta2  eta3 eta4  rates                 accelerations
  const std::vector<double> u = {1e-3, -2e-3, 0.0, 5e-3, 0.02, 0.0, -0.01, 0.03, 0.7, 0.8, 0.9, 1.0};
  const Columns y(*form, x, u);
  EXPECT_EQ(y["carbody.z"], 2e-3);
  EXPECT_EQ(y["carbody.pitch"], 1e-3);
  EXPECT_EQ(y["front_bogie.vz"], 0.01);
  // 2e-3 + 3.725e-3 - 3e-3 and 0.04 + 0.0745 - 0.01; roundings of numbers of that size.
  EXPECT_WITHIN(y["secondary_front.deflection"], 2.725e-3, 1e-17);
  const double fs1 = 2660e3 * 2.725e-3 + 100e3 * 0.1045;
  EXPECT_WITHIN(y["secondary_front.force"], fs1, 1e-11);
  EXPECT_WITHIN(y["secondary_rear.deflection"], 2e-3 - 3.725e-3 + 1e-3, 1e-17);
  const double fs2 = 2660e3 * (-0.725e-3) + 100e3 * (0.04 - 0.0745 + 0.03);
  EXPECT_WITHIN(y["secondary_rear.force"], fs2, 1e-11);
  EXPECT_WITHIN(y["primary_1.deflection"], 2e-3, 1e-17);
  const double fp1 = 3040e3 * 2e-3 + 30e3 * (0.01 - 0.02);
  EXPECT_WITHIN(y["primary_1.force"], fp1, 1e-11);
  EXPECT_WITHIN(y["primary_4.force"], 3040e3 * (-6e-3) + 30e3 * (-0.06), 1e-11);
  EXPECT_EQ(y["wheelset_2.rail_z"], -2e-3);
  // Elongation pulls the wheelset up and unloads the rail; a rail that accelerates upward loads it.
  const double static_load = (57e3 / 4 + 9e3 / 2) * kGravity;
  EXPECT_WITHIN(y["wheelset_1.load"], static_load + 1500.0 * kGravity - fp1 + 1500.0 * 0.7, 1e-10);
  EXPECT_WITHIN(y["wheelset_4.load"], static_load + 3040e3 * 6e-3 + 30e3 * 0.06, 1e-10);
  // Newton on the carbody and on the front bogie.
  const double fp2 = 3040e3 * 5e-3 + 30e3 * 0.01;
  EXPECT_WITHIN(y["carbody.az"], -(fs1 + fs2) / 57e3, 1e-15);
  EXPECT_WITHIN(y["carbody.pitch_acc"], -3.725 * (fs1 - fs2) / 70e3, 1e-14);
  EXPECT_WITHIN(y["front_bogie.az"], (fs1 - fp1 - fp2) / 9e3, 1e-14);
  // 7 m ahead of the CG.
  EXPECT_WITHIN(y["cab.z"], 2e-3 + 7.0 * 1e-3, 1e-17);
  EXPECT_WITHIN(y["cab.vz"], 0.04 + 7.0 * 0.02, 1e-16);
  EXPECT_WITHIN(y["cab.az"], y["carbody.az"] + 7.0 * y["carbody.pitch_acc"], 1e-14);
  // A bogie that does not pitch moves as a whole.
  EXPECT_EQ(y["on_rear.z"], -1e-3);
  EXPECT_EQ(y["on_rear.az"], y["rear_bogie.az"]);
  // Every column was written.
  for (const double each : y.all()) EXPECT_FALSE(std::isnan(each));
}

// What the suspensions say must be what moves the bodies, front and rear unequal.
TEST(FlatColumns, SuspensionForcesAreThoseThatAccelerateTheBodies) {
  const auto form = buildFlatForm(compile(asymmetricVehicle(), kGravity));
  for (const RandomState& state : randomStates(1000, 8, 4)) {
    const Columns y(*form, state.x, state.u);
    const double fs1 = y["secondary_front.force"];
    const double fs2 = y["secondary_rear.force"];
    const double fp12 = y["primary_1.force"] + y["primary_2.force"];
    const double fp34 = y["primary_3.force"] + y["primary_4.force"];
    // Roundings of forces up to 1e5 N.
    EXPECT_WITHIN(48e3 * y["carbody.az"], -fs1 - fs2, 1e-9);
    EXPECT_WITHIN(310e3 * y["carbody.pitch_acc"], -3.7 * fs1 + 4.8 * fs2, 1e-9);
    EXPECT_WITHIN(10.2e3 * y["front_bogie.az"], fs1 - fp12, 1e-9);
    EXPECT_WITHIN(7.5e3 * y["rear_bogie.az"], fs2 - fp34, 1e-9);
  }
}

TEST(FlatColumns, OfThePrintedVariantsKeepTheSuspensionLaw) {
  const auto right = buildFlatForm(compile(paperVehicle(), kGravity));
  const auto state = randomStates(1, 8, 4).front();
  const Columns expected(*right, state.x, state.u);
  for (const FlatVariant variant : {FlatVariant::kPrinted7, FlatVariant::kLiteral, FlatVariant::kLiteralMb}) {
    const auto form = buildFlatForm(compile(paperVehicle(), kGravity), variant);
    const Columns y(*form, state.x, state.u);
    EXPECT_EQ(y["secondary_rear.force"], expected["secondary_rear.force"]);
    EXPECT_EQ(y["wheelset_3.load"], expected["wheelset_3.load"]);
    EXPECT_NE(y["front_bogie.az"], expected["front_bogie.az"]);
    std::vector<double> dx(8);
    form->derivative(state.x, state.u, dx);
    EXPECT_EQ(y["front_bogie.az"], dx[6]);
  }
}

// The lever rule here, a linear solve there: one physics, two computations.
TEST(FlatLoads, ByTheLeverRuleAreThoseOfTheRestPosition) {
  for (const Vehicle& vehicle : {paperVehicle(), asymmetricVehicle(), heightsVehicle()}) {
    const Topology topology = topologyOf(vehicle);
    const FlatLayout layout = readLayout(topology).layout;
    const FlatLoads loads = flatLoads(compile(vehicle, kGravity), layout);
    const Rest rest = restOf(topology, kGravity);
    for (std::size_t i = 0; i < 2; ++i) {
      const double expected = rest.suspension_load[static_cast<std::size_t>(layout.secondary[i])];
      EXPECT_WITHIN(loads.secondary[i], expected, 1e-13 * expected);  // rounding of the solve
    }
    for (std::size_t wheel = 0; wheel < 4; ++wheel) {
      const double primary = rest.suspension_load[static_cast<std::size_t>(layout.primary[wheel])];
      EXPECT_WITHIN(loads.primary[wheel], primary, 1e-13 * primary);
      const double q0 = rest.wheel_load[static_cast<std::size_t>(layout.wheelset[wheel])];
      EXPECT_WITHIN(loads.wheel[wheel], q0, 1e-13 * q0);
    }
  }
}

TEST(FlatLoads, KeepGivenPreloadsAndWheelLoads) {
  Vehicle vehicle = paperVehicle();
  named(vehicle.suspensions, "primary_1").preload = 150e3;
  vehicle.wheelsets[3].load = 190e3;
  const auto form = buildFlatForm(compile(vehicle, kGravity));
  const Columns y(*form, std::vector<double>(8, 0.0), std::vector<double>(12, 0.0));
  const double bogie = 37.5e3 * kGravity;
  EXPECT_EQ(y["wheelset_1.load"], 150e3);
  EXPECT_WITHIN(y["wheelset_2.load"], bogie - 150e3, 1e-13 * bogie);
  EXPECT_EQ(y["wheelset_4.load"], 190e3);
}

TEST(FlatLoads, RefuseAGravityThatPointsUpward) {
  EXPECT_THROW(static_cast<void>(buildFlatForm(compile(paperVehicle(), -9.81))), std::invalid_argument);
}

// Attachments h below the CG add -mk g h to the pitch stiffness, and to nothing else.
TEST(FlatHeights, AddTheStaticLoadTermToPitch) {
  const StateSpace without = buildFlatForm(compile(paperVehicle(), kGravity))->linear().value();
  const StateSpace with = buildFlatForm(compile(heightsVehicle(0.5), kGravity))->linear().value();
  Eigen::MatrixXd difference = with.A - without.A;
  const double expected = 57e3 * kGravity * 0.5 / 70e3;
  EXPECT_WITHIN(difference(5, 1), expected, 1e-15 * std::abs(without.A(5, 1)));  // rounding of 2 ak^2 ck / Jk
  difference(5, 1) = 0.0;
  EXPECT_EQ(difference, Eigen::MatrixXd::Zero(8, 8));
  EXPECT_EQ(with.B, without.B);
}

TEST(FlatForm, LinearIsTheRightHandSide) {
  for (const FlatVariant variant :
       {FlatVariant::kConsistent, FlatVariant::kPrinted7, FlatVariant::kLiteral, FlatVariant::kLiteralMb}) {
    const auto form = buildFlatForm(compile(paperVehicle(), kGravity), variant);
    const StateSpace matrices = form->linear().value();
    for (const RandomState& state : randomStates(100, 8, 4)) {
      Eigen::VectorXd dx(8);
      form->derivative(state.x, state.u, {dx.data(), 8});
      const Eigen::VectorXd product = matrices.A * Eigen::Map<const Eigen::VectorXd>(state.x.data(), 8) +
                                      matrices.B * Eigen::Map<const Eigen::VectorXd>(state.u.data(), 8);
      EXPECT_WITHIN((dx - product).norm(), 0.0, 1e-14 * dx.norm());  // the same products summed in another order
    }
  }
}

TEST(FlatForm, DerivativeAndOutputNeverAllocate) {
  const auto form = buildFlatForm(compile(asymmetricVehicle(), kGravity));
  const RandomState state = randomStates(1, 8, 4).front();
  std::vector<double> dx(8), y(form->outputs().size());
  const long before = allocations();
  form->derivative(state.x, state.u, dx);
  form->output(state.x, state.u, y);
  EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace vehicle::test
