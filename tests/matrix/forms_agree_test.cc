// Flat and matrix form: the same physics, written by hand and assembled. Same state, same force.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/matrix/matrix_form.h"
#include "tests/support/columns.h"
#include "tests/support/random_state.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]
// Two orders of the same few dozen products: some roundings of the largest number of that kind in the state.
constexpr double kRounding = 1e-14;

/// Everything that the flat form can carry: unequal everywhere, heights, wheelsets with mass, points.
Vehicle fullVehicle() {
  Vehicle made = withHeights(asymmetricVehicle(), 0.4);
  made.name = "full";
  for (Wheelset& each : made.wheelsets) each.mass = 1500.0;
  made.points = {pointOn("cab", "carbody", 9.0), pointOn("on_front", "front_bogie", 7.0),
                 pointOn("on_rear", "rear_bogie", -4.0)};
  return made;
}

std::vector<Vehicle> flatVehicles() {
  return {paperVehicle(), paperVehicle(686465.5), asymmetricVehicle(), heightsVehicle(), fullVehicle()};
}

TEST(FlatAndMatrix, GiveTheSameRatesAtAThousandStates) {
  for (const Vehicle& vehicle : flatVehicles()) {
    const auto flat = buildFlatForm(compile(vehicle, kGravity));
    const auto matrix = buildMatrixForm(compile(vehicle, kGravity));
    ASSERT_EQ(flat->states(), matrix->states());
    for (const RandomState& state : randomStates(1000, 8, 4)) {
      std::vector<double> one(8), other(8);
      flat->derivative(state.x, state.u, one);
      matrix->derivative(state.x, state.u, other);
      double largest = 0.0;
      for (const double each : one) largest = std::max(largest, std::abs(each));
      for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_WITHIN(one[i], other[i], kRounding * largest) << vehicle.name << ' ' << flat->states()[i].name;
      }
    }
  }
}

/// Columns of one kind share a scale: that of the largest of them at this state.
double scaleOf(const std::vector<Channel>& channels, const std::vector<double>& values, const std::string& unit) {
  double largest = 0.0;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].unit == unit) largest = std::max(largest, std::abs(values[i]));
  }
  return largest;
}

TEST(FlatAndMatrix, GiveTheSameColumnsAtAThousandStates) {
  for (const Vehicle& vehicle : flatVehicles()) {
    const auto flat = buildFlatForm(compile(vehicle, kGravity));
    const auto matrix = buildMatrixForm(compile(vehicle, kGravity));
    ASSERT_EQ(flat->outputs(), matrix->outputs());
    for (const RandomState& state : randomStates(1000, 8, 4)) {
      const Columns one(*flat, state.x, state.u);
      const Columns other(*matrix, state.x, state.u);
      for (std::size_t i = 0; i < one.all().size(); ++i) {
        const Channel& channel = flat->outputs()[i];
        // The same forces make all accelerations, and in one body they may cancel: pitch and bounce share a scale.
        const double scale = channel.unit.ends_with("/s^2")
                                 ? std::max(scaleOf(flat->outputs(), one.all(), "m/s^2"),
                                            scaleOf(flat->outputs(), one.all(), "rad/s^2"))
                                 : scaleOf(flat->outputs(), one.all(), channel.unit);
        EXPECT_WITHIN(one.all()[i], other.all()[i], kRounding * scale)
            << vehicle.name << ' ' << channel.name;
      }
    }
  }
}

// Entry by entry: a sum cannot hide a wrong small one.
TEST(FlatAndMatrix, HaveTheSameStateSpace) {
  for (const Vehicle& vehicle : flatVehicles()) {
    const StateSpace flat = buildFlatForm(compile(vehicle, kGravity))->linear().value();
    const StateSpace matrix = buildMatrixForm(compile(vehicle, kGravity))->linear().value();
    for (Eigen::Index row = 0; row < 8; ++row) {
      // A row is a sum over suspensions: entries that cancel (bounce on pitch) keep roundings of its largest one.
      EXPECT_WITHIN((flat.A.row(row) - matrix.A.row(row)).cwiseAbs().maxCoeff(), 0.0,
                    1e-15 * flat.A.row(row).cwiseAbs().maxCoeff()) << vehicle.name << ' ' << row;
      EXPECT_WITHIN((flat.B.row(row) - matrix.B.row(row)).cwiseAbs().maxCoeff(), 0.0,
                    1e-15 * flat.B.row(row).cwiseAbs().maxCoeff()) << vehicle.name << ' ' << row;
    }
  }
}

// In the symmetric vehicle bogie pitch moves neither carbody nor bogie bounce, and is moved by neither.
TEST(BogiePitch, LeavesTheRowsOfTheFourDegreesOfFreedomAlone) {
  const Vehicle six = bogiePitchVehicle();
  Vehicle four = six;
  for (Body& each : four.bodies) {
    if (each.name != "carbody") each.motion = {Motion::kZ};
  }
  const auto flat = buildFlatForm(compile(four, kGravity));
  const auto matrix = buildMatrixForm(compile(six, kGravity));
  constexpr std::array<std::size_t, 4> kInSix = {0, 1, 2, 4};  // zk, phi, z1, z2 among zk, phi, z1, th1, z2, th2
  for (const RandomState& state : randomStates(1000, 12, 4)) {
    std::vector<double> x(8), dx(8), dx_six(12);
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] = state.x[kInSix[i]];
      x[i + 4] = state.x[kInSix[i] + 6];
    }
    flat->derivative(x, state.u, dx);
    matrix->derivative(state.x, state.u, dx_six);
    double largest = 0.0;
    for (const double each : dx) largest = std::max(largest, std::abs(each));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_WITHIN(dx_six[kInSix[i] + 6], dx[i + 4], kRounding * largest) << i;
    }
  }
}

// ... but the wheels under a pitching bogie share its load differently.
TEST(BogiePitch, ChangesWheelLoads) {
  const auto form = buildMatrixForm(compile(bogiePitchVehicle(), kGravity));
  std::vector<double> x(12, 0.0);
  const std::vector<double> u(12, 0.0);
  x[3] = 1e-3;  // the front bogie's nose up by 1 mrad: its leading axle's spring intervals by 1.28 mm
  const Columns y(*form, x, u);
  const double q0 = (32e3 / 4 + 2615.0 / 2 + 1813.0) * kGravity;
  EXPECT_WITHIN(y["wheelset_1.load"], q0 - 2440e3 * 1.28e-3, 1e-9);
  EXPECT_WITHIN(y["wheelset_2.load"], q0 + 2440e3 * 1.28e-3, 1e-9);
  EXPECT_WITHIN(y["wheelset_3.load"], q0, 1e-9);
}

}  // namespace
}  // namespace vehicle::test
