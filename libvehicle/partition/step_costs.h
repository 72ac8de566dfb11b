#pragma once

namespace vehicle {

/// What a scheme needs to know to say how long its step takes at best.
struct StepCosts {
  double step = 0.0;      // [s] one serial step, input included
  double input = 0.0;     // [s] of it for the input
  double exchange = 0.0;  // [s] one empty exchange between the threads in question
};

}  // namespace vehicle
