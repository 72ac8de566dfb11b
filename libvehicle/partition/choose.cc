#include "libvehicle/partition/choose.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "libvehicle/integrate/fixed_step_run.h"
#include "libvehicle/partition/map/equation_graph.h"
#include "libvehicle/partition/map/equation_map.h"
#include "libvehicle/partition/team/exchange.h"

namespace vehicle {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kMostSpent = 0.015;         // [s]
constexpr double kMostShare = 1.0 / 60.0;    // of the run
constexpr double kLeastUseful = 4e-3;        // [s] starting a few teams and stepping some milliseconds
constexpr double kTypicalEquation = 12e-9;   // [s] a step, before anything is measured
constexpr double kTypicalHarmonic = 1.5e-9;  // [s] a step and channel
constexpr double kWins = 0.95;
constexpr double kRepeats = 1.5;             // two timings of the same further apart than this mean nothing
constexpr std::size_t kMostTried = 3;
constexpr std::size_t kTriedTwice = 2;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::string milliseconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g ms", 1e3 * seconds);
  return text;
}

/// The first `steps` steps of a run as a run of its own.
struct Trial {
  Input input;
  Schedule schedule;
  long steps;
};

Input beginningOf(const Input& input, double end) {
  std::vector<InputSegment> segments;
  for (int index = 0; index < input.segments() && input.segment(index).begin < end; ++index) {
    segments.push_back(input.segment(index));
  }
  segments.back().end = std::min(segments.back().end, end);
  return Input(input.channels(), std::move(segments));
}

Trial trialOf(const WayProblem& problem, long steps) {
  const double begin = problem.input.begin();
  const double h = (problem.input.end() - begin) / static_cast<double>(problem.steps);
  steps = std::clamp(steps, std::min(8l, problem.steps), problem.steps);
  double output_step = problem.schedule.outputStep();
  double length = h * static_cast<double>(steps);
  if (problem.a_step_a_sample) {
    steps = std::clamp(std::lround(length / output_step), std::min(8l, problem.steps), problem.steps);
    length = static_cast<double>(steps) * output_step;
  } else {
    output_step = std::min(output_step, length / static_cast<double>(std::min(64l, steps)));
  }
  Input input = beginningOf(problem.input, begin + std::min(length, problem.input.end() - begin));
  Schedule schedule(input, output_step);
  return {std::move(input), std::move(schedule), steps};
}

/// [s] a step by that way, without the start of its threads.
/// @param limit  [s] a way that has not come to the end by then is broken off: it is told by what it has done
double timeOf(const Way& way, const Trial& trial, double limit) {
  const int samples = trial.schedule.samples();
  const int first = samples / 4;  // caches are warm and all threads have come
  Clock::time_point begin;
  double took = 0.0;
  int last = first;
  way.run(trial.input, trial.schedule, [&](int sample, int, double, std::span<const double>) {
    if (sample < first || took > limit) return took <= limit;
    if (sample == first) begin = Clock::now();
    took = since(begin);
    last = sample;
    return took <= limit;
  });
  const double steps = static_cast<double>(trial.steps) * (last - first) / std::max(1, samples - 1);
  return took / std::max(1.0, steps);
}

/// [s] of the input of one step, swept in blocks.
double inputTime(const WayProblem& problem) {
  const Input& input = problem.input;
  const double h = (input.end() - input.begin()) / static_cast<double>(problem.steps);
  const double inside = 0.5 * (input.segment(0).end - input.begin());
  const double dt = std::min(0.5 * h, inside / Input::kBlock);
  std::vector<double> u(static_cast<std::size_t>(Input::kBlock) * 2 * static_cast<std::size_t>(input.channels()));
  double best = 1.0;
  for (int round = 0; round < 4; ++round) {
    const Clock::time_point begin = Clock::now();
    input.sweep(0, input.begin(), dt, Input::kBlock, u);
    best = std::min(best, since(begin));
  }
  return 2.0 * best / Input::kBlock;
}

/// [s] of one empty exchange between all of so many threads.
double exchangeTime(TeamChoice team, int threads) {
  constexpr long kWarm = 100;
  constexpr long kEpochs = 500;
  team.threads = threads;
  team.tracer = nullptr;
  Exchange exchange(std::vector<int>(static_cast<std::size_t>(threads), 2));
  double took = 0.0;
  runTeam(team, [&](Member& me) {
    Clock::time_point begin;
    for (long epoch = 1; epoch <= kEpochs; ++epoch) {
      if (epoch == kWarm) begin = Clock::now();
      exchange.publish(me, epoch);
      for (int other = 0; other < threads; ++other) {
        if (other != me.number()) (void)exchange.await(me, other, epoch);
      }
    }
    if (me.number() == 0) took = since(begin);
  });
  return took / static_cast<double>(kEpochs - kWarm);
}

/// Equations that the busiest thread computes in a step, redundant ones included, as a share of all.
double haloShare(const EquationSet& set, EquationMap map, int threads) {
  const EquationGraph graph(set);
  double busiest = 0.0;
  for (const std::vector<int>& share : shareEquations(set, map, threads)) {
    EquationRun run = hullOf(share);
    double work = 0.0;
    for (int stage = 0; stage < 4; ++stage, run = graph.reach(run)) work += run.size();
    busiest = std::max(busiest, work / (4.0 * graph.size()));
  }
  return busiest;
}

double stageShare(const EquationSet& set, EquationMap map, int threads) {
  std::size_t busiest = 0;
  for (const auto& share : shareEquations(set, map, threads)) busiest = std::max(busiest, share.size());
  return static_cast<double>(busiest) / static_cast<double>(set.equations().size());
}

/// What a way can reach at best [s] a step.
double predicted(const WayProblem& problem, const Way& way, const Decision& known) {
  const double exchange = way.threads < 2 ? 0.0 : known.exchange[static_cast<std::size_t>(way.threads - 2)];
  const double work = known.step - known.input;
  const EquationSet* set = problem.system.equations();
  switch (way.scheme) {
    case Scheme::kSerial:
      return known.step;
    case Scheme::kStages:
      return 4.0 * exchange + stageShare(*set, problem.map, way.threads) * known.step;
    case Scheme::kHalo:
      return exchange + haloShare(*set, problem.map, way.threads) * known.step;
    case Scheme::kRows:
      return exchange + stageShare(*set, problem.map, way.threads) * known.step;
    case Scheme::kPipeline:
      return std::max(known.step / way.threads, work);
    case Scheme::kSplit:
      return known.step / way.threads;
  }
  return known.step;
}

std::string nameOf(const Way& way) {
  if (way.threads == 1) return vehicle::nameOf(way.scheme);
  return std::string(vehicle::nameOf(way.scheme)) + " on " + std::to_string(way.threads) + " threads";
}

}  // namespace

long stepsOfRun(const Schedule& schedule, FixedStep step) {
  long steps = 0;
  for (std::size_t first = 0; first < schedule.stretches().size();) {
    const StepGrid grid = stepGridAt(schedule, first, step);
    steps += static_cast<long>(grid.steps) * static_cast<long>(grid.count);
    first += grid.count;
  }
  return steps;
}

std::vector<int> threadCounts(int most) {
  std::vector<int> counts;
  for (int threads = 2; threads < most; threads *= 2) counts.push_back(threads);
  if (most >= 2) counts.push_back(most);
  return counts;
}

Decision chooseWay(const WayProblem& problem, const std::vector<Way>& ways) {
  const Clock::time_point begin = Clock::now();
  const Way& first = ways.front();
  Decision made{.scheme = first.scheme, .threads = first.threads};
  for (const Way& way : ways) made.candidates.push_back({way.scheme, way.threads});
  const auto settle = [&](std::string reason) {
    made.calibration = since(begin);
    made.reason = std::move(reason);
    return made;
  };
  if (ways.size() == 1) return settle(nameOf(first) + ": there is no other way");

  const double steps = static_cast<double>(problem.steps);
  std::size_t harmonics = 0;
  for (int index = 0; index < problem.input.segments(); ++index) {
    harmonics = std::max(harmonics, problem.input.segment(index).angular_frequency.size());
  }
  const double guess = steps * (0.5 * problem.system.size() * kTypicalEquation +
                                static_cast<double>(harmonics) * problem.input.channels() * kTypicalHarmonic);
  if (guess * kMostShare < kLeastUseful) {
    return settle(nameOf(first) + ": a run of about " + milliseconds(guess) + " is too short to try others");
  }
  const auto stepsIn = [&](double seconds, double step) { return static_cast<long>(seconds / step); };
  const Trial probe = trialOf(problem, stepsIn(0.5e-3, guess / steps));
  const auto probed = [&] { return timeOf(first, probe, kMostSpent); };
  made.step = probed();
  made.step = std::min(made.step, probed());
  made.candidates.front().measured = made.candidates.front().predicted = made.step;
  const double budget = std::min(kMostSpent, kMostShare * made.step * steps);
  if (budget < kLeastUseful) {
    return settle(nameOf(first) + ": a run of about " + milliseconds(made.step * steps) +
                  " is too short to try others");
  }
  made.input = std::min(inputTime(problem), made.step);
  made.equation = (made.step - made.input) / std::max(1.0, 0.5 * problem.system.size());

  int most = 1;
  for (const Way& way : ways) most = std::max(most, way.threads);
  made.exchange.assign(static_cast<std::size_t>(std::max(0, most - 1)), 1.0);  // not measured: never worth it
  for (int threads = 2; threads <= most && since(begin) < 0.5 * budget; ++threads) {
    const bool asked = std::any_of(ways.begin(), ways.end(), [&](const Way& way) { return way.threads == threads; });
    if (asked) made.exchange[static_cast<std::size_t>(threads - 2)] = exchangeTime(problem.team, threads);
  }

  std::vector<std::size_t> order;
  for (std::size_t i = 1; i < ways.size(); ++i) {
    made.candidates[i].predicted = predicted(problem, ways[i], made);
    if (made.candidates[i].predicted < kWins * made.step) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return made.candidates[a].predicted < made.candidates[b].predicted;
  });
  order.resize(std::min(order.size(), kMostTried));
  if (order.empty()) return settle(nameOf(first) + ": no other way can be faster, exchanges included");

  // What is left, in equal parts: each way once, the fastest of them again, and the first way before and after.
  const double left = std::max(0.25 * budget, budget - since(begin));
  const double part = left / static_cast<double>(order.size() + std::min(order.size(), kTriedTwice) + 2);
  const Trial trial = trialOf(problem, stepsIn(part, made.step));
  const double before = timeOf(first, trial, 4.0 * part);
  const auto measured = [&](std::size_t i) { return made.candidates[i].measured; };
  // Slower than the first way took: it has lost.
  const auto tried = [&](std::size_t i) { return timeOf(ways[i], trial, part); };
  for (const std::size_t i : order) made.candidates[i].measured = tried(i);
  const auto faster = [&](std::size_t a, std::size_t b) { return measured(a) < measured(b); };
  std::stable_sort(order.begin(), order.end(), faster);
  for (std::size_t k = 0; k < std::min(order.size(), kTriedTwice); ++k) {
    const std::size_t i = order[k];
    if (since(begin) > budget) break;  // threads that are slow to start
    made.candidates[i].measured = std::min(measured(i), tried(i));
  }
  const std::size_t best = *std::min_element(order.begin(), order.end(), faster);
  const double after = timeOf(first, trial, 4.0 * part);
  if (std::max(before, after) > kRepeats * std::min(before, after)) {
    return settle(nameOf(first) + ": two timings of it differ by " +
                  std::to_string(static_cast<int>(100.0 * (std::max(before, after) / std::min(before, after) - 1.0))) +
                  " %, something else is using the machine");
  }
  made.step = std::min(before, after);
  made.candidates.front().measured = made.step;
  const double gain = made.step / made.candidates[best].measured;
  char text[96];
  std::snprintf(text, sizeof text, "%.2f times as fast as %s", gain, nameOf(first).c_str());
  if (!(made.candidates[best].measured > 0.0 && made.candidates[best].measured < kWins * made.step)) {
    return settle(nameOf(first) + ": the best other, " + nameOf(ways[best]) + ", is " + text);
  }
  made.scheme = ways[best].scheme;
  made.threads = ways[best].threads;
  return settle(nameOf(ways[best]) + ": " + text);
}

}  // namespace vehicle
