#include "libvehicle/realtime/realtime.h"

#include <sys/mman.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <stdexcept>
#include <vector>

#include "libvehicle/integrate/failure.h"

namespace vehicle {

namespace {

using Nanoseconds = std::int64_t;

constexpr double kLeastPeriod = 1e-6;      // [s] below, the clock itself is most of the period
constexpr double kMostPeriod = 3600.0;     // [s]
constexpr Nanoseconds kLook = 50'000'000;  // between two looks at choice.stop in a long sleep
constexpr unsigned long kTimerSlack = 1;   // [ns] Linux adds 50 us to every sleep of an ordinary thread

Nanoseconds monotonic() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1'000'000'000 * static_cast<Nanoseconds>(now.tv_sec) + now.tv_nsec;
}

void sleepUntil(Nanoseconds instant) {
  const timespec until{.tv_sec = instant / 1'000'000'000, .tv_nsec = instant % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

void check(std::span<double> x, const ReleaseClock& clock, RealtimeRows rows) {
  if (!(clock.period >= kLeastPeriod && clock.period <= kMostPeriod)) {
    throw std::invalid_argument("realtime: period = " + std::to_string(clock.period) +
                                " s, must be between 1e-6 s and 3600 s");
  }
  if (clock.steps < 0) {
    throw std::invalid_argument("realtime: steps = " + std::to_string(clock.steps) + ", must be >= 0");
  }
  checkStart("realtime", x, static_cast<int>(x.size()));
  if (rows.input != nullptr && !rows.hold && rows.input->width() % 3 != 0) {
    throw std::invalid_argument("realtime: rows of the input have " + std::to_string(rows.input->width()) +
                                " values, must be three times the input: begin, middle and end of a step");
  }
  if (rows.output != nullptr && rows.output->width() != static_cast<int>(x.size())) {
    throw std::invalid_argument("realtime: rows of the output have " + std::to_string(rows.output->width()) +
                                " values, must have " + std::to_string(x.size()) + ", one a state");
  }
}

void holdEnd(std::span<const double> newest, std::span<double> held) {
  const std::size_t width = held.size() / 3;
  for (std::size_t part = 0; part < 3; ++part) std::copy_n(newest.end() - width, width, held.begin() + part * width);
}

// The input of one step after the other.
class InputRows {
 public:
  InputRows(RealtimeRows rows, RealtimeReport& report)
      : ring_(rows.input),
        hold_(rows.hold ? rows.hold : holdEnd),
        report_(report),
        held_(ring_ == nullptr ? 0 : static_cast<std::size_t>(ring_->width()), 0.0) {
    hold_(std::vector<double>(held_.size(), 0.0), held_);
  }

  // The rows of that step, valid until the next call.
  const double* of(long step) {
    if (ring_ == nullptr) return nullptr;
    if (given_) ring_->pop();
    given_ = false;
    long number = 0;
    const double* row = ring_->front(number);
    for (; row != nullptr && number < step; row = ring_->front(number)) {
      hold(number, row);
      ring_->pop();
      ++report_.inputs_late;
    }
    if (row == nullptr || number > step) {
      ++report_.inputs_held;
      return held_.data();
    }
    hold(number, row);
    given_ = true;
    return row;
  }

 private:
  // From now on a missing row is the end of this one, unless it is older than what is held already.
  void hold(long number, const double* row) {
    if (number < newest_) return;
    newest_ = number;
    hold_({row, held_.size()}, held_);
  }

  SpscRing* ring_;
  HoldRow hold_;
  RealtimeReport& report_;
  std::vector<double> held_;  // what a step without a row of its own gets
  long newest_ = -1;
  bool given_ = false;  // the front row is in use
};

// Locks what is mapped now and no later mapping: under a limit, other threads could not allocate any more.
class LockedMemory {
 public:
  LockedMemory(RealtimeChoice::Memory wanted, RealtimeReport& report) {
    if (wanted == RealtimeChoice::Memory::kPaged) {
      report.memory_note = "not asked for";
      return;
    }
    locked_ = mlockall(MCL_CURRENT) == 0;
    report.memory_locked = locked_;
    if (!locked_) {
      report.memory_note = std::string("mlockall was refused (") + std::strerror(errno) +
                           "); it needs CAP_IPC_LOCK or a memory lock limit (ulimit -l)";
    }
  }
  ~LockedMemory() {
    if (locked_) munlockall();
  }
  LockedMemory(const LockedMemory&) = delete;
  LockedMemory& operator=(const LockedMemory&) = delete;

 private:
  bool locked_ = false;
};

class ReleasedRun {
 public:
  ReleasedRun(const RealtimeStep& step, std::span<double> x, ReleaseClock clock, const RealtimeChoice& choice,
              RealtimeRows rows)
      : step_(step), x_(x), clock_(clock), choice_(choice), rows_(rows, report_), output_(rows.output) {}

  RealtimeReport run() {
    TeamReport team =
        runTeam(1, {.pinning = choice_.pinning, .priority = choice_.priority}, [this](Member&) { stepAll(); });
    report_.thread = std::move(team.members.front());
    report_.wake_up = wake_up_.summary(1e-9);
    report_.step = duration_.summary(1e-9);
    report_.response = response_.summary(1e-9);
    return std::move(report_);
  }

 private:
  void stepAll() {
    prctl(PR_SET_TIMERSLACK, kTimerSlack);
    const LockedMemory memory(choice_.memory, report_);
    begin_ = monotonic() + releaseAt(1);
    long release = 0;
    while (report_.steps < clock_.steps) {
      const Nanoseconds released = begin_ + releaseAt(release);
      if (!arrived(released)) {
        report_.stopped = true;
        return;
      }
      const Nanoseconds woke = monotonic();
      stepOnce();
      const Nanoseconds ended = monotonic();
      wake_up_.record(static_cast<std::uint64_t>(std::max<Nanoseconds>(woke - released, 0)));
      duration_.record(static_cast<std::uint64_t>(ended - woke));
      response_.record(static_cast<std::uint64_t>(std::max<Nanoseconds>(ended - released, 0)));
      ++release;
      if (ended <= begin_ + releaseAt(release)) continue;
      ++report_.deadline_misses;
      const long next = nextRelease(ended, release);
      report_.skipped_releases += next - release;
      release = next;
    }
  }

  void stepOnce() {
    step_(rows_.of(report_.steps), x_.data());
    ++report_.steps;
    requireFinite("realtime", static_cast<double>(report_.steps) * clock_.period, x_);
    if (output_ != nullptr && !output_->put(report_.steps, x_)) ++report_.outputs_lost;
  }

  // Rounded from the product, so that the releases do not drift away from k period.
  [[nodiscard]] Nanoseconds releaseAt(long release) const {
    return std::llround(1e9 * clock_.period * static_cast<double>(release));
  }

  // The first release from `release` on that is not before that instant.
  [[nodiscard]] long nextRelease(Nanoseconds instant, long release) const {
    const double passed = static_cast<double>(instant - begin_) / (1e9 * clock_.period);
    long next = std::max(release, static_cast<long>(passed) - 1);
    while (begin_ + releaseAt(next) < instant) ++next;
    return next;
  }

  // Sleeps until then; false if the run was stopped before.
  [[nodiscard]] bool arrived(Nanoseconds released) const {
    for (Nanoseconds now = monotonic();; now = monotonic()) {
      if (choice_.stop != nullptr && choice_.stop->load(std::memory_order_acquire)) return false;
      if (now >= released) return true;
      sleepUntil(choice_.stop == nullptr ? released : std::min(released, now + kLook));
    }
  }

  const RealtimeStep& step_;
  std::span<double> x_;
  ReleaseClock clock_;
  const RealtimeChoice& choice_;
  RealtimeReport report_;
  InputRows rows_;
  SpscRing* output_;
  Nanoseconds begin_ = 0;
  DurationHistogram wake_up_;
  DurationHistogram duration_;
  DurationHistogram response_;
};

}  // namespace

RealtimeReport runRealtime(const RealtimeStep& step, std::span<double> x, ReleaseClock clock,
                           const RealtimeChoice& choice, RealtimeRows rows) {
  check(x, clock, rows);
  return ReleasedRun(step, x, clock, choice, rows).run();
}

}  // namespace vehicle
