#include "libvehicle/partition/choose.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/partition/run.h"
#include "libvehicle/partition/trial.h"

namespace vehicle {
namespace {

constexpr double kMostSpent = 0.06;          // [s]
constexpr double kMostShare = 1.0 / 50.0;    // of the run
constexpr double kLeastUseful = 4e-3;        // [s] starting a few teams and stepping some milliseconds
constexpr double kTypicalEquation = 12e-9;   // [s] a step, before anything is measured
constexpr double kTypicalHarmonic = 1.5e-9;  // [s] a step and channel
constexpr double kShortestExchange = 0.1e-6;  // [s] between cores that are close: a trial shows what it is here
constexpr double kWins = 0.97;
constexpr double kAlike = 1.15;  // predictions this near each other do not say which is faster
constexpr std::size_t kMostTried = 2;
constexpr int kLeastRounds = 3;
constexpr int kMostRounds = 9;
constexpr double kClear = 0.2;  // every round of the first ones faster or slower by this: enough seen

std::string milliseconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g ms", 1e3 * seconds);
  return text;
}

std::string nameOf(const Way& way) {
  if (way.threads == 1) return vehicle::nameOf(way.scheme);
  return std::string(vehicle::nameOf(way.scheme)) + " on " + std::to_string(way.threads) + " threads";
}

/// [s] of the input of one step, swept in blocks.
double inputTime(const TuningProblem& problem) {
  const Input& input = problem.run.input;
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

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// A way against the first one, trial by trial.
struct Rival {
  std::size_t number = 0;        // of the way
  std::vector<double> times{};   // [s] a step
  std::vector<double> shares{};  // of the time that the first way took next to it
  [[nodiscard]] double share() const { return medianOf(shares); }
  [[nodiscard]] bool isClear() const {
    const auto [least, most] = std::ranges::minmax(shares);
    return most < 1.0 - kClear || least > 1.0 + kClear;
  }
};

/// The steps to a Decision; each may be the last.
class Tuner {
 public:
  Tuner(const TuningProblem& problem, const std::vector<Way>& ways) : problem_(problem), ways_(ways) {
    made_.scheme = ways.front().scheme;
    made_.threads = ways.front().threads;
    for (const Way& way : ways) made_.candidates.push_back({way.scheme, way.threads});
  }

  Decision made() {
    made_.reason = reason();
    made_.calibration = spent();
    return std::move(made_);
  }

 private:
  std::string reason() {
    const std::string first = nameOf(ways_.front());
    if (ways_.size() == 1) return first + ": there is no other scheme to try";
    const double steps = static_cast<double>(problem_.steps);
    const double guess = steps * guessedStep();
    if (guess * kMostShare < kLeastUseful) return tooShort(guess);
    const Trial probe = trialOf(problem_, static_cast<long>(0.1 * kLeastUseful / guessedStep()));
    made_.step = timeOf(ways_.front(), probe, kLeastUseful, problem_.now);
    made_.candidates.front().measured = made_.candidates.front().predicted = made_.step;
    budget_ = std::min(kMostSpent, kMostShare * made_.step * steps);
    if (budget_ < kLeastUseful) return tooShort(made_.step * steps);
    made_.input = std::min(inputTime(problem_), made_.step);
    std::vector<Rival> rivals = promising();
    if (rivals.empty()) return first + ": no other scheme can be faster, exchanges included";
    tryByTurns(rivals);
    return judge(*std::ranges::min_element(rivals, {}, &Rival::share));
  }

  [[nodiscard]] std::string tooShort(double run) const {
    return nameOf(ways_.front()) + ": a run of about " + milliseconds(run) + " is too short to try others";
  }

  /// [s] a step before anything is measured.
  [[nodiscard]] double guessedStep() const {
    std::size_t harmonics = 0;
    for (int index = 0; index < problem_.run.input.segments(); ++index) {
      harmonics = std::max(harmonics, problem_.run.input.segment(index).angular_frequency.size());
    }
    return 0.5 * problem_.run.system.size() * kTypicalEquation +
           static_cast<double>(harmonics) * problem_.run.input.channels() * kTypicalHarmonic;
  }

  /// The ways that the rule of thumb puts first, where it puts them before the first way.
  std::vector<Rival> promising() {
    const StepCosts costs{made_.step, made_.input, kShortestExchange};
    std::vector<Rival> rivals;
    for (std::size_t i = 1; i < ways_.size(); ++i) {
      double& predicted = made_.candidates[i].predicted;
      predicted = bestStep(costs, problem_.run.system.equations(), {ways_[i].threads, ways_[i].scheme, problem_.map});
      if (predicted < kWins * made_.step) rivals.push_back({.number = i});
    }
    const auto predicted = [&](const Rival& rival) { return made_.candidates[rival.number].predicted; };
    std::ranges::stable_sort(rivals, {}, predicted);
    while (rivals.size() > kMostTried ||
           (rivals.size() > 1 && predicted(rivals.back()) > kAlike * predicted(rivals.front()))) {
      rivals.pop_back();
    }
    return rivals;
  }

  /// What is left, in rounds of equal parts: the first way, then each rival. What else happens on the machine meets
  /// both sides of a round alike, or one round among several.
  void tryByTurns(std::vector<Rival>& rivals) {
    const double part = budget_ / static_cast<double>(kMostRounds * (rivals.size() + 1));
    const Trial trial = trialOf(problem_, static_cast<long>(std::max(part, 0.25 * kLeastUseful) / made_.step));
    std::vector<double> own;
    for (int round = 0; round < kMostRounds; ++round) {
      if (round >= kLeastRounds && (spent() > budget_ || std::ranges::all_of(rivals, &Rival::isClear))) break;
      own.push_back(timeOf(ways_.front(), trial, 4.0 * part + kLeastUseful, problem_.now));
      // A rival that takes twice as long is broken off there: it has lost the round.
      const double limit = 2.0 * own.back() * static_cast<double>(trial.steps);
      for (Rival& rival : rivals) {
        rival.times.push_back(timeOf(ways_[rival.number], trial, limit, problem_.now));
        rival.shares.push_back(rival.times.back() / own.back());
      }
    }
    made_.step = made_.candidates.front().measured = medianOf(own);
    for (const Rival& rival : rivals) made_.candidates[rival.number].measured = medianOf(rival.times);
  }

  std::string judge(const Rival& best) {
    const Way& way = ways_[best.number];
    const auto [least, most] = std::ranges::minmax(best.shares);
    char text[160];
    std::snprintf(text, sizeof text, "%.2f times as fast as %s, the median of %zu alternating trials (%.2f to %.2f)",
                  1.0 / best.share(), nameOf(ways_.front()).c_str(), best.shares.size(), 1.0 / most, 1.0 / least);
    if (best.share() >= kWins) {
      return nameOf(ways_.front()) + ": the best other, " + nameOf(way) + ", is " + text;
    }
    made_.scheme = way.scheme;
    made_.threads = way.threads;
    return nameOf(way) + ": " + text;
  }

  [[nodiscard]] double spent() const { return problem_.now() - begin_; }

  const TuningProblem& problem_;
  const std::vector<Way>& ways_;
  double begin_ = problem_.now();
  double budget_ = 0.0;  // [s] for all of it
  Decision made_;
};

}  // namespace

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

long stepsOfRun(const Schedule& schedule, FixedStep step) {
  long steps = 0;
  for (std::size_t first = 0; first < schedule.intervals().size();) {
    const StepGrid grid = stepGridFrom(schedule.intervals()[first], step);
    steps += grid.total();
    first += static_cast<std::size_t>(grid.count);
  }
  return steps;
}

std::vector<int> threadCounts(int most) {
  std::vector<int> counts;
  for (int threads = 2; threads < most; threads *= 2) counts.push_back(threads);
  if (most >= 2) counts.push_back(most);
  return counts;
}

Decision chooseWay(const TuningProblem& problem, const std::vector<Way>& ways) { return Tuner(problem, ways).made(); }

}  // namespace vehicle
