#include "libvehicle/definition/scenario.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/scenario_attributes.h"
#include "libvehicle/definition/vehicle.h"

namespace vehicle {

namespace {

using enum Dimension;

// Output samples of a run; 10 million of 50 columns are 4 GB, and a smaller step shows nothing more.
constexpr double kMostSamples = 1e7;

void checkRun(const Scenario& scenario, ProblemList& problems) {
  const Run& run = scenario.run;
  Judge judge(problems, "<scenario><run>", "", run.origin);
  const bool length_in_order = judge.number<&Run::duration>(run) && judge.number<&Run::distance>(run);
  if (!run.duration && !run.distance && judge.knows({"duration", "distance"})) {
    judge.say("has no duration and no distance", "give one of them, e.g. duration=\"10 s\"");
  } else if (run.duration && run.distance) {
    judge.say("has duration and distance", "give one of them");
  }
  const bool speed_in_order =
      wheelsRoll(scenario) ? judge.positive("speed", run.speed, kSpeed) : judge.number<&Run::speed>(run);
  const bool step_in_order = judge.number<&Run::output_step>(run);
  judge.numbers<&Run::duration, &Run::distance, &Run::speed, &Run::output_step>(run);
  if (!step_in_order || !length_in_order || !speed_in_order) return;
  if (run.duration.has_value() == run.distance.has_value()) return;

  const double duration = durationOf(scenario);
  const std::string lasts = run.duration ? judge.written("duration", *run.duration, kTime)
                                         : judge.written("distance", *run.distance, kLength) + " at " +
                                               judge.written("speed", run.speed, kSpeed);
  if (run.output_step > duration) {
    judge.say(judge.written("output_step", run.output_step, kTime) + " is longer than the run, " + lasts,
              "make it at most that");
  } else if (duration / run.output_step > kMostSamples) {
    judge.say(judge.written("output_step", run.output_step, kTime) + " makes more than 10000000 samples of the run, " +
                  lasts,
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

template <class Member>
void checkStart(const Track& track, const Member& member, Judge& judge) {
  const double start = member.start;
  if (!judge.number<&Member::start>(member) || !track.origin.knows("history")) return;
  if (track.history != History::kOnset || start >= 0.0) return;
  judge.say(judge.written("start", start, kLength) +
                " lies before s = 0, where history=\"onset\" keeps the rail flat",
            "start at 0 or beyond, or take history=\"extended\"");
}

/// With onset the rail is flat before s = 0: a profile that does not begin at 0 would jump there. Each rail for itself:
/// what cancels in the mean of both is a jump of each.
void checkOnset(const Track& track, ProblemList& problems) {
  if (track.history != History::kOnset || track.fade_in || !track.origin.knows("history") ||
      !track.origin.knows("fade_in")) {
    return;
  }
  for (const RailSide side : {RailSide::kLeft, RailSide::kRight}) {
    double jump = 0.0;
    double size = 0.0;
    double largest = -1.0;
    const Harmonic* culprit = nullptr;
    for (const Harmonic& harmonic : track.harmonics) {
      if (harmonic.rail != RailSide::kBoth && harmonic.rail != side) continue;
      const double height = harmonic.amplitude * std::sin(harmonic.phase);
      if (std::abs(height) > largest) culprit = &harmonic;
      largest = std::max(largest, std::abs(height));
      jump += height;
      size += std::abs(harmonic.amplitude);
    }
    // A phase of pi is a rounded number; what its sine leaves over is no jump.
    constexpr double kRounding = 1e-12;
    if (culprit == nullptr || !(std::abs(jump) > kRounding * size)) continue;
    Judge judge(problems, "<scenario><track><harmonic>", culprit->name, culprit->origin);
    judge.say(judge.written("phase", culprit->phase, kAngle) + " makes the rail jump where history=\"onset\" begins",
              "give the track fade_in=\"50 m\", or take history=\"extended\"");
    return;  // reported once, whichever rail it is
  }
}

class TrackCheck {
 public:
  TrackCheck(const Track& track, ProblemList& problems) : track_(track), problems_(problems), names_(problems) {}

  void run() {
    Judge whole(problems_, "<scenario><track>", "", track_.origin);
    whole.numbers(track_);
    if (track_.fade_in && track_.history != History::kOnset && whole.knows({"history"})) {
      whole.say("has fade_in with history=\"extended\"", "leave fade_in out, or take history=\"onset\"");
    }
    bool in_order = true;
    for (const Harmonic& harmonic : track_.harmonics) {
      Judge judge = judgeOf("harmonic", harmonic);
      judge.numbers<&Harmonic::amplitude, &Harmonic::phase>(harmonic);
      in_order = judge.number<&Harmonic::amplitude>(harmonic) && in_order;
      in_order = judge.number<&Harmonic::phase>(harmonic) && judge.knows({"rail"}) && in_order;
    }
    for (const Dip& dip : track_.dips) checkFeature("dip", dip);
    for (const Bump& bump : track_.bumps) checkFeature("bump", bump);
    for (const Ramp& ramp : track_.ramps) checkFeature("ramp", ramp);
    if (in_order) checkOnset(track_, problems_);
  }

 private:
  template <class Member>
  Judge judgeOf(std::string_view element, const Member& member) {
    const std::string path = "<scenario><track><" + std::string(element) + '>';
    names_.add(path, member.name, member.origin);
    return Judge(problems_, path, member.name, member.origin);
  }

  template <class Member>
  void checkFeature(std::string_view element, const Member& member) {
    Judge judge = judgeOf(element, member);
    judge.template numbers<&Member::start>(member);
    checkStart(track_, member, judge);
  }

  const Track& track_;
  ProblemList& problems_;
  MemberNames names_;
};

void checkSine(const RigSine& sine, MemberNames& names, ProblemList& problems) {
  constexpr std::string_view kPath = "<scenario><rig><input><sine>";
  names.add(kPath, sine.name, sine.origin);
  Judge judge(problems, kPath, sine.name, sine.origin);
  judge.numbers<&RigSine::phase>(sine);
  if (!sine.angular_frequency && !sine.frequency && judge.knows({"angular_frequency", "frequency"})) {
    judge.say("has no frequency", "give it, e.g. frequency=\"0.8 Hz\" or angular_frequency=\"5 rad/s\"");
  } else if (sine.angular_frequency && sine.frequency) {
    judge.say("has angular_frequency and frequency", "give one of them");
  }
  judge.number<&RigSine::phase>(sine);
}

void checkRig(const Rig& rig, bool strange, ProblemList& problems) {
  std::map<std::string_view, const RigInput*> seen;
  MemberNames names(problems);
  for (const RigInput& input : rig.inputs) {
    Judge judge(problems, "<scenario><rig><input>", "", input.origin);
    if (input.wheelset.empty() && judge.knows({"wheelset"})) {
      judge.say("wheelset is empty", "name the wheelset it drives, e.g. wheelset=\"wheelset_1\"");
    }
    const auto [first, fresh] = seen.try_emplace(input.wheelset, &input);
    if (!fresh && !input.wheelset.empty() && judge.knows({"wheelset"})) {
      judge.say(written("wheelset", input.wheelset) + " has an input already" + inLine(first->second->origin),
                "put all its sines into one <input>");
    }
    if (input.sines.empty() && !strange) {
      judge.say("has no <sine>", "add one, or remove the input: a wheelset without input stays at 0");
    }
    for (const RigSine& sine : input.sines) checkSine(sine, names, problems);
  }
}

void checkInitialState(const Scenario& scenario, ProblemList& problems) {
  const InitialState& state = scenario.initial_state;
  Judge whole(problems, "<scenario><initial_state>", "", state.origin);
  if (state.from == InitialRest::kPeriodic && scenario.track) {
    if (scenario.track->history != History::kExtended && scenario.track->origin.knows("history")) {
      whole.say("from=\"periodic\" with history=\"onset\"",
                "a steady state needs a rail that has always been there: history=\"extended\"");
    }
    if (hasSingleFeatures(*scenario.track)) {
      whole.say("from=\"periodic\" on a track with dips, bumps or ramps",
                "a steady state needs a track of harmonics only; from=\"zero\" or \"on_rail\" go with all");
    }
  }
  std::map<std::string_view, const InitialBody*> seen;
  for (const InitialBody& body : state.bodies) {
    Judge judge(problems, "<scenario><initial_state><body>", body.name, body.origin);
    const bool named = judge.knows({"name"});
    if (body.name.empty() && named) judge.say("has no name", "name the body or wheelset, e.g. name=\"carbody\"");
    const auto [first, fresh] = seen.try_emplace(body.name, &body);
    if (!fresh && !body.name.empty() && named) {
      judge.say(written("name", body.name) + " is listed twice" + inLine(first->second->origin), "list it once");
    }
    judge.numbers(body);
  }
}

}  // namespace

double angularFrequencyOf(const RigSine& sine) {
  return sine.frequency ? 2.0 * std::numbers::pi * *sine.frequency : sine.angular_frequency.value_or(0.0);
}

bool hasSingleFeatures(const Track& track) {
  return !track.dips.empty() || !track.bumps.empty() || !track.ramps.empty();
}

bool wheelsRoll(const Scenario& scenario) { return scenario.track || scenario.run.distance; }

double durationOf(const Scenario& scenario) {
  if (scenario.run.duration) return *scenario.run.duration;
  return scenario.run.distance.value_or(0.0) / scenario.run.speed;
}

ProblemList check(const Scenario& scenario) {
  ProblemList problems;
  Judge judge(problems, "<scenario>", scenario.name, scenario.origin);
  judge.properName(scenario.name);
  judge.numbers(scenario);
  if (!scenario.track && !scenario.rig && !scenario.origin.hasStrange()) {
    judge.say("has no <track> and no <rig>", "give one of them; <track history=\"onset\"/> is a straight, even track");
  }
  if (scenario.track && scenario.rig) {
    judge.say("has a <track> and a <rig>", "give one of them");
  }
  checkRun(scenario, problems);
  if (scenario.track) TrackCheck(*scenario.track, problems).run();
  if (scenario.rig) checkRig(*scenario.rig, scenario.origin.hasStrange(), problems);
  checkInitialState(scenario, problems);
  problems.sortByPlace();
  return problems;
}

}  // namespace vehicle
