// Matrices of any topology: closed forms of small cases, symmetry, definiteness, static loads.
#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/matrix/matrix_form.h"
#include "libvehicle/model/topology.h"
#include "tests/matrix/published_vehicles.h"
#include "tests/support/eigenvalues.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

std::vector<Vehicle> vehiclesWithoutHeights() {
  return {paperVehicle(),   asymmetricVehicle(), bogiePitchVehicle(), asymmetricBogiePitchVehicle(),
          contactVehicle(), hertzVehicle()};
}

double asymmetryOf(const Eigen::MatrixXd& matrix) { return (matrix - matrix.transpose()).cwiseAbs().maxCoeff(); }

double smallestEigenvalue(const Eigen::MatrixXd& matrix) {
  return test::symmetricEigenvaluesOf(matrix).minCoeff();
}

TEST(Matrices, AreSymmetricAndDefiniteOnTheRail) {
  for (const Vehicle& vehicle : vehiclesWithoutHeights()) {
    const auto form = buildMatrixForm(compile(vehicle, kGravity));
    const SecondOrder& matrices = form->matrices();
    // r^T r is symmetric bit for bit, and so is a sum of such.
    EXPECT_EQ(asymmetryOf(matrices.K), 0.0) << vehicle.name;
    EXPECT_EQ(asymmetryOf(matrices.C), 0.0) << vehicle.name;
    EXPECT_GT(smallestEigenvalue(matrices.K), 0.0) << vehicle.name;
    // Nothing damps a lift of all bodies with their wheelsets on undamped contacts: zero but for the solver's rounding.
    EXPECT_GT(smallestEigenvalue(matrices.C), -1e-14 * matrices.C.cwiseAbs().maxCoeff()) << vehicle.name;
    if (vehicle.name != "hertz") {
      EXPECT_GT(smallestEigenvalue(matrices.C), 0.0) << vehicle.name;
    }
    EXPECT_TRUE(matrices.M.isDiagonal(0.0)) << vehicle.name;
    EXPECT_GT(matrices.M.diagonal().minCoeff(), 0.0) << vehicle.name;
  }
}

// Bodies and rail together by h: K lift = B0 1, C lift = B1 1.
TEST(UniformLift, LeavesNoForce) {
  for (const Vehicle& vehicle : vehiclesWithoutHeights()) {
    const auto form = buildMatrixForm(compile(vehicle, kGravity));
    const SecondOrder& matrices = form->matrices();
    const Topology topology = topologyOf(vehicle);
    Eigen::VectorXd lift = Eigen::VectorXd::Zero(topology.coordinates);
    for (const TopologyBody& body : topology.bodies) lift[body.z_index] = 1.0;
    for (const TopologyWheelset& wheelset : topology.wheelsets) {
      if (wheelset.z_index >= 0) lift[wheelset.z_index] = 1.0;
    }
    const Eigen::VectorXd rail = Eigen::VectorXd::Ones(form->channels());
    // Roundings of the largest entry.
    EXPECT_WITHIN((matrices.K * lift - matrices.B0 * rail).cwiseAbs().maxCoeff(), 0.0,
                  1e-15 * matrices.K.cwiseAbs().maxCoeff()) << vehicle.name;
    EXPECT_WITHIN((matrices.C * lift - matrices.B1 * rail).cwiseAbs().maxCoeff(), 0.0,
                  1e-15 * matrices.C.cwiseAbs().maxCoeff()) << vehicle.name;
  }
}

// Pitching the whole vehicle about any point, the rail with it, is as rigid as a lift.
TEST(UniformPitch, LeavesNoForceWhereEverythingPitches) {
  for (const Vehicle& vehicle : {bogiePitchVehicle(), asymmetricBogiePitchVehicle(), contactVehicle()}) {
    const auto form = buildMatrixForm(compile(vehicle, kGravity));
    const Topology topology = topologyOf(vehicle);
    Eigen::VectorXd turn = Eigen::VectorXd::Zero(topology.coordinates);
    Eigen::VectorXd rail(form->channels());
    for (const TopologyBody& body : topology.bodies) {
      turn[body.z_index] = body.x;
      turn[body.pitch_index] = 1.0;
    }
    for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
      rail[static_cast<Eigen::Index>(j)] = topology.wheelsets[j].x;
      if (topology.wheelsets[j].z_index >= 0) turn[topology.wheelsets[j].z_index] = topology.wheelsets[j].x;
    }
    const SecondOrder& matrices = form->matrices();
    // Roundings of the largest product, an arm of 10 m and an entry of K.
    EXPECT_WITHIN((matrices.K * turn - matrices.B0 * rail).cwiseAbs().maxCoeff(), 0.0,
                  1e-14 * matrices.K.cwiseAbs().maxCoeff()) << vehicle.name;
    EXPECT_WITHIN((matrices.C * turn - matrices.B1 * rail).cwiseAbs().maxCoeff(), 0.0,
                  1e-14 * matrices.C.cwiseAbs().maxCoeff()) << vehicle.name;
  }
}

Vehicle oneBodyOnOneWheelset() {
  Vehicle made;
  made.name = "quarter";
  made.elements = {element("spring", 1.2e6, 30e3)};
  made.bodies = {body("mass", 8e3, 0.0, std::nullopt, {Motion::kZ})};
  made.wheelsets = {wheelset("axle", 0.0)};
  made.wheelsets[0].mass = 1.5e3;
  made.suspensions = {suspension("leg", "spring", "mass", "axle", 0.0)};
  return made;
}

// The textbook two-mass model, by hand.
TEST(OneBodyOnOneWheelset, HasTheTextbookMatrices) {
  Vehicle vehicle = oneBodyOnOneWheelset();
  vehicle.wheelsets[0].contact_stiffness = 1.9e9;
  vehicle.wheelsets[0].contact_damping = 5e3;
  const auto form = buildMatrixForm(compile(vehicle, kGravity));
  const SecondOrder& matrices = form->matrices();
  EXPECT_EQ(matrices.M, (Eigen::MatrixXd(2, 2) << 8e3, 0, 0, 1.5e3).finished());
  EXPECT_EQ(matrices.K, (Eigen::MatrixXd(2, 2) << 1.2e6, -1.2e6, -1.2e6, 1.2e6 + 1.9e9).finished());
  EXPECT_EQ(matrices.C, (Eigen::MatrixXd(2, 2) << 30e3, -30e3, -30e3, 35e3).finished());
  EXPECT_EQ(matrices.B0, (Eigen::MatrixXd(2, 1) << 0, 1.9e9).finished());
  EXPECT_EQ(matrices.B1, (Eigen::MatrixXd(2, 1) << 0, 5e3).finished());
}

TEST(OneBodyOnOneWheelset, TakesAHertzContactAtItsStaticLoad) {
  Vehicle vehicle = oneBodyOnOneWheelset();
  vehicle.wheelsets[0].hertz_constant = 150e9;
  const auto form = buildMatrixForm(compile(vehicle, kGravity));
  const double hertz = 1.5 * std::pow(150e9, 2.0 / 3.0) * std::pow(9.5e3 * kGravity, 1.0 / 3.0);
  EXPECT_WITHIN(form->matrices().B0(1, 0), hertz, 1e-13 * hertz);  // pow against cbrt
  EXPECT_WITHIN(form->matrices().K(1, 1), 1.2e6 + hertz, 1e-13 * hertz);
}

TEST(OneBodyOnOneWheelset, WithoutContactFollowsTheRail) {
  const auto form = buildMatrixForm(compile(oneBodyOnOneWheelset(), kGravity));
  const SecondOrder& matrices = form->matrices();
  EXPECT_EQ(matrices.M, Eigen::MatrixXd::Constant(1, 1, 8e3));
  EXPECT_EQ(matrices.K, Eigen::MatrixXd::Constant(1, 1, 1.2e6));
  EXPECT_EQ(matrices.B0, Eigen::MatrixXd::Constant(1, 1, 1.2e6));
  EXPECT_EQ(matrices.B1, Eigen::MatrixXd::Constant(1, 1, 30e3));
}

// K_phi = 2 ak^2 ck - mk g h.
TEST(Heights, SoftenThePitchOfACarbodyOnAttachmentsBelowItsCentreOfGravity) {
  const auto form = buildMatrixForm(compile(heightsVehicle(0.5), kGravity));
  const double expected = 2 * 3.725 * 3.725 * 2660e3 - 57e3 * kGravity * 0.5;
  EXPECT_WITHIN(form->matrices().K(1, 1), expected, 1e-15 * expected);
}

// The bogie: 2 b^2 cp, its primaries' loads at h below its CG, and the carbody's load on it at the same height.
TEST(Heights, SoftenThePitchOfABogieByItsOwnAndTheCarbodysLoad) {
  const double h = 0.3;
  const auto form = buildMatrixForm(compile(bogiePitchHeightsVehicle(h), kGravity));
  const double primaries = -(2615.0 + 16e3) * kGravity * h;
  const double secondary = 16e3 * kGravity * h;
  const double expected = 2 * 1.28 * 1.28 * 2440e3 + primaries + secondary;
  EXPECT_WITHIN(form->matrices().K(3, 3), expected, 1e-15 * expected);
}

TEST(Heights, WithoutGravityChangeNothing) {
  const auto with = buildMatrixForm(compile(heightsVehicle(0.5), 0.0));
  const auto without = buildMatrixForm(compile(paperVehicle(), 0.0));
  EXPECT_EQ(with->matrices().K, without->matrices().K);
}

Vehicle vehicleOf(const PublishedVehicle& numbers) {
  return symmetricVehicle(numbers.name, numbers.carbody_mass, numbers.carbody_inertia, numbers.half_pivots,
                          {numbers.bogie_mass, numbers.bogie_inertia, numbers.half_wheelbase},
                          element("primary", numbers.primary_stiffness, numbers.primary_damping),
                          element("secondary", numbers.secondary_stiffness, numbers.secondary_damping));
}

// Our own computation in another program, four decimals: half a unit of the last.
TEST(PublishedVehicles, HaveTheUndampedFrequenciesOfTheIndependentForm) {
  for (const PublishedVehicle& published : publishedVehicles()) {
    const auto form = buildMatrixForm(compile(vehicleOf(published), kGravity));
    const SecondOrder& matrices = form->matrices();
    const Eigen::VectorXd squares = test::squaredFrequenciesOf(matrices.K, matrices.M);
    for (std::size_t i = 0; i < 6; ++i) {
      const double hz = std::sqrt(squares[static_cast<Eigen::Index>(i)]) / (2 * std::numbers::pi);
      EXPECT_WITHIN(hz, published.undamped_hz[i], 0.5e-4) << published.name;
    }
  }
}

TEST(PublishedVehicles, HaveTheDampedFrequenciesOfTheIndependentForm) {
  for (const PublishedVehicle& published : publishedVehicles()) {
    const StateSpace matrices = buildMatrixForm(compile(vehicleOf(published), kGravity))->linear().value();
    const std::vector<std::complex<double>> upper = test::oscillationsOf(matrices.A);
    for (std::size_t i = 0; i < published.damped.size(); ++i) {
      EXPECT_WITHIN(std::abs(upper[i]) / (2 * std::numbers::pi), published.damped[i].first, 0.5e-4) << published.name;
      EXPECT_WITHIN(-upper[i].real() / std::abs(upper[i]), published.damped[i].second, 0.5e-4) << published.name;
    }
  }
}

}  // namespace
}  // namespace vehicle::test
