#include "libvehicle/law/linear_spring_damper.h"

#include <gtest/gtest.h>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

const LinearSpringDamper kLaw(2.66e6, 1.0e5);  // [N/m, N s/m]
const LawPoint kPoint{.elongation = 0.013, .rate = -0.21};

TEST(LinearSpringDamper, PullsItsEndsTogetherByStiffnessAndDamping) {
  EXPECT_EQ(kLaw.force(kPoint), 2.66e6 * 0.013 - 1.0e5 * 0.21);
  EXPECT_EQ(kLaw.force({}), 0.0);
}

// What the suspension does work with is stored or becomes heat:  f v = d(stored)/dt + dissipated,  d(stored)/dt taken
// as a central difference of the stored energy along the motion.
TEST(LinearSpringDamper, ForceTimesRateIsWhatIsStoredAndWhatIsDissipated) {
  const double dt = 1e-4;  // [s]
  const auto stored = [](double time) {
    return kLaw.storedEnergy({.elongation = kPoint.elongation + time * kPoint.rate});
  };
  const double storing = (stored(dt) - stored(-dt)) / (2.0 * dt);
  // A central difference of a square is exact: rounding of 450 J over 2e-4 s, 2^-53 * 450 / 2e-4 = 3e-10 W.
  EXPECT_WITHIN(kLaw.force(kPoint) * kPoint.rate, storing + kLaw.dissipatedPower(kPoint), 1e-8);
  EXPECT_GT(kLaw.dissipatedPower(kPoint), 0.0);
  EXPECT_EQ(kLaw.dissipatedPower({.elongation = 0.1}), 0.0);
}

TEST(LinearSpringDamper, SlopesAreThoseOfTheForceEverywhere) {
  const LawSlopes slopes = kLaw.slopes(kPoint);
  // Differences of a linear function are its slope; the bound is their rounding, 2^-53 * 6e4 N / 1e-3 = 7e-9 of 1e6.
  const double by_elongation = (kLaw.force({.elongation = 0.014, .rate = -0.21}) - kLaw.force(kPoint)) / 1e-3;
  const double by_rate = (kLaw.force({.elongation = 0.013, .rate = -0.209}) - kLaw.force(kPoint)) / 1e-3;
  EXPECT_WITHIN(by_elongation, slopes.elongation, 1e-6 * slopes.elongation);
  EXPECT_WITHIN(by_rate, slopes.rate, 1e-6 * slopes.rate);
  EXPECT_TRUE(kLaw.isLinear());
}

TEST(LinearSpringDamper, HasNoStatesOfItsOwnAndNoEvents) {
  EXPECT_TRUE(kLaw.internalStates().empty());
  EXPECT_EQ(kLaw.modes(), 1);
  EXPECT_EQ(kLaw.events(0), 0);
}

}  // namespace
}  // namespace vehicle
