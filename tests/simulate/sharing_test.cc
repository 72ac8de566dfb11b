// A run on threads through simulate(): the bits of the serial run, the names it answers with, and how it is refused.

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/simulate/histories.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

Scenario dipScenario() {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.track->harmonics.clear();
  Dip dip;
  dip.depth = 8e-3;
  dip.length = 3.0;
  dip.start = 10.0;
  scenario.track->dips = {dip};
  return scenario;
}

Scenario rigScenario() {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.track.reset();
  scenario.rig.emplace();
  for (int wheel = 1; wheel <= 4; ++wheel) {
    RigInput input;
    input.wheelset = "wheelset_" + std::to_string(wheel);
    RigSine sine;
    sine.amplitude = 1e-3 * wheel;
    sine.angular_frequency = 4.0 + 7.0 * wheel;
    sine.phase = 0.3 * wheel;
    input.sines = {sine};
    scenario.rig->inputs.push_back(input);
  }
  return scenario;
}

Scenario shortened(Scenario scenario) {
  scenario.run.duration = 3.0;  // all wheels have passed their breakpoints at 20 km/h
  return scenario;
}

/// A scheme by its name; none where the choice is left open.
std::optional<Scheme> schemeNamed(const std::string& name) {
  return name.empty() ? std::nullopt : std::optional(schemeOf(name));
}

/// Every way to run, except those that do not fit.
struct Asked {
  const char* method;
  const char* scheme;
  std::vector<int> threads;
};
const std::vector<Asked> kAsked = {
    {"rk4", "stages", {1, 2, 4}}, {"rk4", "halo", {1, 2, 3}}, {"rk4", "pipeline", {1, 2, 5}}, {"rk4", "", {2, 3}}};

void expectSerialBits(const Vehicle& vehicle, const Scenario& scenario, double speed) {
  RunChoice choice;
  choice.speed = speed;
  for (const Asked& asked : kAsked) {
    choice.sharing = {};
    const RunResult serial = run(vehicle, scenario, "flat", asked.method, choice);
    EXPECT_EQ(serial.scheme, "serial");
    EXPECT_EQ(serial.threads, 1);
    choice.sharing.scheme = schemeNamed(asked.scheme);
    for (const int threads : asked.threads) {
      choice.sharing.threads = threads;
      const RunResult shared = run(vehicle, scenario, "flat", asked.method, choice);
      const std::string what =
          vehicle.name + " " + asked.method + " by " + shared.scheme + " on " + std::to_string(threads);
      EXPECT_EQ(shared.threads, threads) << what;
      EXPECT_EQ(shared.team.members.size(), static_cast<std::size_t>(threads)) << what;
      if (choice.sharing.scheme) {
        EXPECT_EQ(shared.scheme, asked.scheme);
      }
      EXPECT_EQ(shared.statistics.steps, serial.statistics.steps) << what;
      ASSERT_EQ(shared.history.samples(), serial.history.samples()) << what;
      for (std::size_t column = 0; column < serial.history.columns().size(); ++column) {
        ASSERT_EQ(shared.history.column(column), serial.history.column(column))
            << what << ": " << serial.history.columns()[column].name;
      }
    }
  }
}

TEST(Sharing, GivesTheSerialBitsAtEverySpeedOfThePapersVehicle) {
  for (const double kmh : {20.0, 55.0, 80.0, 110.0, 150.0}) {
    expectSerialBits(paperVehicle(), shortened(paperScenario(History::kOnset)), kmh / 3.6);
  }
}

TEST(Sharing, GivesTheSerialBitsForAsymmetricVehiclesAndHeights) {
  expectSerialBits(asymmetricVehicle(), shortened(paperScenario(History::kOnset)), 20.0);
  expectSerialBits(heightsVehicle(), shortened(paperScenario(History::kExtended)), 20.0);
}

TEST(Sharing, GivesTheSerialBitsOnDipsAndOnARig) {
  expectSerialBits(paperVehicle(), shortened(dipScenario()), 20.0);
  expectSerialBits(asymmetricVehicle(), shortened(rigScenario()), 20.0);
}

TEST(Sharing, AutoGivesTheSerialBitsAndSaysWhatItTook) {
  const Scenario scenario = shortened(paperScenario(History::kOnset));
  for (const char* form : {"flat", "matrix", "mbs", "flat-7-printed"}) {
    for (const char* method : {"rk4", "exact", "dopri5"}) {
      if (!methodUnsupported(method, form).empty()) continue;
      RunChoice choice;
      const RunResult serial = run(paperVehicle(), scenario, form, method, choice);
      choice.sharing.threads = 0;
      const RunResult chosen = run(paperVehicle(), scenario, form, method, choice);
      EXPECT_EQ(historyError(chosen.history, serial.history), 0.0) << form << " " << method;
      EXPECT_EQ(chosen.scheme, "serial") << "three seconds are over before another thread has started";
      EXPECT_FALSE(chosen.decision.reason.empty()) << form << " " << method;
    }
  }
}

// Long enough to be worth a calibration; whatever it finds on this machine, the bits are those of the serial run and
// the answer is complete.
TEST(Sharing, ALongRunIsCalibratedAndKeepsItsBits) {
  Scenario scenario = paperScenario(History::kExtended);
  scenario.run.output_step = 0.05;
  scenario.track->harmonics.clear();
  for (int order = 1; order <= 24; ++order) scenario.track->harmonics.push_back(harmonic(25.0, order, 4e-3 / order));
  RunChoice choice;
  choice.step = 5e-6;
  const RunResult serial = run(paperVehicle(), scenario, "flat", "rk4", choice);
  choice.sharing.threads = 0;
  const RunResult chosen = run(paperVehicle(), scenario, "flat", "rk4", choice);
  EXPECT_EQ(historyError(chosen.history, serial.history), 0.0);
  EXPECT_GT(chosen.decision.step, 0.0) << chosen.decision.reason;
  EXPECT_GT(chosen.decision.input, 0.0) << chosen.decision.reason;
  EXPECT_LT(chosen.decision.calibration, 0.5 * chosen.wall_seconds) << chosen.decision.reason;
  EXPECT_EQ(nameOf(chosen.decision.scheme), chosen.scheme);
  EXPECT_EQ(chosen.decision.threads, chosen.threads);
  ASSERT_FALSE(chosen.decision.candidates.empty());
  EXPECT_EQ(chosen.decision.candidates[0].scheme, Scheme::kSerial);
}

std::string refusal(const std::string& form, const std::string& method, int threads, const std::string& scheme,
                    const std::string& map = "auto") {
  try {
    RunChoice choice;
    choice.sharing.threads = threads;
    choice.sharing.scheme = schemeNamed(scheme);
    choice.sharing.map = equationMapOf(map);
    (void)run(paperVehicle(), shortened(paperScenario(History::kOnset)), form, method, choice);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Sharing, RefusesWhatDoesNotFitWithReasonAndRemedy) {
  EXPECT_EQ(refusal("mbs", "rk4", 2, ""),
            "the form mbs runs on one thread: Simbody computes all of its equations "
            "together; take --threads 1");
  EXPECT_EQ(refusal("flat", "dopri5", 2, ""),
            "the method dopri5 runs on one thread: it chooses each step from the whole state; take --threads 1, or "
            "method rk4");
  EXPECT_EQ(refusal("flat", "exact", 2, ""),
            "the method exact runs on one thread: every thread would have to find the same matrices; take --threads 1, "
            "or method rk4");
  EXPECT_EQ(refusal("flat", "rk4", -1, ""), "threads = -1, must be 1..256, or 0 to let a calibration choose");
  EXPECT_EQ(refusal("flat", "rk4", 2, "serial"),
            "scheme serial runs on one thread, not on 2; take --threads 1, or another scheme");
  EXPECT_EQ(refusal("flat", "rk4", 2, "split"),
            "scheme split does not share the work of rk4; take serial | stages | halo | pipeline");
  EXPECT_EQ(refusal("flat", "rk4", 2, "pipeline", "body"),
            "--map body has no effect with the scheme pipeline, whose threads have no equations of their own; omit "
            "--map, or take scheme stages or halo");
  EXPECT_EQ(refusal("flat", "rk4", 1, "", "body"), "not refused");
  for (const int threads : {0, 2}) {
    EXPECT_EQ(refusal("flat", "rk4_split", threads, "", "body"),
              "--map body has no effect with the method rk4_split, whose threads have no equations of their own; omit "
              "--map, or take method rk4");
  }
  EXPECT_EQ(refusal("mbs", "rk4", 0, "", "body"), refusal("mbs", "rk4", 2, ""));
  EXPECT_EQ(refusal("flat", "rk4", 4, "", "body"),
            "4 threads for 3 bodies: map body gives every thread at least one; take at most 3");
  EXPECT_EQ(refusal("matrix", "rk4", 4, "", "body"), refusal("flat", "rk4", 4, "", "body"));
  EXPECT_EQ(
      refusal("flat", "rk4", 2, "", "paper"),
      "map paper divides the four equations of the source paper's vehicle among four threads; here are 2 threads; "
      "take 4, or map auto or body");
  EXPECT_EQ(refusal("flat", "rk4", 0, "", "paper"), "not refused");
  const std::string many = refusal("flat", "rk4", 5, "stages");
  EXPECT_NE(many.find("5"), std::string::npos) << many;
  EXPECT_NE(many.find("4"), std::string::npos) << many;
  EXPECT_NE(refusal("flat", "rk4", 2, "stages", "paper"), "not refused");
  EXPECT_EQ(refusal("flat", "rk4", 4, "stages", "paper"), "not refused");
}

TEST(Sharing, AutoNamesTheOnlyWayThereIs) {
  const auto reason = [](const char* form, const char* method, const char* scheme) {
    RunChoice choice;
    choice.sharing.threads = 0;
    choice.sharing.scheme = schemeNamed(scheme);
    return run(paperVehicle(), shortened(paperScenario(History::kOnset)), form, method, choice).decision.reason;
  };
  EXPECT_EQ(reason("flat", "dopri5", ""), "serial: there is no other scheme to try");
  EXPECT_EQ(reason("mbs", "rk4", ""), "serial: there is no other scheme to try");
  // On one core it is the scheme's one thread.
  EXPECT_TRUE(reason("flat", "rk4_split", "split").starts_with("split")) << reason("flat", "rk4_split", "split");
}

TEST(Sharing, AutoWeighsOnlyTheThreadsThatTheMapKnows) {
  RunChoice choice;
  choice.sharing.threads = 0;
  choice.sharing.map = EquationMap::kPaper;
  const RunResult made = run(paperVehicle(), shortened(paperScenario(History::kOnset)), "flat", "rk4", choice);
  for (const Candidate& each : made.decision.candidates) {
    EXPECT_EQ(each.threads, each.scheme == Scheme::kSerial ? 1 : 4) << nameOf(each.scheme);
  }
}

std::string workOf(const char* method, const char* scheme, int threads, const char* map = "auto") {
  RunChoice choice;
  choice.sharing.threads = threads;
  choice.sharing.scheme = schemeNamed(scheme);
  choice.sharing.map = equationMapOf(map);
  std::string all;
  for (const ThreadWork& work :
       run(paperVehicle(), shortened(paperScenario(History::kOnset)), "flat", method, choice).work) {
    all += (all.empty() ? "" : " | ") + std::to_string(work.equations) + ": " + work.what;
  }
  return all;
}

TEST(Sharing, AMapWithoutASchemeTakesASchemeThatUsesIt) {
  RunChoice choice;
  choice.sharing.threads = 2;
  const auto schemeFor = [&](const char* map) {
    choice.sharing.map = equationMapOf(map);
    return run(paperVehicle(), shortened(paperScenario(History::kOnset)), "flat", "rk4", choice).scheme;
  };
  EXPECT_EQ(schemeFor("auto"), "pipeline");
  EXPECT_NE(schemeFor("body"), "pipeline");
}

TEST(Sharing, SaysWhichThreadComputesWhichEquations) {
  EXPECT_EQ(workOf("rk4", "stages", 4, "paper"), "1: rear_bogie bounce (5) | 1: carbody bounce (2), the rail (6) | "
                                                 "1: carbody pitch (3) | 1: front_bogie bounce (4)");
  EXPECT_EQ(workOf("rk4", "halo", 2, "body"),
            "2: carbody bounce (2), carbody pitch (3) | 2: front_bogie bounce (4), rear_bogie bounce (5)");
  EXPECT_EQ(workOf("rk4", "pipeline", 2),
            "4: carbody bounce (2), carbody pitch (3), front_bogie bounce (4), rear_bogie bounce (5) | "
            "0: the rail ahead");
  EXPECT_EQ(workOf("rk4_split", "split", 2),
            "2: bounce: carbody and both bogies in phase | 2: pitch: carbody and both bogies in antiphase");
  EXPECT_EQ(workOf("rk4", "serial", 1), "");
}

TEST(Sharing, ProgressEndsASharedRunEarly) {
  for (const char* scheme : {"stages", "halo", "pipeline"}) {
    RunChoice choice;
    choice.sharing.threads = 2;
    choice.sharing.scheme = schemeNamed(scheme);
    choice.form = "flat";
    choice.method = "rk4";
    const RunResult some = simulate(paperVehicle(), paperScenario(History::kOnset), choice,
                                    [](double share) { return share < 0.5; });
    EXPECT_TRUE(some.statistics.stopped) << scheme;
    EXPECT_LT(some.history.samples(), 1400u) << scheme;
  }
}

}  // namespace
}  // namespace vehicle::test
