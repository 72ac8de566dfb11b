#include "libvehicle/definition/scenario.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/vehicle.h"

namespace vehicle {

namespace {

using enum Dimension;

// Output samples of a run; 10 million of 50 columns are 4 GB, and a smaller step shows nothing more.
constexpr double kMostSamples = 1e7;

void checkRun(const Scenario& scenario, ProblemList& problems) {
  const Run& run = scenario.run;
  Judge judge(problems, "<scenario><run>", "", run.origin);
  const bool length_in_order = judge.positive("duration", run.duration, kTime) &&
                               judge.positive("distance", run.distance, kLength);
  if (!run.duration && !run.distance) {
    judge.say("has no duration and no distance", "give one of them, e.g. duration=\"10 s\"");
  } else if (run.duration && run.distance) {
    judge.say("has duration and distance", "give one of them");
  }
  // Without a track the wheels do not roll, so the speed only matters where a distance is to be covered.
  const bool rolls = scenario.track || run.distance;
  const bool speed_in_order =
      rolls ? judge.positive("speed", run.speed, kSpeed) : judge.notNegative("speed", run.speed, kSpeed);
  if (!judge.positive("output_step", run.output_step, kTime) || !length_in_order || !speed_in_order) return;
  if (run.duration.has_value() == run.distance.has_value()) return;

  const double duration = durationOf(scenario);
  if (run.output_step > duration) {
    judge.say(written("output_step", run.output_step, kTime) + " is longer than the run, " +
                  formatQuantity(duration, kTime),
              "make it at most that");
  } else if (duration / run.output_step > kMostSamples) {
    judge.say(written("output_step", run.output_step, kTime) + " makes more than 10000000 samples of " +
                  formatQuantity(duration, kTime),
              "make it at least " + formatQuantity(duration / kMostSamples, kTime));
  }
}

class MemberNames {
 public:
  explicit MemberNames(ProblemList& problems) : problems_(problems) {}

  void add(std::string_view path, const std::string& name, const Origin& origin) {
    Judge judge(problems_, path, name, origin);
    if (name.empty() || !judge.properName(name)) return;  // a name is optional here
    const auto [first, fresh] = seen_.try_emplace(name, origin);
    if (fresh) return;
    judge.say(written("name", name) + " is already the name of another member" + inLine(first->second),
              "names are unique in a file");
  }

 private:
  ProblemList& problems_;
  std::map<std::string, Origin> seen_;
};

void checkStart(const Track& track, double start, Judge& judge) {
  if (!judge.finite("start", start, kLength) || track.history != History::kOnset || start >= 0.0) return;
  judge.say(written("start", start, kLength) + " lies before s = 0, where history=\"onset\" keeps the rail flat",
            "start at 0 or beyond, or take history=\"extended\"");
}

/// With onset the rail is flat before s = 0: a profile that does not begin at 0 would jump there.
void checkOnset(const Track& track, ProblemList& problems) {
  if (track.history != History::kOnset || track.fade_in) return;
  double jump = 0.0;
  double size = 0.0;
  const Harmonic* culprit = nullptr;
  for (const Harmonic& harmonic : track.harmonics) {
    const double height = harmonic.amplitude * std::sin(harmonic.phase);
    if (culprit == nullptr || std::abs(height) > std::abs(culprit->amplitude * std::sin(culprit->phase))) {
      culprit = &harmonic;
    }
    jump += height;
    size += std::abs(harmonic.amplitude);
  }
  // A phase of pi is a rounded number; what its sine leaves over is no jump.
  constexpr double kRounding = 1e-12;
  if (culprit == nullptr || !(std::abs(jump) > kRounding * size)) return;
  Judge(problems, "<scenario><track><harmonic>", culprit->name, culprit->origin)
      .say(written("phase", culprit->phase, kAngle) + " makes the rail jump where history=\"onset\" begins",
           "give the track fade_in=\"50 m\", or take history=\"extended\"");
}

void checkTrack(const Track& track, ProblemList& problems) {
  Judge whole(problems, "<scenario><track>", "", track.origin);
  whole.positive("fade_in", track.fade_in, kLength);
  if (track.fade_in && track.history != History::kOnset) {
    whole.say("has fade_in with history=\"extended\"", "leave fade_in out, or take history=\"onset\"");
  }
  MemberNames names(problems);
  bool in_order = true;
  for (const Harmonic& harmonic : track.harmonics) {
    constexpr std::string_view kPath = "<scenario><track><harmonic>";
    names.add(kPath, harmonic.name, harmonic.origin);
    Judge judge(problems, kPath, harmonic.name, harmonic.origin);
    judge.positive("wavelength", harmonic.wavelength, kLength);
    judge.positive("order", harmonic.order, kNumber);
    in_order = judge.finite("amplitude", harmonic.amplitude, kLength) && in_order;
    in_order = judge.finite("phase", harmonic.phase, kAngle) && in_order;
  }
  for (const Dip& dip : track.dips) {
    constexpr std::string_view kPath = "<scenario><track><dip>";
    names.add(kPath, dip.name, dip.origin);
    Judge judge(problems, kPath, dip.name, dip.origin);
    judge.finite("depth", dip.depth, kLength);
    judge.positive("length", dip.length, kLength);
    checkStart(track, dip.start, judge);
  }
  for (const Ramp& ramp : track.ramps) {
    constexpr std::string_view kPath = "<scenario><track><ramp>";
    names.add(kPath, ramp.name, ramp.origin);
    Judge judge(problems, kPath, ramp.name, ramp.origin);
    judge.finite("rise", ramp.rise, kLength);
    judge.positive("length", ramp.length, kLength);
    checkStart(track, ramp.start, judge);
  }
  if (in_order) checkOnset(track, problems);
}

void checkRig(const Rig& rig, ProblemList& problems) {
  std::map<std::string_view, const RigInput*> seen;
  for (const RigInput& input : rig.inputs) {
    Judge judge(problems, "<scenario><rig><input>", "", input.origin);
    if (input.wheelset.empty()) {
      judge.say("wheelset is empty", "name the wheelset it drives, e.g. wheelset=\"wheelset_1\"");
    }
    const auto [first, fresh] = seen.try_emplace(input.wheelset, &input);
    if (!fresh && !input.wheelset.empty()) {
      judge.say(written("wheelset", input.wheelset) + " has an input already" + inLine(first->second->origin),
                "put all its sines into one <input>");
    }
    if (input.sines.empty()) {
      judge.say("has no <sine>", "add one, or remove the input: a wheelset without input stays at 0");
    }
    for (const RigSine& sine : input.sines) {
      Judge each(problems, "<scenario><rig><input><sine>", "", sine.origin);
      each.finite("amplitude", sine.amplitude, kLength);
      each.positive("angular_frequency", sine.angular_frequency, kAngularVelocity);
      each.finite("phase", sine.phase, kAngle);
    }
  }
}

void checkInitialState(const Scenario& scenario, ProblemList& problems) {
  const InitialState& state = scenario.initial_state;
  Judge whole(problems, "<scenario><initial_state>", "", state.origin);
  if (state.from == InitialRest::kPeriodic && scenario.track) {
    if (scenario.track->history != History::kExtended) {
      whole.say("from=\"periodic\" with history=\"onset\"",
                "a steady state needs a rail that has always been there: history=\"extended\"");
    }
    if (!scenario.track->dips.empty() || !scenario.track->ramps.empty()) {
      whole.say("from=\"periodic\" on a track with dips or ramps",
                "a steady state needs a track of harmonics only; from=\"zero\" or \"on_rail\" go with all");
    }
  }
  std::map<std::string_view, const InitialBody*> seen;
  for (const InitialBody& body : state.bodies) {
    Judge judge(problems, "<scenario><initial_state><body>", body.name, body.origin);
    if (body.name.empty()) judge.say("has no name", "name the body or wheelset, e.g. name=\"carbody\"");
    const auto [first, fresh] = seen.try_emplace(body.name, &body);
    if (!fresh && !body.name.empty()) {
      judge.say(written("name", body.name) + " is listed twice" + inLine(first->second->origin), "list it once");
    }
    judge.finite("z", body.z, kLength);
    judge.finite("pitch", body.pitch, kAngle);
    judge.finite("z_rate", body.z_rate, kSpeed);
    judge.finite("pitch_rate", body.pitch_rate, kAngularVelocity);
  }
}

}  // namespace

double durationOf(const Scenario& scenario) {
  if (scenario.run.duration) return *scenario.run.duration;
  return scenario.run.distance.value_or(0.0) / scenario.run.speed;
}

ProblemList check(const Scenario& scenario) {
  ProblemList problems;
  Judge judge(problems, "<scenario>", scenario.name, scenario.origin);
  judge.properName(scenario.name);
  judge.notNegative("gravity", scenario.gravity, kAcceleration);
  if (!scenario.track && !scenario.rig) {
    judge.say("has no <track> and no <rig>", "give one of them; <track history=\"onset\"/> is a straight, even track");
  } else if (scenario.track && scenario.rig) {
    judge.say("has a <track> and a <rig>", "give one of them");
  }
  checkRun(scenario, problems);
  if (scenario.track) checkTrack(*scenario.track, problems);
  if (scenario.rig) checkRig(*scenario.rig, problems);
  checkInitialState(scenario, problems);
  problems.sortByPlace();
  return problems;
}

}  // namespace vehicle
