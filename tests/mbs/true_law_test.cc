// "mbs": true rotation, attachment points, gravity and preload.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/mbs/mbs_form.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

std::vector<double> derivativeOf(const MbsForm& form, const std::vector<double>& x) {
  std::vector<double> dx(x.size());
  form.derivative(x, std::vector<double>(2 * static_cast<std::size_t>(form.channels()), 0.0), dx);
  return dx;
}

// Preloads carry the weights: 9.81 m/s^2 of gravity must vanish, with moments, at any heights.
TEST(MbsTrue, AtRestNothingAccelerates) {
  for (const Vehicle& made : {paperVehicle(), asymmetricVehicle(), asymmetricBogiePitchVehicle(), bogiePitchVehicle(),
                              contactVehicle(), hertzVehicle(), heightsVehicle(), bogiePitchHeightsVehicle(),
                              withHeights(contactVehicle(), 0.3), withHeights(asymmetricBogiePitchVehicle(), -0.2)}) {
    const auto form = buildMbsForm(compile(made, kGravity), MbsLaw::kTrue);
    for (const double rate : derivativeOf(*form, std::vector<double>(static_cast<std::size_t>(form->size()), 0.0))) {
      // Rounding of preloads of 3e5 N (4e-11 N) on the lightest part, 1.8 t: 3e-14 m/s^2; on the nimblest pitch,
      // 1.5 t m^2 with levers of 1 m, as much. An attachment misplaced by 1 mm shows at 1e-2.
      EXPECT_WITHIN(rate, 0.0, 5e-13) << made.name;
    }
  }
}

// A load given by hand is the reference of unloading; it must not push the vehicle out of its rest.
TEST(MbsTrue, AGivenWheelLoadDoesNotDisturbTheRest) {
  Vehicle made = contactVehicle();
  for (Wheelset& each : made.wheelsets) each.load = 120e3;
  const auto form = buildMbsForm(compile(made, kGravity), MbsLaw::kTrue);
  for (const double rate : derivativeOf(*form, std::vector<double>(20, 0.0))) {
    EXPECT_WITHIN(rate, 0.0, 5e-13);  // rounding, as above
  }
}

// With attachments h = 0.5 m below the centres of gravity the pitch stiffness of the carbody loses mk g h; everything
// else is the paper's: entries of A = -M^-1 (K, C) in closed form.
TEST(MbsTrue, DifferencedMatrixHasTheClosedFormWithStaticLoads) {
  const double mk = 57e3, jk = 70e3, mb = 9e3, ak = 3.725, cb = 3040e3, bb = 30e3, ck = 2660e3, bk = 100e3;
  const double h = 0.5;
  const auto form = buildMbsForm(compile(heightsVehicle(h), kGravity), MbsLaw::kTrue);
  const StateSpace differenced =
      differencedStateSpace(*form, std::vector<double>(8, 0.0), std::vector<double>(8, 0.0), 1e-4);
  const auto coupled = [&](double k, double p, double pitch_extra) {  // k, p: of one secondary and one primary
    Eigen::Matrix4d made;
    made << 2 * k, 0, -k, -k,                                      //
        0, 2 * ak * ak * k + pitch_extra, -ak * k, ak * k,         //
        -k, -ak * k, k + 2 * p, 0,                                 //
        -k, ak * k, 0, k + 2 * p;
    return made;
  };
  const Eigen::Vector4d inertia(mk, jk, mb, mb);
  const Eigen::Matrix4d stiffness = inertia.cwiseInverse().asDiagonal() * coupled(ck, cb, -mk * kGravity * h);
  const Eigen::Matrix4d damping = inertia.cwiseInverse().asDiagonal() * coupled(bk, bb, 0.0);
  for (Eigen::Index row = 0; row < 4; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) {
      // Truncation scale^2 = 1e-8 and rounding 1e-13 / 1e-4 = 1e-9, of the row's size; mk g h is 0.4 % of its entry.
      EXPECT_WITHIN(differenced.A(4 + row, column), -stiffness(row, column), 2e-7 * stiffness.row(row).norm());
      EXPECT_WITHIN(differenced.A(4 + row, 4 + column), -damping(row, column), 2e-7 * damping.row(row).norm());
    }
  }
}

// The linear law with static loads must be the tangent of the true one, for every vehicle.
TEST(MbsTrue, LinearLawIsItsTangentAtRest) {
  for (const Vehicle& made : {asymmetricBogiePitchVehicle(), contactVehicle(), hertzVehicle(),
                              bogiePitchHeightsVehicle(), withHeights(asymmetricBogiePitchVehicle(), -0.2),
                              withHeights(contactVehicle(), 0.3)}) {
    const auto truly = buildMbsForm(compile(made, kGravity), MbsLaw::kTrue);
    const auto linear = buildMbsForm(compile(made, kGravity), MbsLaw::kLinear);
    EXPECT_FALSE(truly->linear().has_value());
    const std::vector<double> x(static_cast<std::size_t>(truly->size()), 0.0);
    const std::vector<double> u(2 * static_cast<std::size_t>(truly->channels()), 0.0);
    const StateSpace differenced = differencedStateSpace(*truly, x, u, 1e-4);
    const StateSpace exact = linear->linear().value();
    const Eigen::MatrixXd off_a = differenced.A - exact.A, off_b = differenced.B - exact.B;
    for (Eigen::Index row = 0; row < exact.A.rows(); ++row) {
      const double size = exact.A.row(row).norm();
      EXPECT_WITHIN(off_a.row(row).norm(), 0.0, 2e-7 * size) << made.name << ", row " << row;  // as above
      EXPECT_WITHIN(off_b.row(row).norm(), 0.0, 2e-7 * size) << made.name << ", row " << row;
    }
  }
}

/// Largest difference of the two laws' accelerations over the largest acceleration, at a given shape of motion.
double deviation(const Vehicle& made, double amplitude) {
  const auto truly = buildMbsForm(compile(made, kGravity), MbsLaw::kTrue);
  const auto linear = buildMbsForm(compile(made, kGravity), MbsLaw::kLinear);
  std::vector<double> x = {0.4, 1.0, -0.3, 0.7, 2.0, 5.0, -3.0, 1.0};
  for (double& each : x) each *= amplitude;
  const std::vector<double> a = derivativeOf(*truly, x), b = derivativeOf(*linear, x);
  double difference = 0.0, size = 0.0;
  for (std::size_t i = 4; i < 8; ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return difference / size;
}

/// Of log(deviation) over log(amplitude), between 0.01 of an amplitude and itself.
double slopeOverTwoDecades(const Vehicle& made, double amplitude) {
  return std::log10(deviation(made, amplitude) / deviation(made, 0.01 * amplitude)) / 2.0;
}

// Attached at the height of the centre of gravity, sin(phi) - phi and cos(phi) - 1 are all there is: the relative
// difference goes with the square of the amplitude. At 0.1 rad the next even power is 1e-3 of it.
TEST(MbsTrue, DepartsFromTheLinearLawWithTheSquareOfTheAmplitude) {
  EXPECT_WITHIN(slopeOverTwoDecades(paperVehicle(), 0.1), 2.0, 0.05);
}

// With heights the force on a tilted lever, k d h sin(phi), is of second order already: relative slope 1. The next
// power has grown to 28 % at 0.1 rad (seen: a slope of 1.053) and is 3 % at 0.01 rad: 0.006 of slope.
TEST(MbsTrue, WithHeightsDepartsInProportionToTheAmplitude) {
  EXPECT_WITHIN(slopeOverTwoDecades(heightsVehicle(), 0.01), 1.0, 0.02);
}

// One bogie's springs see sin(phi) and cos(phi) only through Simbody: the law at a large angle, by hand.
TEST(MbsTrue, ForcesAtALargeAngleAreThoseOfTheAttachmentPoints) {
  const double phi = 0.4, z = 0.02, h = -0.5, arm = 3.725, mk = 57e3, jk = 70e3, k = 2660e3;
  const double preload = mk * kGravity / 2.0;
  const auto form = buildMbsForm(compile(heightsVehicle(0.5), kGravity), MbsLaw::kTrue);
  const std::vector<double> dx = derivativeOf(*form, {z, phi, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  double force = -mk * kGravity, moment = 0.0;
  for (const double a : {arm, -arm}) {
    const double rise = z + a * std::sin(phi) + h * (std::cos(phi) - 1.0);
    const double up = preload - k * rise;
    force += up;
    moment += up * (a * std::cos(phi) - h * std::sin(phi));
  }
  // Rounding of terms of 70 m/s^2 and 300 rad/s^2.
  EXPECT_WITHIN(dx[4], force / mk, 1e-12);
  EXPECT_WITHIN(dx[5], moment / jk, 1e-11);
}

}  // namespace
}  // namespace vehicle::test
