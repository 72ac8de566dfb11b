#include "libvehicle/partition/trial.h"

#include <algorithm>
#include <utility>

namespace vehicle {
namespace {

Input beginningOf(const Input& input, double end) {
  std::vector<InputSegment> segments;
  for (int index = 0; index < input.segments() && input.segment(index).begin < end; ++index) {
    segments.push_back(input.segment(index));
  }
  segments.back().end = std::min(segments.back().end, end);
  return Input(input.channels(), std::move(segments));
}

}  // namespace

Trial trialOf(const TuningProblem& problem, long steps) {
  const Input& whole = problem.run.input;
  const double h = (whole.end() - whole.begin()) / static_cast<double>(problem.steps);
  steps = std::clamp(steps, std::min(8l, problem.steps), problem.steps);
  const double length = std::min(h * static_cast<double>(steps), whole.end() - whole.begin());
  const double output_step =
      std::min(problem.run.schedule.outputStep(), length / static_cast<double>(std::min(64l, steps)));
  Input input = beginningOf(whole, whole.begin() + length);
  Schedule schedule(input, output_step);
  return {std::move(input), std::move(schedule), steps};
}

double timeOf(const Way& way, const Trial& trial, double limit, const std::function<double()>& now) {
  const int samples = trial.schedule.samples();
  const int first = samples / 4;  // caches are warm and all threads have come
  double begin = 0.0;
  double took = 0.0;
  int last = first;
  way.run(trial.input, trial.schedule, [&](int sample, int, double, std::span<const double>) {
    if (sample < first || took > limit) return took <= limit;
    if (sample == first) begin = now();
    took = now() - begin;
    last = sample;
    return took <= limit;
  });
  const double steps = static_cast<double>(trial.steps) * (last - first) / std::max(1, samples - 1);
  return took / std::max(1.0, steps);
}

}  // namespace vehicle
