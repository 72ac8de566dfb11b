#include "libvehicle/flat/flat_split.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/system/mixed_input.h"
#include "tests/support/eigenvalues.h"
#include "tests/support/random_state.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;

/// The paper's vehicle in a file that names the rear bogie first and the wheelsets backwards.
Vehicle reversedVehicle() {
  Vehicle made = paperVehicle();
  std::reverse(made.bodies.begin(), made.bodies.end());
  std::reverse(made.wheelsets.begin(), made.wheelsets.end());
  return made;
}

// The rates of both halves, led back, against (2)-(5): some twenty products and sums a side, 1e-15 of the largest
// rate of a kind. A wrong factor 2 anywhere is of order 1.
TEST(FlatSplit, HalvesHaveTheRatesOfTheWholeAtRandomStates) {
  for (const Vehicle& vehicle : {paperVehicle(), reversedVehicle(), heightsVehicle()}) {
    const auto form = buildFlatForm(compile(vehicle, kGravity));
    const FlatSplit split(*form);
    std::vector<double> dx(8), halves(8), rates(8), led_back(8), u(4);
    double worst = 0.0;
    for (const RandomState& state : randomStates(200, 8, 4)) {
      form->derivative(state.x, std::span(state.u).first(8), dx);
      split.toHalves(state.x, halves);
      for (std::size_t kind = 0; kind < 2; ++kind) {  // heights, rates
        for (std::size_t half = 0; half < 2; ++half) {
          double eta = 0.0;
          for (std::size_t j = 0; j < 4; ++j) eta += split.mixing()[4 * half + j] * state.u[4 * kind + j];
          u[2 * half + kind] = eta;
        }
      }
      split.bounce().derivative(std::span(halves).first(4), std::span(u).first(2), std::span(rates).first(4));
      split.pitch().derivative(std::span(halves).last(4), std::span(u).last(2), std::span(rates).last(4));
      split.fromHalves(rates, led_back);
      double largest = 0.0;
      for (std::size_t i = 4; i < 8; ++i) largest = std::max(largest, std::abs(dx[i]));
      for (std::size_t i = 0; i < 8; ++i) worst = std::max(worst, std::abs(led_back[i] - dx[i]) / largest);
    }
    EXPECT_WITHIN(worst, 0.0, 2e-15) << vehicle.name;
  }
}

// Of the paper's four published modes two belong to bounce, two to pitch (docs/theory/errata.md); seven digits.
TEST(FlatSplit, TheTwoHalvesShareThePapersFourModes) {
  const auto form = buildFlatForm(compile(paperVehicle(), kGravity));
  const FlatSplit split(*form);
  const auto bounce = test::oscillationsOf(split.bounce().linear()->A);
  const auto pitch = test::oscillationsOf(split.pitch().linear()->A);
  ASSERT_EQ(bounce.size(), 2u);
  ASSERT_EQ(pitch.size(), 2u);
  EXPECT_WITHIN(std::abs(bounce[0] - std::complex(-0.883650, 7.932963)), 0.0, 1e-6);
  EXPECT_WITHIN(std::abs(bounce[1] - std::complex(-9.759625, 29.906134)), 0.0, 1e-6);
  EXPECT_WITHIN(std::abs(pitch[0] - std::complex(-3.143758, 21.635387)), 0.0, 1e-6);
  EXPECT_WITHIN(std::abs(pitch[1] - std::complex(-25.567453, 28.927097)), 0.0, 1e-6);
}

TEST(FlatSplit, BounceDoesNotKnowTheCarbodysPitchInertia) {
  const auto light = buildFlatForm(compile(paperVehicle(70e3), kGravity));
  const auto heavy = buildFlatForm(compile(paperVehicle(686465.5), kGravity));
  EXPECT_EQ(FlatSplit(*light).bounce().linear()->A, FlatSplit(*heavy).bounce().linear()->A);
  EXPECT_NE(FlatSplit(*light).pitch().linear()->A, FlatSplit(*heavy).pitch().linear()->A);
}

// A sum and a difference of two bogies, each rounded once.
TEST(FlatSplit, TheWayThereAndBackLeavesTheStateAsItWas) {
  const auto form = buildFlatForm(compile(reversedVehicle(), kGravity));
  const FlatSplit split(*form);
  std::vector<double> halves(8), back(8);
  for (const RandomState& state : randomStates(50, 8, 4)) {
    split.toHalves(state.x, halves);
    split.fromHalves(halves, back);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_WITHIN(back[i], state.x[i], 0.2 * 0x1p-52);
  }
  // The leading bogie alone is lifted: half of it is bounce, half pitch.
  std::vector<double> lifted(8, 0.0);
  lifted[static_cast<std::size_t>(form->stateOrder()[2])] = 4e-3;
  split.toHalves(lifted, halves);
  EXPECT_EQ(halves, (std::vector<double>{0.0, 2e-3, 0.0, 0.0, 0.0, 2e-3, 0.0, 0.0}));
}

TEST(FlatSplit, AnAsymmetricVehicleIsToldWhatDiffers) {
  EXPECT_EQ(splitUnsupported(*buildFlatForm(compile(paperVehicle(), kGravity))), "");
  Vehicle heavier = paperVehicle();
  named(heavier.bodies, "rear_bogie").mass = 9.5e3;
  const auto form = buildFlatForm(compile(heavier, kGravity));
  const std::string unsupported = splitUnsupported(*form);
  EXPECT_EQ(unsupported,
            "bounce and pitch are independent only where front and rear of a vehicle are equal, and here they differ: "
            "mass of the front bogie = 9000 kg, of the rear one = 9500 kg");
  try {
    (void)FlatSplit(*form);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), unsupported);
  }
  const std::string all = splitUnsupported(*buildFlatForm(compile(asymmetricVehicle(), kGravity)));
  for (const char* what : {"mass of the front bogie", "arm of", "stiffness of the front secondary",
                           "damping of the front secondary", "primary stiffness of wheel 1", "of wheel 4"}) {
    EXPECT_NE(all.find(what), std::string::npos) << what << " in: " << all;
  }
}

TEST(FlatSplit, APrintedVariantIsRefused) {
  const auto form = buildFlatForm(compile(paperVehicle(), kGravity), FlatVariant::kPrinted7);
  EXPECT_EQ(splitUnsupported(*form),
            "bounce and pitch are independent in the form flat only; this is a printed variant");
}

}  // namespace
}  // namespace vehicle::test
