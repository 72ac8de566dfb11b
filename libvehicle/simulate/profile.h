#pragma once

#include <vector>

#include "libvehicle/simulate/simulate.h"
#include "libvehicle/threads/trace.h"

namespace vehicle {

/// Seconds a step of several runs of the same kind; whole runs, the start of threads and the samples included.
struct StepTimes {
  std::vector<double> seconds;  // [s] a step, one a run
  [[nodiscard]] double median() const;
  [[nodiscard]] double least() const;
};

/// How threads share a run, by their times.
struct Profile {
  RunResult run;         // the last traced one
  Trace trace;           // of it
  StepTimes serial;      // the best serial code of the same method
  StepTimes plain;       // shared among the threads, not traced
  StepTimes traced;      // the same, traced
  bool stopped = false;  // ended early on request: nothing of it counts
};

/// Runs serial, shared and shared with a tracer in turn, up to five times as long as the whole stays within about two
/// seconds: the machine's mood hits all three alike.
/// @param every  steps from one traced to the next, >= 1
/// @throws as simulate()
[[nodiscard]] Profile profileOf(const CompiledModel& model, const Scenario& scenario, const RunChoice& choice, int every,
                                const Progress& progress);

}  // namespace vehicle
