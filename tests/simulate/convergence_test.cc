// Convergence of the fixed-step method on smooth and rails with breakpoints, against the exact method.

#include <gtest/gtest.h>

#include "tests/simulate/histories.h"
#include "tests/support/tolerance.h"
#include "tests/support/trains.h"

namespace vehicle::test {
namespace {

Scenario dipScenario() {
  Scenario scenario = paperScenario(History::kOnset);
  scenario.track->harmonics.clear();
  Dip dip;
  dip.shape = DipShape::kHalfSine;
  dip.depth = 8e-3;
  dip.length = 7.3;
  dip.start = 11.7;
  scenario.track->dips = {dip};
  scenario.run.duration = 3.0;
  return scenario;
}

Scenario rampScenario() {
  Scenario scenario = paperScenario(History::kOnset);
  scenario.track->harmonics.clear();
  Ramp ramp;
  ramp.rise = 20e-3;
  ramp.length = 13.1;
  ramp.start = 3.3;
  scenario.track->ramps = {ramp};
  scenario.run.duration = 3.0;
  return scenario;
}

// Halving every step of every interval divides the error of order 4 by 16. The largest error of the whole run and
// all columns is compared: at a single instant it may pass through zero. At |lambda| h <= 0.1 the next term
// changes the ratio by a few percent; rounding (1e-13) is four decades below the smaller error.
double errorRatio(const Vehicle& vehicle, const Scenario& scenario, const std::string& form) {
  const TimeHistory exact = run(vehicle, scenario, form, "exact").history;
  RunChoice coarse;
  coarse.step = 2.5e-3;
  RunChoice fine = coarse;
  fine.refine = 2;
  const double coarseError = historyError(run(vehicle, scenario, form, "rk4", coarse).history, exact);
  const double fineError = historyError(run(vehicle, scenario, form, "rk4", fine).history, exact);
  EXPECT_GT(fineError, 1e-12) << "too close to rounding to show an order";
  return coarseError / fineError;
}

TEST(Rk4, DoublingTheStepsDividesTheErrorBySixteenOnEveryRail) {
  const std::pair<const char*, Scenario> rails[] = {{"extended", paperScenario(History::kExtended)},
                                                    {"onset", paperScenario(History::kOnset)},
                                                    {"half_sine dip", dipScenario()},
                                                    {"ramp", rampScenario()}};
  for (const auto& [name, scenario] : rails) {
    const double ratio = errorRatio(paperVehicle(), scenario, "flat");
    EXPECT_GT(ratio, 15.0) << name;
    EXPECT_LT(ratio, 17.0) << name;
  }
}

TEST(Rk4, DoublingTheStepsDividesTheErrorBySixteenForAnAsymmetricVehicle) {
  const double ratio = errorRatio(asymmetricVehicle(), paperScenario(History::kOnset), "matrix");
  EXPECT_GT(ratio, 15.0);
  EXPECT_LT(ratio, 17.0);
}

TEST(Rk4, DoublingTheStepsDividesTheErrorBySixteenForATrain) {
  for (const History history : {History::kOnset, History::kExtended}) {
    Scenario scenario = paperScenario(history);
    scenario.run.duration = 5.0;
    const double ratio = errorRatio(assembled(mixedTrain()), scenario, "flat");
    EXPECT_GT(ratio, 15.0);
    EXPECT_LT(ratio, 17.0);
  }
}

}  // namespace
}  // namespace vehicle::test
