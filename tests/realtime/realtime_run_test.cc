#include "libvehicle/realtime/realtime_run.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/simulate/forms.h"
#include "tests/simulate/histories.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

Scenario railFor(double duration, History history = History::kExtended) {
  Scenario scenario = test::paperScenario(history);
  scenario.run.duration = duration;
  return scenario;
}

// Normal priority: a test should not ask for more than every machine gives.
RunChoice flatRun() {
  RunChoice choice;
  choice.form = "flat";
  return choice;
}

TEST(RealtimeRun, EveryStepIsMadeAndTheStatesAreThoseOfTheRunWithoutAClock) {
  const Scenario scenario = railFor(0.3);
  const RealtimeRun run = simulateRealtime(compile(test::paperVehicle(), 9.81), scenario, flatRun(), 1e-3);
  EXPECT_EQ(run.report.steps, 300);
  EXPECT_EQ(run.steps, 300);
  EXPECT_EQ(run.states_read + run.report.outputs_lost, 300);
  // A machine that stands still for 50 ms gets rows too late: then they were held, and that is told.
  if (run.report.inputs_held > 0) return;
  EXPECT_TRUE(run.same_bits);

  RunChoice choice = flatRun();
  choice.method = "rk4";
  const TimeHistory offline = simulate(test::paperVehicle(), scenario, choice).history;
  const auto system = buildForm("flat", compile(test::paperVehicle(), scenario.gravity));
  ASSERT_EQ(run.state.size(), system->states().size());
  for (std::size_t i = 0; i < run.state.size(); ++i) {
    const std::vector<double> column = offline.column(system->states()[i].name);
    // The same steps; the rail is evaluated here and swept there, which differ by some 1e-16 of its amplitude a step
    // (Input::sweepError). An input that is wrong by one step would show at 1e-2.
    EXPECT_WITHIN(run.state[i], column.back(), 1e-12 * test::peakOf(column)) << system->states()[i].name;
  }
}

// The onset begins under each wheelset at a time of its own, inside a period of 4 ms: steps end there, as in a run
// without a clock.
TEST(RealtimeRun, StepsEndOnBreakpointsInsideAPeriodInAnyForm) {
  RunChoice choice;
  choice.form = "matrix";
  const Scenario scenario = railFor(2.0, History::kOnset);
  const RealtimeRun run = simulateRealtime(compile(test::paperVehicle(), 9.81), scenario, choice, 4e-3);
  EXPECT_EQ(run.form, "matrix");
  EXPECT_EQ(run.report.steps, 500);
  EXPECT_GE(run.report.response.most, run.report.step.least);
  if (run.report.inputs_held > 0) return;  // the machine stood still, and the report says so
  EXPECT_TRUE(run.same_bits);

  choice.method = "rk4";
  choice.step = 4e-3;
  const TimeHistory offline = simulate(test::paperVehicle(), scenario, choice).history;
  const auto system = buildForm("matrix", compile(test::paperVehicle(), scenario.gravity));
  for (std::size_t i = 0; i < run.state.size(); ++i) {
    const std::vector<double> column = offline.column(system->states()[i].name);
    // Output samples 5 ms apart end steps too, so the two runs step differently: what rk4 errs by at 4 ms.
    EXPECT_WITHIN(run.state[i], column.back(), 1e-5 * test::peakOf(column)) << system->states()[i].name;
  }
}

TEST(RealtimeRun, IsStoppedFromOutsideInTheMiddle) {
  // An hour, of which the first state that has come back is enough: the run ends long before on any machine.
  const RealtimeRun run = simulateRealtime(compile(test::paperVehicle(), 9.81), railFor(3600.0), flatRun(), 1e-3,
                                           [](double share) { return share == 0.0; });
  EXPECT_TRUE(run.report.stopped);
  EXPECT_GT(run.report.steps, 0);
  EXPECT_LT(run.report.steps, run.steps);
  EXPECT_EQ(run.steps, 3600000);
}

std::string refusal(const Scenario& scenario, double period) {
  try {
    static_cast<void>(simulateRealtime(compile(test::paperVehicle(), 9.81), scenario, flatRun(), period));
  } catch (const std::invalid_argument& wrong) {
    return wrong.what();
  }
  return "";
}

TEST(RealtimeRun, APeriodThatDoesNotFitIsRefusedWithTheRule) {
  EXPECT_EQ(refusal(railFor(0.3), 0.0), "realtime: period = 0 s, must be between 1e-6 s and 3600 s");
  EXPECT_EQ(refusal(railFor(0.3), std::nan("")), "realtime: period = nan s, must be between 1e-6 s and 3600 s");
  EXPECT_EQ(refusal(railFor(0.3), 1e-7), "realtime: period = 1e-07 s, must be between 1e-6 s and 3600 s");
  EXPECT_EQ(refusal(railFor(0.3), 0.5), "realtime: period = 0.5 s gives 0 steps in 0.3 s, must be 1..10000000");
}

}  // namespace
}  // namespace vehicle
