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
#include "libvehicle/integrate/rk4.h"
#include "libvehicle/integrate/system_rhs.h"
#include "libvehicle/linear/motion_rates.h"
#include "libvehicle/matrix/matrix_form.h"
#include "libvehicle/simulate/initial_state.h"
#include "libvehicle/simulate/run_plan.h"

namespace vehicle {

namespace {

constexpr double kAhead = 50e-3;   // [s] by which the rail is played ahead of the clock, at most
constexpr double kBetween = 2e-3;  // [s] from one look of the feeding thread to the next

/// The rail at begin, middle and end of one step after the other: (3 x 2 w), one row after the other.
class Rail {
 public:
  Rail(const Input& input, double period)
      : input_(input), period_(period), width_(2 * static_cast<std::size_t>(input.channels())), row_(3 * width_) {}

  const std::vector<double>& of(long step) {
    const double begin = input_.begin() + static_cast<double>(step) * period_;
    const double end = input_.begin() + static_cast<double>(step + 1) * period_;
    // The limits from inside the step: at its end the segment that holds before a breakpoint there.
    forward(begin);
    evaluate(0, begin);
    forward(0.5 * (begin + end));
    evaluate(1, 0.5 * (begin + end));
    while (segment_ + 1 < input_.segments() && input_.segment(segment_).end < end) ++segment_;
    evaluate(2, end);
    return row_;
  }

 private:
  void forward(double t) {
    while (segment_ + 1 < input_.segments() && input_.segment(segment_).end <= t) ++segment_;
  }
  void evaluate(std::size_t which, double t) {
    input_.evaluate(segment_, t, std::span(row_).subspan(which * width_, width_));
  }

  const Input& input_;
  double period_;
  std::size_t width_;
  std::vector<double> row_;
  int segment_ = 0;
};

/// One rk4 step of the whole form; what steps by the clock and what steps without one are two of these.
class Stepper {
 public:
  Stepper(const System& system, double period)
      : rk4_(SystemRhs(system), system.size()),
        period_(period),
        width_(2 * static_cast<std::size_t>(system.channels())) {}

  void operator()(const double* u, double* x) { rk4_.step(period_, u, u + width_, u + 2 * width_, x); }

 private:
  Rk4<SystemRhs> rk4_;
  double period_;
  std::size_t width_;
};

/// The side of the caller: puts rows in as long as there is room, takes states out as long as there are some.
class Feeder {
 public:
  Feeder(const Input& input, double period, long steps, SpscRing& rail_box, SpscRing& state_box)
      : rail_(input, period), steps_(steps), rail_box_(rail_box), state_box_(state_box) {}

  void turn() {
    for (; put_ < steps_; ++put_) {
      if (made_ <= put_) {
        row_ = rail_.of(put_);
        made_ = put_ + 1;
      }
      if (!rail_box_.put(put_, row_)) break;
    }
    for (long number = 0; state_box_.front(number) != nullptr; state_box_.pop()) {
      ++read_;
      reached_ = number;
    }
  }
  [[nodiscard]] long read() const { return read_; }
  [[nodiscard]] long reached() const { return reached_; }

 private:
  Rail rail_;
  long steps_;
  SpscRing& rail_box_;
  SpscRing& state_box_;
  std::vector<double> row_{};
  long made_ = 0;
  long put_ = 0;
  long read_ = 0;
  long reached_ = 0;
};

long stepsIn(const Input& input, double period) {
  const double duration = input.end() - input.begin();
  // A billionth of a step too little is a whole one, as in the schedule of samples.
  const double steps = std::floor(duration / period + 1e-9);
  if (!(steps >= 1.0 && steps < static_cast<double>(std::numeric_limits<int>::max()))) {
    throw std::invalid_argument(
        fmt::format("realtime: period = {:.6g} s gives {:.3g} steps in {:.6g} s, must be at least 1 and below 2e9",
                    period, steps, duration));
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
  SpscRing rail_box(6 * system->channels(), rows);
  SpscRing state_box(system->size(), rows);
  Feeder feeder(input, period, run.steps, rail_box, state_box);
  feeder.turn();
  std::atomic<bool> stop{false};
  const RealtimeChoice by_the_clock{.priority = choice.team.priority, .pinning = choice.team.pinning, .stop = &stop};
  std::vector<double> x = x0;
  Stepper stepper(*system, period);
  std::future<RealtimeReport> running = std::async(std::launch::async, [&] {
    return runRealtime(std::ref(stepper), x, {.period = period, .steps = run.steps}, by_the_clock,
                       {&rail_box, &state_box});
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

  Rail rail(input, period);
  std::vector<double> alone = x0;
  for (long i = 0; i < run.report.steps; ++i) stepper(rail.of(i).data(), alone.data());
  run.same_bits = alone == x;
  run.state = std::move(x);
  return run;
}

}  // namespace vehicle
