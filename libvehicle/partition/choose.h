#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/scheme.h"
#include "libvehicle/system/schedule.h"
#include "libvehicle/system/system.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// One way to run that was weighed.
struct Candidate {
  Scheme scheme = Scheme::kSerial;
  int threads = 1;
  double predicted = 0.0;  // [s] a step, from the figures of the calibration
  double measured = 0.0;   // [s] a step, on a short stretch of the run itself; 0: the prediction ruled it out
};

/// Which way was taken and why; plain data, so that it can be printed.
struct Decision {
  Scheme scheme = Scheme::kSerial;
  int threads = 1;
  std::string reason{};                // one sentence; empty where nothing was to be decided
  double calibration = 0.0;            // [s] spent on finding out
  double step = 0.0;                   // [s] one serial step, input included; 0: not measured
  double input = 0.0;                  // [s] of it for the input
  double equation = 0.0;               // [s] the rest, shared out evenly among the equations
  std::vector<double> exchange{};      // [s] one empty exchange between 2, 3, ... threads; 1: not measured
  std::vector<Candidate> candidates{}; // serial first, then in the order weighed
};

/// One way to run, for a stretch of the run as well as for all of it.
struct Way {
  Scheme scheme = Scheme::kSerial;
  int threads = 1;
  std::function<void(const Input&, const Schedule&, const Observer&)> run;
};

/// [s] of the steady clock.
[[nodiscard]] double secondsNow();

/// The run that is to be sped up.
struct WayProblem {
  const System& system;
  const Input& input;
  const Schedule& schedule;
  long steps = 0;                 // of the whole run
  bool a_step_a_sample = false;   // of an exact method: its steps are the output samples
  EquationMap map = EquationMap::kAuto;
  const TeamChoice& team;         // its threads are not read
  std::function<double()> now = secondsNow;  // [s] the clock that trials are timed by
};

/// The fastest of several ways that give the same bits. The first is taken unless another one wins clearly.
///
/// Prediction first: the costs of a step, of its input and of an empty exchange say what each way can reach at best.
/// Those that promise something are then tried on the first steps of the run itself, against the first way before and
/// after. All of it takes about 15 ms at most and about a sixtieth of the run: a run too short for that takes the
/// first way at once, and so does one whose trials would take that long before their first step (an exact method finds
/// its matrices anew for each). Where the first way's two timings do not agree, something else is using the machine and
/// no timing means anything: the first way again.
///
/// A way is taken if its trial is at least 5 % faster, so that the choice costs a sixtieth of the run at worst.
/// Results do not depend on it; only the time does.
/// @param ways  not empty
/// @throws what a way throws on the first steps of the run
[[nodiscard]] Decision chooseWay(const WayProblem& problem, const std::vector<Way>& ways);

/// Steps that a run of fixed steps takes.
[[nodiscard]] long stepsOfRun(const Schedule& schedule, FixedStep step);

/// 2, 4, 8, ... and `most` itself: numbers of threads worth a look.
[[nodiscard]] std::vector<int> threadCounts(int most);

}  // namespace vehicle
