#include "libvehicle/partition/choose.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <utility>

#include "libvehicle/integrate/fixed_step_run.h"
#include "libvehicle/partition/map/equation_graph.h"
#include "libvehicle/partition/map/equation_map.h"
#include "libvehicle/partition/trial.h"
#include "libvehicle/threads/exchange.h"

namespace vehicle {
namespace {

constexpr double kMostSpent = 0.015;         // [s]
constexpr double kMostShare = 1.0 / 60.0;    // of the run
constexpr double kLeastUseful = 4e-3;        // [s] starting a few teams and stepping some milliseconds
constexpr double kTypicalEquation = 12e-9;   // [s] a step, before anything is measured
constexpr double kTypicalHarmonic = 1.5e-9;  // [s] a step and channel
constexpr double kWins = 0.95;
constexpr double kLeastTrials = 4.0;         // the first way before and after, another one twice
constexpr double kRepeats = 1.5;             // two timings of the same further apart than this mean nothing
constexpr std::size_t kMostTried = 3;
constexpr std::size_t kTriedTwice = 2;

std::string milliseconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g ms", 1e3 * seconds);
  return text;
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
    const double begin = problem.now();
    input.sweep(0, input.begin(), dt, Input::kBlock, u);
    best = std::min(best, problem.now() - begin);
  }
  return 2.0 * best / Input::kBlock;
}

/// [s] of one empty exchange between all of so many threads.
double exchangeTime(const WayProblem& problem, int threads) {
  constexpr long kWarm = 100;
  constexpr long kEpochs = 500;
  TeamChoice team = problem.team;
  team.threads = threads;
  team.tracer = nullptr;
  Exchange exchange(std::vector<int>(static_cast<std::size_t>(threads), 2));
  double took = 0.0;
  runTeam(team, [&](Member& me) {
    double begin = 0.0;
    for (long epoch = 1; epoch <= kEpochs; ++epoch) {
      if (epoch == kWarm && me.number() == 0) begin = problem.now();
      exchange.publish(me, epoch);
      for (int other = 0; other < threads; ++other) {
        if (other != me.number()) (void)exchange.await(me, other, epoch);
      }
    }
    if (me.number() == 0) took = problem.now() - begin;
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

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

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

namespace {

/// The steps to a Decision; each may be the last.
class Choosing {
 public:
  Choosing(const WayProblem& problem, const std::vector<Way>& ways)
      : problem_(problem), ways_(ways), first_(ways.front()), steps_(static_cast<double>(problem.steps)) {
    made_.scheme = first_.scheme;
    made_.threads = first_.threads;
    for (const Way& way : ways) made_.candidates.push_back({way.scheme, way.threads});
  }

  Decision made() {
    made_.reason = reason();
    made_.calibration = spent();
    return std::move(made_);
  }

 private:
  std::string reason() {
    if (ways_.size() == 1) return nameOf(first_) + ": there is no other scheme to try";
    const double guess = guessedRun();
    if (guess * kMostShare < kLeastUseful) return tooShort(guess);
    timeFirst(guess);
    budget_ = std::min(kMostSpent, kMostShare * made_.step * steps_);
    if (budget_ < kLeastUseful) return tooShort(made_.step * steps_);
    if (kLeastTrials * start_ + spent() > budget_) {
      return nameOf(first_) + ": a trial takes " + milliseconds(start_) +
             " before its first step, too long to try others";
    }
    timeParts();
    std::vector<std::size_t> promising = mostPromising();
    if (promising.empty()) return nameOf(first_) + ": no other scheme can be faster, exchanges included";
    return tryOut(std::move(promising));
  }

  std::string tooShort(double run) const {
    return nameOf(first_) + ": a run of about " + milliseconds(run) + " is too short to try others";
  }

  /// [s] of the whole run before anything is measured.
  [[nodiscard]] double guessedRun() const {
    std::size_t harmonics = 0;
    for (int index = 0; index < problem_.input.segments(); ++index) {
      harmonics = std::max(harmonics, problem_.input.segment(index).angular_frequency.size());
    }
    return steps_ * (0.5 * problem_.system.size() * kTypicalEquation +
                     static_cast<double>(harmonics) * problem_.input.channels() * kTypicalHarmonic);
  }

  void timeFirst(double guess) {
    const Trial probe = trialOf(problem_, stepsIn(0.5e-3, guess / steps_));
    made_.step = start_ = std::numeric_limits<double>::max();
    const auto look = [&] {
      const double begin = problem_.now();
      const double step = timed(first_, probe, kMostSpent);
      made_.step = std::min(made_.step, step);
      start_ = std::min(start_, std::max(0.0, problem_.now() - begin - step * static_cast<double>(probe.steps)));
    };
    look();
    if (spent() < kMostSpent) look();
    made_.candidates.front().measured = made_.candidates.front().predicted = made_.step;
  }

  /// The input, an equation, the exchanges between as many threads as any way has.
  void timeParts() {
    made_.input = std::min(inputTime(problem_), made_.step);
    made_.equation = (made_.step - made_.input) / std::max(1.0, 0.5 * problem_.system.size());
    int most = 1;
    for (const Way& way : ways_) most = std::max(most, way.threads);
    made_.exchange.assign(static_cast<std::size_t>(most - 1), 1.0);  // not measured: never worth it
    for (int threads = 2; threads <= most && spent() < 0.5 * budget_; ++threads) {
      const bool asked =
          std::any_of(ways_.begin(), ways_.end(), [&](const Way& way) { return way.threads == threads; });
      if (asked) made_.exchange[static_cast<std::size_t>(threads - 2)] = exchangeTime(problem_, threads);
    }
  }

  /// Indices of the ways that may win, the most promising first.
  std::vector<std::size_t> mostPromising() {
    std::vector<std::size_t> order;
    for (std::size_t i = 1; i < ways_.size(); ++i) {
      made_.candidates[i].predicted = predicted(problem_, ways_[i], made_);
      if (made_.candidates[i].predicted < kWins * made_.step) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return made_.candidates[a].predicted < made_.candidates[b].predicted;
    });
    order.resize(std::min(order.size(), kMostTried));
    return order;
  }

  /// What is left, in equal parts: each way once, the fastest of them again, and the first way before and after.
  std::string tryOut(std::vector<std::size_t> order) {
    const double left = std::max(0.25 * budget_, budget_ - spent());
    const double part = left / static_cast<double>(order.size() + std::min(order.size(), kTriedTwice) + 2);
    const Trial trial = trialOf(problem_, stepsIn(part, made_.step));
    const double before = timed(first_, trial, 4.0 * part);
    // A way slower than the first one took is broken off there: it has lost.
    const auto tried = [&](std::size_t i) { return timed(ways_[i], trial, part); };
    const auto measured = [&](std::size_t i) -> double& { return made_.candidates[i].measured; };
    const auto faster = [&](std::size_t a, std::size_t b) { return measured(a) < measured(b); };
    for (const std::size_t i : order) measured(i) = tried(i);
    std::stable_sort(order.begin(), order.end(), faster);
    for (std::size_t k = 0; k < std::min(order.size(), kTriedTwice); ++k) {
      if (spent() > budget_) break;  // threads that are slow to start
      measured(order[k]) = std::min(measured(order[k]), tried(order[k]));
    }
    const double after = timed(first_, trial, 4.0 * part);
    return judge(*std::min_element(order.begin(), order.end(), faster), before, after);
  }

  /// @param before, after  [s] a step of the first way, before the best other was tried and after
  std::string judge(std::size_t best, double before, double after) {
    if (std::max(before, after) > kRepeats * std::min(before, after)) {
      const double apart = std::max(before, after) / std::min(before, after) - 1.0;
      return nameOf(first_) + ": two timings of it differ by " + std::to_string(static_cast<int>(100.0 * apart)) +
             " %, something else is using the machine";
    }
    made_.step = std::min(before, after);
    made_.candidates.front().measured = made_.step;
    const double other = made_.candidates[best].measured;
    char text[96];
    std::snprintf(text, sizeof text, "%.2f times as fast as %s", made_.step / other, nameOf(first_).c_str());
    if (!(other > 0.0 && other < kWins * made_.step)) {
      return nameOf(first_) + ": the best other, " + nameOf(ways_[best]) + ", is " + text;
    }
    made_.scheme = ways_[best].scheme;
    made_.threads = ways_[best].threads;
    return nameOf(ways_[best]) + ": " + text;
  }

  [[nodiscard]] double spent() const { return problem_.now() - begin_; }
  [[nodiscard]] double timed(const Way& way, const Trial& trial, double limit) const {
    return timeOf(way, trial, limit, problem_.now);
  }
  static long stepsIn(double seconds, double step) { return static_cast<long>(seconds / step); }

  const WayProblem& problem_;
  const std::vector<Way>& ways_;
  const Way& first_;
  double steps_;
  double begin_ = problem_.now();
  double start_ = 0.0;   // [s] of a trial before its first step, as an exact method takes to find its matrices
  double budget_ = 0.0;  // [s] for all of it
  Decision made_;
};

}  // namespace

Decision chooseWay(const WayProblem& problem, const std::vector<Way>& ways) { return Choosing(problem, ways).made(); }

}  // namespace vehicle
