#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/definition/notes.h"
#include "libvehicle/definition/parameter.h"
#include "libvehicle/definition/scenario.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

// Rails, bumps and the frequencies of a rig.
namespace vehicle {
namespace {

constexpr double kPi = std::numbers::pi;

Origin line(int number) {
  Origin origin;
  origin.file = "s.xml";
  origin.line = number;
  return origin;
}

Harmonic onRail(RailSide rail, double amplitude, double phase, int at) {
  Harmonic made = test::harmonic(25.0, 1.0, amplitude, phase);
  made.rail = rail;
  made.origin = line(at);
  return made;
}

std::string onsetProblem(std::vector<Harmonic> harmonics) {
  Scenario made = test::paperScenario(History::kOnset);
  made.track->harmonics = std::move(harmonics);
  const ProblemList problems = check(made);
  return problems.empty() ? "" : problems[0].text().substr(0, 7) + std::to_string(problems.size());
}

// Each rail begins at 0 for itself: what cancels in the mean of both still jumps on each.
TEST(Onset, IsJudgedOnEachRail) {
  using enum RailSide;
  const double quarter = kPi / 2;
  EXPECT_EQ(onsetProblem({onRail(kLeft, 5e-3, quarter, 4)}), "s.xml:41");
  EXPECT_EQ(onsetProblem({onRail(kLeft, 5e-3, quarter, 4), onRail(kRight, 5e-3, -quarter, 5)}), "s.xml:41");
  EXPECT_EQ(onsetProblem({onRail(kRight, 5e-3, 0.0, 4), onRail(kRight, 5e-3, quarter, 5)}), "s.xml:51");
  EXPECT_EQ(onsetProblem({onRail(kLeft, 5e-3, quarter, 4), onRail(kLeft, 5e-3, -quarter, 5)}), "");
  // Both rails 5 mm up, each 5 mm down again: neither jumps.
  EXPECT_EQ(onsetProblem({onRail(kBoth, 5e-3, quarter, 4), onRail(kLeft, 5e-3, -quarter, 5),
                          onRail(kRight, 5e-3, -quarter, 6)}),
            "");
  EXPECT_EQ(onsetProblem({onRail(kBoth, 5e-3, quarter, 4), onRail(kLeft, 10e-3, -quarter, 5)}), "s.xml:51");
}

TEST(Onset, MemberOfOneRailCountsHalfInTheMean) {
  EXPECT_EQ(shareOf(RailSide::kBoth), 1.0);
  EXPECT_EQ(shareOf(RailSide::kLeft) + shareOf(RailSide::kRight), 1.0);
  EXPECT_EQ(RailSide{}, RailSide::kBoth);
}

TEST(Bump, IsJudgedLikeADip) {
  const auto problem = [](double height, double length, double start) {
    Scenario made = test::paperScenario(History::kOnset);
    made.track->bumps = {{"", DipShape::kHalfSine, height, length, start, RailSide::kBoth, line(7)}};
    return check(made).text();
  };
  const std::string bump = "s.xml:7: error: <scenario><track><bump>: ";
  EXPECT_EQ(problem(5e-3, 3.0, 10.0), "");
  EXPECT_EQ(problem(std::nan(""), 3.0, 10.0), bump + "height=\"nan\"; must be finite\n");
  EXPECT_EQ(problem(5e-3, 0.0, 10.0), bump + "length=\"0 m\"; must be > 0\n");
  EXPECT_EQ(problem(5e-3, 3.0, -1.0),
            bump + "start=\"-1 m\" lies before s = 0, where history=\"onset\" keeps the rail flat; start at 0 or beyond, "
                   "or take history=\"extended\"\n");
}

TEST(Bump, HasNoSteadyState) {
  Scenario made = test::paperScenario(History::kExtended);
  EXPECT_FALSE(hasSingleFeatures(*made.track));
  made.track->bumps.resize(1);
  made.track->bumps[0].length = 3.0;
  EXPECT_TRUE(hasSingleFeatures(*made.track));
  made.initial_state.from = InitialRest::kPeriodic;
  EXPECT_EQ(check(made).size(), 1u);
}

Scenario onRig(std::optional<double> angular_frequency, std::optional<double> frequency) {
  Scenario made = test::paperScenario(History::kOnset);
  made.track.reset();
  made.run.speed = 0.0;
  made.rig = Rig{{RigInput{"wheelset_1", {{"shake", 6e-3, angular_frequency, frequency, 0.3, line(5)}}, line(4)}}, {}};
  return made;
}

TEST(RigSine, GivesOneOfTwoFrequencies) {
  const std::string sine = "s.xml:5: error: <scenario><rig><input><sine>: ";
  EXPECT_EQ(check(onRig(5.0, {})).text(), "");
  EXPECT_EQ(check(onRig({}, 0.8)).text(), "");
  EXPECT_EQ(check(onRig({}, {})).text(),
            sine + "has no frequency; give it, e.g. frequency=\"0.8 Hz\" or angular_frequency=\"5 rad/s\"\n");
  EXPECT_EQ(check(onRig(5.0, 0.8)).text(), sine + "has angular_frequency and frequency; give one of them\n");
  EXPECT_EQ(check(onRig({}, 0.0)).text(), sine + "frequency=\"0 Hz\"; must be > 0\n");
  EXPECT_EQ(angularFrequencyOf(onRig(5.0, {}).rig->inputs[0].sines[0]), 5.0);
  // One rounding of 2 pi f.
  EXPECT_WITHIN(angularFrequencyOf(onRig({}, 0.8).rig->inputs[0].sines[0]), 2.0 * kPi * 0.8, 1e-15);
}

TEST(RigSine, IsAParameterOfStudiesByItsName) {
  Scenario hertz = onRig({}, 0.8);
  hertz.rig->inputs.push_back({"wheelset_2", {{}, {"second", 1e-3, 7.0, {}, 0.0, {}}}, {}});
  const std::vector<ScenarioParameter> parameters = parametersOf(hertz);
  const ScenarioParameter* frequency = findParameter(parameters, "scenario.shake.frequency");
  ASSERT_NE(frequency, nullptr);
  EXPECT_EQ(frequency->dimension, Dimension::kFrequency);
  EXPECT_EQ(frequency->valueIn(hertz), 0.8);
  frequency->setIn(hertz, 1.6);
  EXPECT_EQ(hertz.rig->inputs[0].sines[0].frequency, 1.6);
  // What the file does not give has no value.
  EXPECT_EQ(findParameter(parameters, "scenario.shake.angular_frequency")->valueIn(hertz), std::nullopt);
  const ScenarioParameter* second = findParameter(parameters, "scenario.second.angular_frequency");
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(second->valueIn(hertz), 7.0);
  findParameter(parameters, "scenario.second.amplitude")->setIn(hertz, 2e-3);
  EXPECT_EQ(hertz.rig->inputs[1].sines[1].amplitude, 2e-3);
  EXPECT_EQ(hertz.rig->inputs[1].sines[0].amplitude, 0.0);
}

TEST(RigSine, NamesAreUnique) {
  Scenario made = onRig(5.0, {});
  made.rig->inputs.push_back({"wheelset_2", {{"shake", 1e-3, 7.0, {}, 0.0, line(8)}}, line(7)});
  EXPECT_EQ(check(made).text(),
            "s.xml:8: error: <scenario><rig><input><sine>: name=\"shake\" is already the name of another member (line "
            "5); names are unique in a file\n");
}

std::string notes(const Scenario& scenario) {
  std::string text;
  for (const Note& each : notesOn(scenario)) text += each.line() + '\n';
  return text;
}

TEST(Notes, SayThatOneRailCountsHalfOnce) {
  Scenario made = test::paperScenario(History::kOnset);
  EXPECT_EQ(notes(made), "");
  made.track->dips = {{"", DipShape::kHalfSine, 8e-3, 4.0, 3.0, RailSide::kRight, line(7)}};
  made.track->bumps = {{"", DipShape::kHalfSine, 8e-3, 4.0, 3.0, RailSide::kLeft, line(6)}};
  made.track->harmonics = {onRail(RailSide::kBoth, 1e-3, 0.0, 4)};
  made.track->ramps = {{"", 8e-3, 4.0, 3.0, RailSide::kLeft, line(8)}};
  EXPECT_EQ(notes(made),
            "s.xml:6: rail=\"left\" or \"right\" (and in 2 more places: lines 7, 8): planar forms take the mean of both "
            "rails, so half of the height counts\n");
}

TEST(Notes, NameWhatARunDoesNotUse) {
  Scenario rig = onRig(5.0, {});
  EXPECT_EQ(notes(rig), "");
  rig.run.speed = 20.0;
  rig.run.origin = line(2);
  EXPECT_EQ(notes(rig), "s.xml:2: speed is not used: the wheels of a rig do not roll\n");
  rig.run.duration.reset();
  rig.run.distance = 200.0;  // the speed makes the duration
  EXPECT_EQ(notes(rig), "");
  Scenario faded = test::paperScenario(History::kOnset);
  faded.track->origin = line(3);
  faded.track->fade_in = 50.0;
  EXPECT_EQ(notes(faded), "");
  faded.track->harmonics.clear();
  EXPECT_EQ(notes(faded), "s.xml:3: fade_in is not used: it acts on harmonics, and the track has none\n");
}

TEST(Notes, SayThatAHertzContactIsLinearised) {
  EXPECT_TRUE(notesOn(test::contactVehicle()).empty());
  Vehicle made = test::hertzVehicle();
  for (std::size_t j = 0; j < 4; ++j) made.wheelsets[j].origin = line(7 + static_cast<int>(j));
  const std::vector<Note> found = notesOn(made);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].line(),
            "s.xml:7: hertz_constant (and in 3 more places: lines 8, 9, 10): the contact is linearised at the static "
            "load and cannot open");
}

}  // namespace
}  // namespace vehicle
