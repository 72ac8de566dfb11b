#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/definition/scenario.h"
#include "tests/support/vehicles.h"

// Every message of check(Scenario) and check(Scenario, Vehicle), provoked, whole text.
namespace vehicle {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Origin line(int number) {
  Origin origin;
  origin.file = "run.xml";
  origin.line = number;
  return origin;
}

// Lines: 1 scenario | 2 run | 3 track or rig | 4 5 members | 6 initial state | 7.. its bodies
Scenario onTrack(History history = History::kOnset) {
  Scenario made = test::paperScenario(history);
  made.origin = line(1);
  made.run.origin = line(2);
  made.track->origin = line(3);
  made.track->harmonics[0].origin = line(4);
  made.track->harmonics[1].origin = line(5);
  made.initial_state.origin = line(6);
  return made;
}

Scenario onRig() {
  Scenario made = onTrack();
  made.track.reset();
  made.run.speed = 0.0;
  made.rig = Rig{{RigInput{"wheelset_1", {RigSine{"", 6.2e-3, 5.03, {}, 0.3, line(5)}}, line(4)}}, line(3)};
  return made;
}

std::string trackProblem(const std::function<void(Scenario&)>& change) {
  Scenario made = onTrack();
  change(made);
  return check(made).text();
}

std::string rigProblem(const std::function<void(Scenario&)>& change) {
  Scenario made = onRig();
  change(made);
  return check(made).text();
}

InitialBody initialBody(const std::string& name, int number = 7) {
  InitialBody body;
  body.name = name;
  body.origin = line(number);
  return body;
}

Dip dipAt(double start) {
  Dip dip;
  dip.depth = 5e-3;
  dip.length = 3.0;
  dip.start = start;
  dip.origin = line(5);
  return dip;
}

Ramp rampAt(double start) {
  Ramp ramp;
  ramp.rise = 5e-3;
  ramp.length = 3.0;
  ramp.start = start;
  ramp.origin = line(5);
  return ramp;
}

TEST(CheckScenario, WhatIsInOrderPasses) {
  EXPECT_EQ(check(onTrack()).text(), "");
  EXPECT_EQ(check(onTrack(History::kExtended)).text(), "");
  EXPECT_EQ(check(onRig()).text(), "");
  // A track without members is a straight rail.
  EXPECT_EQ(trackProblem([](Scenario& made) { made.track->harmonics.clear(); }), "");
}

TEST(CheckScenario, DurationIsTheGivenOneOrDistanceOverSpeed) {
  Scenario made = onTrack();
  EXPECT_EQ(durationOf(made), 10.0);
  made.run.duration.reset();
  made.run.distance = 250.0;
  EXPECT_EQ(durationOf(made), 12.5);
}

TEST(CheckScenario, HasAProperNameAndGravity) {
  EXPECT_EQ(trackProblem([](Scenario& made) { made.name = "my run"; }),
            "run.xml:1: error: <scenario>: name=\"my run\"; "
            "a name is made of the letters a-z and A-Z, digits, \"_\" and \"-\"\n");
  EXPECT_EQ(trackProblem([](Scenario& made) { made.gravity = -9.81; }),
            "run.xml:1: error: <scenario>: gravity=\"-9.81 m/s^2\"; must be >= 0\n");
}

TEST(CheckScenario, RunsForADurationOrADistance) {
  EXPECT_EQ(trackProblem([](Scenario& made) { made.run.duration.reset(); }),
            "run.xml:2: error: <scenario><run>: has no duration and no distance; "
            "give one of them, e.g. duration=\"10 s\"\n");
  EXPECT_EQ(trackProblem([](Scenario& made) { made.run.distance = 200.0; }),
            "run.xml:2: error: <scenario><run>: has duration and distance; give one of them\n");
  EXPECT_EQ(trackProblem([](Scenario& made) { made.run.duration = 0.0; }),
            "run.xml:2: error: <scenario><run>: duration=\"0 s\"; must be > 0\n");
  EXPECT_EQ(trackProblem([](Scenario& made) {
              made.run.duration.reset();
              made.run.distance = -200.0;
            }),
            "run.xml:2: error: <scenario><run>: distance=\"-200 m\"; must be > 0\n");
}

TEST(CheckScenario, ATrackNeedsASpeedAndARigOnlyForADistance) {
  EXPECT_EQ(trackProblem([](Scenario& made) { made.run.speed = 0.0; }),
            "run.xml:2: error: <scenario><run>: speed=\"0 m/s\"; must be > 0\n");
  EXPECT_EQ(trackProblem([](Scenario& made) { made.run.speed = kNan; }),
            "run.xml:2: error: <scenario><run>: speed=\"nan\"; must be finite\n");
  EXPECT_EQ(rigProblem([](Scenario& made) { made.run.speed = -1.0; }),
            "run.xml:2: error: <scenario><run>: speed=\"-1 m/s\"; must be >= 0\n");
  EXPECT_EQ(rigProblem([](Scenario& made) {
              made.run.duration.reset();
              made.run.distance = 200.0;
            }),
            "run.xml:2: error: <scenario><run>: speed=\"0 m/s\"; must be > 0\n");
}

TEST(CheckScenario, OutputStepFitsTheRun) {
  EXPECT_EQ(trackProblem([](Scenario& made) { made.run.output_step = 0.0; }),
            "run.xml:2: error: <scenario><run>: output_step=\"0 s\"; must be > 0\n");
  EXPECT_EQ(trackProblem([](Scenario& made) { made.run.output_step = 20.0; }),
            "run.xml:2: error: <scenario><run>: output_step=\"20 s\" is longer than the run, duration=\"10 s\"; "
            "make it at most that\n");
  EXPECT_EQ(trackProblem([](Scenario& made) { made.run.output_step = 1e-9; }),
            "run.xml:2: error: <scenario><run>: output_step=\"1e-9 s\" makes more than 10000000 samples of the run, duration=\"10 s\"; "
            "make it at least 1e-6 s\n");
  EXPECT_EQ(trackProblem([](Scenario& made) { made.run.output_step = 1e-6; }), "");
}

TEST(CheckScenario, HasATrackOrARig) {
  EXPECT_EQ(trackProblem([](Scenario& made) { made.track.reset(); }),
            "run.xml:1: error: <scenario>: has no <track> and no <rig>; "
            "give one of them; <track history=\"onset\"/> is a straight, even track\n");
  EXPECT_EQ(trackProblem([](Scenario& made) { made.rig = onRig().rig; }),
            "run.xml:1: error: <scenario>: has a <track> and a <rig>; give one of them\n");
}

TEST(CheckScenario, TrackMembersHaveTheirRanges) {
  const std::string harmonic = "run.xml:4: error: <scenario><track><harmonic>: ";
  const auto harmonicProblem = [](const std::function<void(Harmonic&)>& change) {
    return trackProblem([&](Scenario& made) { change(made.track->harmonics[0]); });
  };
  EXPECT_EQ(harmonicProblem([](Harmonic& h) { h.wavelength = 0.0; }), harmonic + "wavelength=\"0 m\"; must be > 0\n");
  EXPECT_EQ(harmonicProblem([](Harmonic& h) { h.order = -3.0; }), harmonic + "order=\"-3\"; must be > 0\n");
  EXPECT_EQ(harmonicProblem([](Harmonic& h) { h.amplitude = kNan; }), harmonic + "amplitude=\"nan\"; must be finite\n");
  EXPECT_EQ(harmonicProblem([](Harmonic& h) { h.phase = kNan; }), harmonic + "phase=\"nan\"; must be finite\n");

  const auto dipProblem = [](const std::function<void(Dip&)>& change) {
    return trackProblem([&](Scenario& made) {
      made.track->dips.push_back(dipAt(10.0));
      change(made.track->dips[0]);
    });
  };
  const std::string dip = "run.xml:5: error: <scenario><track><dip>: ";
  EXPECT_EQ(dipProblem([](Dip&) {}), "");
  EXPECT_EQ(dipProblem([](Dip& d) { d.depth = kNan; }), dip + "depth=\"nan\"; must be finite\n");
  EXPECT_EQ(dipProblem([](Dip& d) { d.length = 0.0; }), dip + "length=\"0 m\"; must be > 0\n");
  EXPECT_EQ(dipProblem([](Dip& d) { d.start = kNan; }), dip + "start=\"nan\"; must be finite\n");

  const auto rampProblem = [](const std::function<void(Ramp&)>& change) {
    return trackProblem([&](Scenario& made) {
      made.track->ramps.push_back(rampAt(10.0));
      change(made.track->ramps[0]);
    });
  };
  const std::string ramp = "run.xml:5: error: <scenario><track><ramp>: ";
  EXPECT_EQ(rampProblem([](Ramp&) {}), "");
  EXPECT_EQ(rampProblem([](Ramp& r) { r.rise = kNan; }), ramp + "rise=\"nan\"; must be finite\n");
  EXPECT_EQ(rampProblem([](Ramp& r) { r.length = -1.0; }), ramp + "length=\"-1 m\"; must be > 0\n");
}

TEST(CheckScenario, TrackMembersAreNamedProperlyAndOnce) {
  EXPECT_EQ(trackProblem([](Scenario& made) { made.track->harmonics[1].name = "third.order"; }),
            "run.xml:5: error: <scenario><track><harmonic>: name=\"third.order\"; "
            "a name is made of the letters a-z and A-Z, digits, \"_\" and \"-\"\n");
  EXPECT_EQ(trackProblem([](Scenario& made) {
              made.track->harmonics[0].name = "wave";
              made.track->dips.push_back(dipAt(10.0));
              made.track->dips[0].name = "wave";
            }),
            "run.xml:5: error: <scenario><track><dip>: name=\"wave\" is already the name of another member (line 4); "
            "names are unique in a file\n");
}

TEST(CheckScenario, AnOnsetDoesNotJump) {
  const auto withPhases = [](double first, double second, History history, std::optional<double> fade_in) {
    Scenario made = onTrack(history);
    made.track->fade_in = fade_in;
    made.track->harmonics[0].phase = first;
    made.track->harmonics[1].phase = second;
    return check(made).text();
  };
  EXPECT_EQ(withPhases(0.5, 0.0, History::kOnset, std::nullopt),
            "run.xml:4: error: <scenario><track><harmonic>: phase=\"0.5 rad\" makes the rail jump where "
            "history=\"onset\" begins; give the track fade_in=\"50 m\", or take history=\"extended\"\n");
  EXPECT_EQ(withPhases(0.0, 0.5, History::kOnset, std::nullopt).substr(0, 9), "run.xml:5");
  EXPECT_EQ(withPhases(0.5, 0.0, History::kOnset, 50.0), "");
  EXPECT_EQ(withPhases(0.5, 0.0, History::kExtended, std::nullopt), "");
  EXPECT_EQ(withPhases(std::numbers::pi, -std::numbers::pi, History::kOnset, std::nullopt), "");
  for (const auto& [start, problems] : {std::pair{-1.0, 1u}, {0.0, 0u}}) {
    Scenario made = onTrack();
    made.track->dips.push_back(dipAt(start));
    EXPECT_EQ(check(made).size(), problems);
  }
  EXPECT_EQ(trackProblem([](Scenario& made) { made.track->dips.push_back(dipAt(-1.0)); }),
            "run.xml:5: error: <scenario><track><dip>: start=\"-1 m\" lies before s = 0, where history=\"onset\" keeps "
            "the rail flat; start at 0 or beyond, or take history=\"extended\"\n");
  EXPECT_EQ(trackProblem([](Scenario& made) { made.track->ramps.push_back(rampAt(-1.0)); }),
            "run.xml:5: error: <scenario><track><ramp>: start=\"-1 m\" lies before s = 0, where history=\"onset\" "
            "keeps the rail flat; start at 0 or beyond, or take history=\"extended\"\n");
}

TEST(CheckScenario, FadeInBelongsToAnOnset) {
  EXPECT_EQ(trackProblem([](Scenario& made) { made.track->fade_in = 0.0; }),
            "run.xml:3: error: <scenario><track>: fade_in=\"0 m\"; must be > 0\n");
  EXPECT_EQ(trackProblem([](Scenario& made) {
              made.track->fade_in = 50.0;
              made.track->history = History::kExtended;
            }),
            "run.xml:3: error: <scenario><track>: has fade_in with history=\"extended\"; "
            "leave fade_in out, or take history=\"onset\"\n");
}

TEST(CheckScenario, RigInputsNameEachWheelsetOnceAndHaveSines) {
  const std::string input = "run.xml:4: error: <scenario><rig><input>: ";
  EXPECT_EQ(rigProblem([](Scenario& made) { made.rig->inputs[0].wheelset = ""; }),
            input + "wheelset is empty; name the wheelset it drives, e.g. wheelset=\"wheelset_1\"\n");
  EXPECT_EQ(rigProblem([](Scenario& made) { made.rig->inputs[0].sines.clear(); }),
            input + "has no <sine>; add one, or remove the input: a wheelset without input stays at 0\n");
  EXPECT_EQ(rigProblem([](Scenario& made) {
              made.rig->inputs.push_back(made.rig->inputs[0]);
              made.rig->inputs[1].origin = line(8);
            }),
            "run.xml:8: error: <scenario><rig><input>: wheelset=\"wheelset_1\" has an input already (line 4); "
            "put all its sines into one <input>\n");
  const std::string sine = "run.xml:5: error: <scenario><rig><input><sine>: ";
  const auto sineProblem = [](const std::function<void(RigSine&)>& change) {
    return rigProblem([&](Scenario& made) { change(made.rig->inputs[0].sines[0]); });
  };
  EXPECT_EQ(sineProblem([](RigSine& s) { s.amplitude = kNan; }), sine + "amplitude=\"nan\"; must be finite\n");
  EXPECT_EQ(sineProblem([](RigSine& s) { s.angular_frequency = 0.0; }),
            sine + "angular_frequency=\"0 rad/s\"; must be > 0\n");
  EXPECT_EQ(sineProblem([](RigSine& s) { s.phase = kNan; }), sine + "phase=\"nan\"; must be finite\n");
}

TEST(CheckScenario, ASteadyStateNeedsHarmonicsThatHaveAlwaysBeenThere) {
  EXPECT_EQ(trackProblem([](Scenario& made) { made.initial_state.from = InitialRest::kPeriodic; }),
            "run.xml:6: error: <scenario><initial_state>: from=\"periodic\" with history=\"onset\"; "
            "a steady state needs a rail that has always been there: history=\"extended\"\n");
  Scenario made = onTrack(History::kExtended);
  made.initial_state.from = InitialRest::kPeriodic;
  EXPECT_EQ(check(made).text(), "");
  made.track->dips.push_back(dipAt(10.0));
  EXPECT_EQ(check(made).text(),
            "run.xml:6: error: <scenario><initial_state>: from=\"periodic\" on a track with dips, bumps or ramps; "
            "a steady state needs a track of harmonics only; from=\"zero\" or \"on_rail\" go with all\n");
  EXPECT_EQ(rigProblem([](Scenario& each) { each.initial_state.from = InitialRest::kPeriodic; }), "");
}

TEST(CheckScenario, InitialBodiesAreListedOnceWithFiniteValues) {
  EXPECT_EQ(trackProblem([](Scenario& made) {
              made.initial_state.bodies = {initialBody("carbody", 7), initialBody("carbody", 8)};
            }),
            "run.xml:8: error: <scenario><initial_state><body>: name=\"carbody\" is listed twice (line 7); "
            "list it once\n");
  const std::string body = "run.xml:7: error: <scenario><initial_state><body>: ";
  const auto bodyProblem = [](const std::function<void(InitialBody&)>& change) {
    return trackProblem([&](Scenario& made) {
      made.initial_state.bodies = {initialBody("carbody")};
      change(made.initial_state.bodies[0]);
    });
  };
  EXPECT_EQ(bodyProblem([](InitialBody& b) { b.name = ""; }),
            body + "has no name; name the body or wheelset, e.g. name=\"carbody\"\n");
  EXPECT_EQ(bodyProblem([](InitialBody& b) { b.z = kNan; }), body + "z=\"nan\"; must be finite\n");
  EXPECT_EQ(bodyProblem([](InitialBody& b) { b.pitch = kNan; }), body + "pitch=\"nan\"; must be finite\n");
  EXPECT_EQ(bodyProblem([](InitialBody& b) { b.z_rate = kNan; }), body + "z_rate=\"nan\"; must be finite\n");
  EXPECT_EQ(bodyProblem([](InitialBody& b) { b.pitch_rate = kNan; }), body + "pitch_rate=\"nan\"; must be finite\n");
}

TEST(CheckScenarioWithVehicle, RigInputsNameWheelsetsOfTheVehicle) {
  Scenario made = onRig();
  EXPECT_EQ(check(made, test::paperVehicle()).text(), "");
  made.rig->inputs[0].wheelset = "wheelset1";
  EXPECT_EQ(check(made, test::paperVehicle()).text(),
            "run.xml:4: error: <scenario><rig><input>: wheelset=\"wheelset1\" names no wheelset of the vehicle "
            "\"al-oraiqat-2017\"; a rig drives wheelsets; did you mean \"wheelset_1\"?\n");
  made.rig->inputs[0].wheelset = "carbody";
  EXPECT_EQ(check(made, test::paperVehicle()).text(),
            "run.xml:4: error: <scenario><rig><input>: wheelset=\"carbody\" names no wheelset of the vehicle "
            "\"al-oraiqat-2017\"; a rig drives wheelsets\n");
}

TEST(CheckScenarioWithVehicle, InitialBodiesExistAndMove) {
  const auto problem = [](const Vehicle& vehicle, const InitialBody& body) {
    Scenario made = onTrack();
    made.initial_state.bodies = {body};
    return check(made, vehicle).text();
  };
  const std::string place = "run.xml:7: error: <scenario><initial_state><body>: ";
  EXPECT_EQ(problem(test::paperVehicle(), initialBody("car_body")),
            place + "name=\"car_body\" names no body or wheelset of the vehicle \"al-oraiqat-2017\"; "
                    "bodies and wheelsets have an initial state; did you mean \"carbody\"?\n");
  EXPECT_EQ(problem(test::bogiePitchVehicle(), initialBody("wheelset_1")),
            place + "name=\"wheelset_1\" is a wheelset that follows the rail; "
                    "only one with mass and contact has a state of its own\n");
  InitialBody all = initialBody("carbody");
  all.z = -3.1e-3;
  all.pitch = 1.2e-3;
  all.z_rate = 22e-3;
  all.pitch_rate = -8.5e-3;
  EXPECT_EQ(problem(test::paperVehicle(), all), "");
  all.name = "front_bogie";
  EXPECT_EQ(problem(test::bogiePitchVehicle(), all), "");
  EXPECT_EQ(problem(test::paperVehicle(), all),
            place + "pitch=\"1.2 mrad\", but \"front_bogie\" has no motion pitch; leave it out\n" + place +
                "pitch_rate=\"-8.5 mrad/s\", but \"front_bogie\" has no motion pitch; leave it out\n");
  all.name = "wheelset_1";
  EXPECT_EQ(problem(test::contactVehicle(), all),
            place + "pitch=\"1.2 mrad\", but \"wheelset_1\" has no motion pitch; leave it out\n" + place +
                "pitch_rate=\"-8.5 mrad/s\", but \"wheelset_1\" has no motion pitch; leave it out\n");
  Vehicle still = test::paperVehicle();
  still.bodies[0].motion = {Motion::kPitch};
  all.name = "carbody";
  EXPECT_EQ(problem(still, all), place + "z=\"-3.1 mm\", but \"carbody\" has no motion z; leave it out\n" + place +
                                     "z_rate=\"22 mm/s\", but \"carbody\" has no motion z; leave it out\n");
}

}  // namespace
}  // namespace vehicle
