// How a run starts, what may be chosen, and how it is refused.

#include <gtest/gtest.h>

#include "tests/simulate/histories.h"
#include "tests/support/refusal.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

// A level rail 5 mm up is a new rest: nothing moves, every displacement is 5 mm. Rounding of one 8 x 8 solve.
TEST(InitialState, OnRailStandsStillOnARaisedTrack) {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.track->harmonics.clear();
  Ramp ramp;
  ramp.rise = 5e-3;
  ramp.length = 1.0;
  ramp.start = -100.0;
  scenario.track->ramps = {ramp};
  scenario.initial_state.from = InitialRest::kOnRail;
  for (const char* form : {"flat", "matrix", "mbs-linear"}) {
    const TimeHistory history = run(asymmetricVehicle(), scenario, form, "exact").history;
    for (const double z : history.column("carbody.z")) EXPECT_WITHIN(z, 5e-3, 1e-14) << form;
    for (const double a : history.column("carbody.az")) EXPECT_WITHIN(a, 0.0, 1e-10) << form;
  }
}

// From the steady state nothing decays: the second period repeats the first.
TEST(InitialState, PeriodicRepeatsItselfFromTheFirstPeriod) {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.initial_state.from = InitialRest::kPeriodic;
  scenario.run.duration = 2.5;  // two periods of 25 m at 20 m/s
  const std::vector<double> z = run(paperVehicle(), scenario, "flat", "exact").history.column("carbody.z");
  const std::size_t period = 250;
  for (std::size_t i = 0; i + period < z.size(); ++i) EXPECT_WITHIN(z[i + period], z[i], 1e-15);
}

TEST(InitialState, ListedBodiesAreAddedInEveryForm) {
  Scenario scenario = paperScenario(History::kOnset);
  InitialBody carbody;
  carbody.name = "carbody";
  carbody.z = -3.1e-3;
  carbody.pitch = 1.2e-3;
  carbody.z_rate = 22e-3;
  carbody.pitch_rate = -8.5e-3;
  scenario.initial_state.bodies = {carbody};
  for (const char* form : {"flat", "matrix", "mbs-linear", "mbs"}) {
    const TimeHistory history = run(asymmetricVehicle(), scenario, form, "rk4").history;
    EXPECT_EQ(history.column("carbody.z")[0], -3.1e-3) << form;
    EXPECT_EQ(history.column("carbody.pitch")[0], 1.2e-3) << form;
    EXPECT_EQ(history.column("carbody.vz")[0], 22e-3) << form;
    EXPECT_EQ(history.column("carbody.pitch_rate")[0], -8.5e-3) << form;
  }
}

TEST(Simulate, TakesFlatAndExactWhereTheyFitAndSaysSo) {
  const RunResult paper = simulate(paperVehicle(), paperScenario(History::kOnset));
  EXPECT_EQ(paper.form, "flat");
  EXPECT_EQ(paper.method, "exact");
  const RunResult coach = simulate(bogiePitchVehicle(), paperScenario(History::kOnset));
  EXPECT_EQ(coach.form, "matrix");
  RunChoice nonlinear;
  nonlinear.form = "mbs";
  EXPECT_EQ(simulate(paperVehicle(), paperScenario(History::kOnset), nonlinear).method, "dopri5");
}

// What simulate says of a choice that differs from the default in one thing.
template <class Change>
std::string refusal(Change change) {
  RunChoice choice;
  change(choice);
  return refusalOf([&] { (void)simulate(paperVehicle(), paperScenario(History::kOnset), choice); });
}

TEST(Simulate, RefusesWrongChoicesWithNameValueAndRule) {
  EXPECT_EQ(refusal([](RunChoice& c) { c.form = "flatt"; }), "form \"flatt\" is unknown; did you mean \"flat\"?");
  EXPECT_EQ(refusal([](RunChoice& c) { c.form = "finite-elements"; }),
            "form \"finite-elements\" is unknown; choose one of flat, matrix, mbs-linear, mbs, flat-7-printed, "
            "flat-literal, flat-literal-mb");
  EXPECT_EQ(refusal([](RunChoice& c) { c.method = "rk5"; }), "method \"rk5\" is unknown; did you mean \"rk4\"?");
  EXPECT_EQ(refusal([](RunChoice& c) { c.form = "mbs", c.method = "exact"; }),
            "the method exact needs a linear form, and mbs is nonlinear; take dopri5, or the form mbs-linear");
  EXPECT_EQ(refusal([](RunChoice& c) { c.form = "flat", c.method = "simbody_rkm"; }),
            "the method simbody_rkm runs the forms mbs and mbs-linear, not flat; take another method");
  EXPECT_EQ(refusal([](RunChoice& c) { c.step = 0.0; }), "step = 0 s, must be finite and > 0");
  EXPECT_EQ(refusal([](RunChoice& c) { c.step = NAN; }), "step = nan s, must be finite and > 0");
  EXPECT_EQ(refusal([](RunChoice& c) { c.refine = 0; }), "refine = 0, must be >= 1");
  EXPECT_EQ(refusal([](RunChoice& c) { c.speed = -3.0; }), "speed = -3 m/s, must be finite and > 0");
}

// |lambda| h > 2.8 is outside the stability region of rk4: the run must end by itself with the reason.
TEST(Simulate, EndsAnUnstableRunWithTheTimeReached) {
  Scenario scenario = paperScenario(History::kOnset);
  scenario.run.output_step = 1.0;
  scenario.run.duration = 2000.0;
  try {
    RunChoice choice;
    choice.step = 1.0;
    (void)run(paperVehicle(), scenario, "flat", "rk4", choice);
    FAIL() << "an unstable step was not noticed";
  } catch (const RunFailed& failure) {
    EXPECT_NE(std::string(failure.what()).find("flat with rk4: "), std::string::npos) << failure.what();
    EXPECT_NE(std::string(failure.what()).find(" s"), std::string::npos) << failure.what();
  }
}

TEST(Simulate, EndsWithWhatThereIsWhenProgressSaysStop) {
  const RunResult result =
      simulate(paperVehicle(), paperScenario(History::kOnset), {}, [](double share) { return share < 0.5; });
  EXPECT_TRUE(result.statistics.stopped);
  EXPECT_GT(result.history.samples(), 900u);
  EXPECT_LT(result.history.samples(), 1400u);
}

// A sample on a breakpoint holds the right-hand limit: with `onset` the leading wheel's rail rises from t = 0 on, so
// the leading bogie is accelerated there already (bb eta'/mb), as in the certified solution.
TEST(Simulate, SampleOnABreakpointHoldsTheRightHandLimit) {
  const double w = 2.0 * M_PI * 20.0 / 25.0;
  const double rate = 5e-3 * w + 2e-3 * 3.0 * w;
  for (const char* method : {"exact", "rk4", "dopri5"}) {
    const TimeHistory history = run(paperVehicle(), paperScenario(History::kOnset), "flat", method).history;
    EXPECT_WITHIN(history.column("front_bogie.az")[0], 30e3 * rate / 9e3, 1e-15) << method;
  }
}

}  // namespace
}  // namespace vehicle::test
