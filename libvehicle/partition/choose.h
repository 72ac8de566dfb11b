#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/partition/scheme.h"
#include "libvehicle/system/run_problem.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// One way to run that was weighed.
struct Candidate {
  Scheme scheme = Scheme::kSerial;
  int threads = 1;
  double predicted = 0.0;  // [s] a step at best, by the rule of thumb of its scheme
  double measured = 0.0;   // [s] a step, the median of its trials; 0: the rule of thumb ruled it out
};

/// Which way was taken and why; plain data, so that it can be printed.
struct Decision {
  Scheme scheme = Scheme::kSerial;
  int threads = 1;
  std::string reason{};                // one sentence; empty where nothing was to be decided
  double calibration = 0.0;            // [s] spent on finding out
  double step = 0.0;                   // [s] one serial step, input included; 0: not measured
  double input = 0.0;                  // [s] of it for the input
  std::vector<Candidate> candidates{}; // serial first, then in the order weighed
};

/// One way to run, for an interval of the run as well as for all of it.
struct Way {
  Scheme scheme = Scheme::kSerial;
  int threads = 1;
  std::function<void(const Input&, const Schedule&, const Observer&)> run;
};

/// [s] of the steady clock.
[[nodiscard]] double secondsNow();

/// The run that is to be sped up.
struct TuningProblem {
  const RunProblem& run;
  long steps = 0;  // of the whole run
  EquationMap map = EquationMap::kAuto;
  std::function<double()> now = secondsNow;  // [s] the clock that trials are timed by
};

/// The fastest of several ways that give the same bits. The first is taken unless another one wins.
///
/// A rule of thumb first: the cost of a step and of its input, counted for what each scheme must compute and exchange,
/// says what a way can reach at best. The most promising, or two that it cannot tell apart, are then tried on the first
/// steps of the run itself, in rounds that alternate with the first way: three rounds where all of them say the same clearly,
/// up to nine otherwise. The median of the ratios decides, so that something else that uses the machine for a part of
/// the trials changes nothing; the reason has their number and range. All of it takes about 60 ms at most and a
/// fiftieth of the run: a run too short for that takes the first way at once. Results do not depend on it; only the
/// time does.
/// @param ways  not empty
/// @throws what a way throws on the first steps of the run
[[nodiscard]] Decision chooseWay(const TuningProblem& problem, const std::vector<Way>& ways);

/// Steps that a run of fixed steps takes.
[[nodiscard]] long stepsOfRun(const Schedule& schedule, FixedStep step);

/// 2, 4, 8, ... and `most` itself: numbers of threads worth a look.
[[nodiscard]] std::vector<int> threadCounts(int most);

}  // namespace vehicle
