#include "libvehicle/realtime/realtime_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/integrate/system_rhs.h"
#include "libvehicle/linear/motion_rates.h"
#include "libvehicle/matrix/matrix_form.h"
#include "libvehicle/simulate/initial_state.h"
#include "libvehicle/simulate/run_plan.h"

namespace vehicle {

namespace {

constexpr double kAhead = 50e-3;   // [s] by which the rail is played ahead of the clock, at most
constexpr double kBetween = 2e-3;  // [s] from one look of the feeding thread to the next

/// The steps of one period as a row of numbers: how many there are, and of each h and the input at its begin, middle and
/// end. More than one where the rail has breakpoints inside the period: steps end on them.
class PeriodRow {
 public:
  PeriodRow(int channels, int most_steps)
      : instant_(2 * static_cast<std::size_t>(channels)), numbers_(1 + static_cast<std::size_t>(most_steps) * step()) {}

  void clear() { numbers_[0] = 0.0; }
  /// @param input  (3 x 2 w)
  void add(double h, const double* input) {
    double* to = numbers_.data() + 1 + static_cast<std::size_t>(numbers_[0]) * step();
    *to = h;
    std::copy_n(input, 3 * instant_, to + 1);
    numbers_[0] += 1.0;
  }
  [[nodiscard]] const std::vector<double>& numbers() const { return numbers_; }

  /// @param move  move(double h, const double* input) for each step of a row
  template <class Move>
  void forSteps(const double* numbers, Move move) const {
    const double* next = numbers + 1;
    for (int left = static_cast<int>(numbers[0]); left > 0; --left, next += step()) move(next[0], next + 1);
  }

  /// One step of that length over an input that stays as it was at the end of `newest`, or zero where that has no steps.
  void hold(double period, std::span<const double> newest, std::span<double> held) const {
    const auto steps = static_cast<std::size_t>(newest[0]);
    const double* end = newest.data() + 1 + steps * step() - instant_;  // of the last step
    held[0] = 1.0;
    held[1] = period;
    for (std::size_t part = 0; part < 3; ++part) {
      double* to = held.data() + 2 + part * instant_;
      if (steps > 0)
        std::copy_n(end, instant_, to);
      else
        std::fill_n(to, instant_, 0.0);
    }
  }

 private:
  [[nodiscard]] std::size_t step() const { return 1 + 3 * instant_; }

  std::size_t instant_;  // values of the input at one instant
  std::vector<double> numbers_;
};

/// The rail period by period, in the steps that rk4 makes of it without a clock.
class Rail {
 public:
  Rail(const Input& input, double period, const Schedule& schedule)
      : next_(schedule.intervals().begin()),
        width_(2 * input.channels()),
        cursor_({period}),
        feed_(input),
        row_(input.channels(), mostIntervals(schedule)) {}

  const std::vector<double>& nextPeriod() {
    row_.clear();
    for (bool ended = false; !ended; ++next_) {
      const Interval interval = *next_;
      cursor_.advance(
          interval, [&](const StepBlock& block) { rows_ = feed_(block); },
          [&](double h, int k) { row_.add(h, rows_ + 2 * k * width_); }, [](double) { return true; });
      ended = interval.sample >= 0;
    }
    return row_.numbers();
  }
  [[nodiscard]] const PeriodRow& row() const { return row_; }

 private:
  static int mostIntervals(const Schedule& schedule) {
    int most = 0;
    int count = 0;
    for (const Interval interval : schedule.intervals()) {
      most = std::max(most, ++count);
      if (interval.sample >= 0) count = 0;
    }
    return most;
  }

  Schedule::Iterator next_;
  int width_;
  StepCursor cursor_;
  SweptInput feed_;
  const double* rows_ = nullptr;
  PeriodRow row_;
};

/// The side of the caller: puts rows in as long as there is room, takes states out as long as there are some.
class Feeder {
 public:
  Feeder(Rail& rail, long steps, SpscRing& rail_box, SpscRing& state_box)
      : rail_(rail), steps_(steps), rail_box_(rail_box), state_box_(state_box) {}

  void turn() {
    for (; put_ < steps_; ++put_) {
      if (made_ <= put_) {
        row_ = &rail_.nextPeriod();
        made_ = put_ + 1;
      }
      if (!rail_box_.put(put_, *row_)) break;
    }
    for (long number = 0; state_box_.front(number) != nullptr; state_box_.pop()) {
      ++read_;
      reached_ = number;
    }
  }
  [[nodiscard]] long read() const { return read_; }
  [[nodiscard]] long reached() const { return reached_; }

 private:
  Rail& rail_;
  long steps_;
  SpscRing& rail_box_;
  SpscRing& state_box_;
  const std::vector<double>* row_ = nullptr;
  long made_ = 0;
  long put_ = 0;
  long read_ = 0;
  long reached_ = 0;
};

long stepsIn(const Input& input, double period) {
  const double duration = input.end() - input.begin();
  // A billionth of a step too little is a whole one, as in the schedule of samples.
  const double steps = std::floor(duration / period + 1e-9);
  if (!(steps >= 1.0 && steps <= kMostSamples)) {
    throw std::invalid_argument(fmt::format("realtime: period = {:.6g} s gives {:.3g} steps in {:.6g} s, must be 1..{}",
                                            period, steps, duration, kMostSamples));
  }
  return static_cast<long>(steps);
}

}  // namespace

RealtimeRun simulateRealtime(const CompiledModel& model, const Scenario& scenario, const RunChoice& choice,
                             double period, const Progress& progress) {
  requireRunnable(model, scenario);
  if (!(period >= 1e-6 && period <= 3600.0)) {
    throw std::invalid_argument(fmt::format("realtime: period = {} s, must be between 1e-6 s and 3600 s", period));
  }
  RealtimeRun run;
  run.form = choice.form.empty() ? defaultForm(model.topology) : choice.form;
  run.speed = choice.speed.value_or(scenario.run.speed);
  const std::unique_ptr<System> system = buildForm(run.form, model);
  const Input input = inputOf(scenario, model.topology, run.speed);
  run.steps = stepsIn(input, period);
  const MotionRates rates = motionRatesOf(run.form, *system, model);
  if (auto warning = stepWarning(period, input.end() - input.begin(), rates, "--realtime")) {
    run.warnings.push_back(std::move(*warning));
  }
  const std::vector<double> x0 = initialState(*system, model, scenario, input);

  const int rows = static_cast<int>(std::clamp(kAhead / period, 64.0, 65536.0));
  const Schedule schedule(input, period);
  Rail rail(input, period, schedule);
  SpscRing rail_box(static_cast<int>(rail.row().numbers().size()), rows);
  SpscRing state_box(system->size(), rows);
  Feeder feeder(rail, run.steps, rail_box, state_box);
  feeder.turn();
  std::atomic<bool> stop{false};
  const RealtimeChoice by_the_clock{.priority = choice.team.priority, .pinning = choice.team.pinning, .stop = &stop};
  std::vector<double> x = x0;
  Rk4<SystemRhs> rk4(SystemRhs(*system), system->size());
  const PeriodRow& row = rail.row();
  const RealtimeStep step = [&, width = 2 * system->channels()](const double* numbers, double* state) {
    row.forSteps(numbers, [&](double h, const double* u) { rk4.step(h, u, u + width, u + 2 * width, state); });
  };
  const HoldRow hold = [&](std::span<const double> newest, std::span<double> held) { row.hold(period, newest, held); };
  std::future<RealtimeReport> running = std::async(std::launch::async, [&] {
    return runRealtime(step, x, {.period = period, .steps = run.steps}, by_the_clock, {&rail_box, &state_box, hold});
  });
  const std::chrono::duration<double> between(kBetween);
  while (running.wait_for(between) != std::future_status::ready) {
    feeder.turn();
    if (progress && !progress(static_cast<double>(feeder.reached()) / static_cast<double>(run.steps))) stop = true;
  }
  try {
    run.report = running.get();
  } catch (const std::runtime_error& failure) {
    throw RunFailed(fmt::format("{} in real time: {}", run.form, failure.what()));
  }
  feeder.turn();
  run.states_read = feeder.read();

  std::vector<double> alone = x0;
  makeRk4({*system, input, schedule, x0}, {period})
      ->run(schedule, x0, [&](int sample, int, double, std::span<const double> state) {
        if (sample <= run.report.steps) alone.assign(state.begin(), state.end());
        return sample < run.report.steps;
      });
  run.same_bits = alone == x;
  run.state = std::move(x);
  return run;
}

}  // namespace vehicle
