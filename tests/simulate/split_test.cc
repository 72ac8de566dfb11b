// rk4_split: bounce and pitch apart.

#include <gtest/gtest.h>

#include "tests/simulate/histories.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

void expectSameBits(const RunResult& actual, const RunResult& reference, const std::string& what) {
  ASSERT_EQ(actual.history.samples(), reference.history.samples()) << what;
  for (std::size_t column = 0; column < reference.history.columns().size(); ++column) {
    EXPECT_EQ(actual.history.column(column), reference.history.column(column))
        << what << ": " << reference.history.columns()[column].name;
  }
  EXPECT_EQ(actual.statistics.steps, reference.statistics.steps) << what;
  EXPECT_EQ(actual.statistics.evaluations, reference.statistics.evaluations) << what;
}

// The split rounds sums and differences of the bogies and of the rail that the whole rounds in other places: each
// step leaves some roundings of 2^-53 in either, and what is left of them decays with the slowest mode (0.88/s), which
// remembers some 1100 steps of 1 ms. As random signs that is sqrt(1100) = 33, with the dozen roundings of a
// step some 100; forces are differences of displacements some ten times their elongation, hence 1000. A wrong
// coefficient shows at 1e-3 of peak, which is 1e13 roundings.
constexpr double kRoundings = 1000.0 * 0x1p-53;

TEST(Split, DiffersFromTheWholeByRoundingAlone) {
  for (const Vehicle& vehicle : {paperVehicle(), paperVehicle(686465.5), heightsVehicle()}) {
    for (const History history : {History::kOnset, History::kExtended}) {
      const Scenario scenario = paperScenario(history);
      const RunResult whole = run(vehicle, scenario, "flat", "rk4");
      const RunResult split = run(vehicle, scenario, "flat", "rk4_split");
      EXPECT_WITHIN(historyError(split.history, whole.history), 0.0, kRoundings) << vehicle.name;
      EXPECT_EQ(split.statistics.steps, whole.statistics.steps);
      EXPECT_EQ(split.scheme, "serial");
    }
  }
}

TEST(Split, TwoThreadsGiveTheBitsOfOne) {
  for (const Vehicle& vehicle : {paperVehicle(), heightsVehicle()}) {
    for (const double speed : {20.0 / 3.6, 80.0 / 3.6, 150.0 / 3.6}) {
      RunChoice choice;
      choice.speed = speed;
      const Scenario scenario = paperScenario(History::kOnset);
      const RunResult one = run(vehicle, scenario, "flat", "rk4_split", choice);
      choice.sharing.threads = 2;
      const RunResult two = run(vehicle, scenario, "flat", "rk4_split", choice);
      EXPECT_EQ(two.scheme, "split");
      EXPECT_EQ(two.threads, 2);
      EXPECT_EQ(two.team.members.size(), 2u);
      expectSameBits(two, one, vehicle.name);
    }
  }
}

TEST(Split, StartsFromAnyStateAndEndsEarlyWhenToldTo) {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.initial_state.from = InitialRest::kPeriodic;
  InitialBody bogie;
  bogie.name = "rear_bogie";
  bogie.z = -2e-3;
  bogie.z_rate = 0.03;
  scenario.initial_state.bodies = {bogie};
  const RunResult whole = run(paperVehicle(), scenario, "flat", "rk4");
  for (const int threads : {1, 2}) {
    RunChoice choice;
    choice.sharing.threads = threads;
    const RunResult split = run(paperVehicle(), scenario, "flat", "rk4_split", choice);
    EXPECT_WITHIN(historyError(split.history, whole.history), 0.0, kRoundings);
    choice.form = "flat";
    choice.method = "rk4_split";
    const RunResult some = simulate(paperVehicle(), scenario, choice, [](double share) { return share < 0.5; });
    EXPECT_TRUE(some.statistics.stopped);
    EXPECT_GT(some.history.samples(), 900u);
    EXPECT_LT(some.history.samples(), 1400u);
  }
}

// Both threads: each steps its half of the vehicle, and every 16th of its steps is a span of its own.
TEST(Split, ItsStepsAreTracedOnBothThreads) {
  RunChoice choice;
  choice.sharing.threads = 2;
  const RunResult plain = run(paperVehicle(), paperScenario(History::kOnset), "flat", "rk4_split", choice);
  Tracer tracer(16);
  choice.team.tracer = &tracer;
  const RunResult traced = run(paperVehicle(), paperScenario(History::kOnset), "flat", "rk4_split", choice);
  EXPECT_EQ(historyError(traced.history, plain.history), 0.0);
  const Trace trace = tracer.trace();
  const long steps = traced.statistics.steps;
  EXPECT_EQ(trace.traced_steps, (steps + 15) / 16);
  long spans[2] = {0, 0};
  for (const Span& span : trace.spans) {
    EXPECT_EQ(span.step % 16, 0);
    EXPECT_LT(span.step, steps);
    ++spans[span.thread];
  }
  EXPECT_EQ(spans[0], trace.traced_steps);
  EXPECT_EQ(spans[1], trace.traced_steps);
  EXPECT_EQ(trace.steps.count, steps);
}

std::string refusal(const Vehicle& vehicle, const std::string& form, const std::string& method, int threads) {
  try {
    RunChoice choice;
    choice.sharing.threads = threads;
    (void)run(vehicle, paperScenario(History::kOnset), form, method, choice);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Split, IsRefusedWhereBounceAndPitchDoNotPart) {
  Vehicle heavier = paperVehicle();
  named(heavier.bodies, "rear_bogie").mass = 9.5e3;
  const std::string why =
      "rk4_split: bounce and pitch are independent only where front and rear of a vehicle are equal, and here they "
      "differ: "
      "mass of the front bogie = 9000 kg, of the rear one = 9500 kg; take rk4";
  EXPECT_EQ(refusal(heavier, "flat", "rk4_split", 1), why);
  EXPECT_EQ(refusal(heavier, "flat", "rk4_split", 2), why);
  EXPECT_EQ(methodUnsupported("rk4_split", "flat", compile(heavier, 9.81)), why);
  EXPECT_EQ(methodUnsupported("rk4_split", "flat", compile(paperVehicle(), 9.81)), "");
  EXPECT_EQ(methodUnsupported("rk4_split", "flat", compile(bogiePitchVehicle(), 9.81)), "");
  EXPECT_EQ(refusal(paperVehicle(), "matrix", "rk4_split", 1),
            "the method rk4_split runs the form flat, not matrix; take rk4");
  const std::string gone = refusal(paperVehicle(), "flat", "exact_split", 1);
  EXPECT_TRUE(gone.starts_with("method \"exact_split\" is unknown; ")) << gone;
  EXPECT_EQ(refusal(paperVehicle(), "flat", "rk4_split", 3),
            "rk4_split has two parts, bounce and pitch: it runs on 1 or 2 threads, not on 3");
}

}  // namespace
}  // namespace vehicle::test
