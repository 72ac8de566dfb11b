// Runs of trains: the vehicles that hang together, and what is chosen or refused because there are many.
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/simulate/histories.h"
#include "tests/support/tolerance.h"
#include "tests/support/trains.h"

namespace vehicle::test {
namespace {

Scenario shortScenario(History history, double duration) {
  Scenario made = paperScenario(history);
  made.run.duration = duration;
  return made;
}

// A coupling without spring and damper adds +0 to every sum: not a bit may change.
TEST(TrainRun, CouplingsOfNoStiffnessChangeNoBit) {
  Train slack = mixedTrain();
  for (Coupling& each : slack.couplings) each.stiffness_z = each.damping_z = 0.0;
  Train loose = mixedTrain();
  loose.couplings.clear();
  const Scenario scenario = shortScenario(History::kOnset, 2.0);
  for (const char* form : {"flat", "matrix"}) {
    const TimeHistory coupled = run(assembled(slack), scenario, form, "rk4").history;
    const TimeHistory alone = run(assembled(loose), scenario, form, "rk4").history;
    for (const Channel& column : alone.columns()) {
      EXPECT_EQ(coupled.column(column.name), alone.column(column.name)) << form << " " << column.name;
    }
  }
}

// The leading vehicle meets the rail as it would without the others. Places and arms are its own, so what differs is
// the order of sums in a larger matrix exponential: 1e-13 as everywhere.
TEST(TrainRun, TheLeadingVehicleOfAnUncoupledTrainRunsAsIfAlone) {
  Train train = equalTrain(paperVehicle(), 3, 16.0);
  train.couplings.clear();
  const Scenario scenario = shortScenario(History::kOnset, 5.0);
  const TimeHistory together = run(assembled(train), scenario, "flat", "exact").history;
  const TimeHistory alone = run(paperVehicle(), scenario, "flat", "exact").history;
  for (std::size_t i = 1; i < alone.columns().size(); ++i) {
    const std::string& name = alone.columns()[i].name;
    EXPECT_WITHIN(columnError(together.column("coach_1." + name), alone.column(name)), 0.0, 2e-13) << name;
  }
}

// The paper's three sections over its own rail, coupled: three ways to write the equations, one way to integrate.
TEST(TrainRun, AllLinearFormsGiveOneResult) {
  const Vehicle train = assembled(equalTrain(paperVehicle(), 3, 16.0));
  for (const History history : {History::kOnset, History::kExtended}) {
    const Scenario scenario = shortScenario(history, 4.0);
    const TimeHistory flat = run(train, scenario, "flat", "exact").history;
    // Coupling deflections are small differences of bounce and pitch: a digit less than the columns of bodies.
    EXPECT_WITHIN(historyError(run(train, scenario, "matrix", "exact").history, flat), 0.0, 2e-12);
    EXPECT_WITHIN(historyError(run(train, scenario, "mbs-linear", "exact").history, flat), 0.0, 2e-12);
  }
}

// Eight flat vehicles have 64 states. Dopri5 at its tolerance of 1e-10 a step; errors add up over the memory of a train
// of about a second: 1e-7 of the peak leaves a decade.
TEST(TrainRun, LongTrainsAreRunByDopri5UnlessToldOtherwise) {
  const Scenario scenario = shortScenario(History::kExtended, 2.0);
  EXPECT_EQ(simulate(assembled(equalTrain(paperVehicle(), 8, 16.0)), scenario).method, "exact");
  const Vehicle nine = assembled(equalTrain(paperVehicle(), 9, 16.0));
  const RunResult result = simulate(nine, scenario);
  EXPECT_EQ(result.form, "flat");
  EXPECT_EQ(result.method, "dopri5");
  EXPECT_EQ(defaultMethod("flat", topologyOf(nine)), "dopri5");
  EXPECT_EQ(defaultMethod("flat", topologyOf(paperVehicle())), "exact");
  EXPECT_WITHIN(historyError(result.history, run(nine, scenario, "flat", "exact").history), 0.0, 1e-7);
}

std::string refusalOf(const Vehicle& vehicle, const Scenario& scenario, const std::string& method) {
  try {
    (void)run(vehicle, scenario, "flat", method);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "not refused";
}

TEST(TrainRun, RefusesWhatIsNotForTrains) {
  const Scenario scenario = shortScenario(History::kExtended, 1.0);
  EXPECT_EQ(refusalOf(assembled(equalTrain(paperVehicle(), 2, 16.0)), scenario, "rk4_split"),
            "rk4_split: couplings join the bounce and pitch of a train's vehicles; take rk4");
  EXPECT_EQ(refusalOf(assembled(equalTrain(paperVehicle(), 251, 16.0)), scenario, "exact"),
            "the form flat has 2008 states here, and its matrices are formed for at most 2000; take the method rk4 or "
            "dopri5, which need none");
}

}  // namespace
}  // namespace vehicle::test
