#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libvehicle/partition/scheme.h"

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
  std::string reason;                  // one sentence; empty where nothing was to be decided
  double calibration = 0.0;            // [s] spent on finding out
  double step = 0.0;                   // [s] one serial step, input included; 0: not measured
  double input = 0.0;                  // [s] of it for the input
  double equation = 0.0;               // [s] the rest, shared out evenly among the equations
  std::vector<double> exchange;        // [s] one empty exchange between 2, 3, ... threads
  std::vector<Candidate> candidates;   // serial first, then in the order weighed
};

}  // namespace vehicle
