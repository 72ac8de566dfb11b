#include "libvehicle/threads/trace.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <stdexcept>
#include <thread>
#include <utility>

namespace vehicle {

namespace {

// A whole step must fit, or the figures of its waits would be cut off: 4 stages, each with a few neighbours.
constexpr std::size_t kRoomForAStep = 64;
constexpr double kCalibration = 10e-3;  // [s] two clock readings of 50 ns error: 1e-5
constexpr double kUneven = 5e-3;        // share by which the counter's rate may differ between two intervals

void requireAtLeastOne(const char* name, int value) {
  if (value < 1)
    throw std::invalid_argument(std::string("tracer: ") + name + " = " + std::to_string(value) + ", must be >= 1");
}

}  // namespace

ThreadTrace::ThreadTrace(int every, std::size_t spans, bool counts_every_step, ThreadTrace* before)
    : records_(before != nullptr ? std::move(before->records_) : std::vector<Record>(spans)),
      every_(every),
      counts_every_step_(counts_every_step) {}

void ThreadTrace::openStep(long step) {
  next_ = (step / every_ + 1) * every_;
  if (step % every_ != 0) return;
  if (records_.size() - used_ < std::min(kRoomForAStep, records_.size())) {
    ++dropped_;
    return;
  }
  open_ = true;
  step_ = step;
  ++traced_;
  mark_ = stamp();
}

Tracer::Tracer(int every, int spans_per_thread) : every_(every), spans_per_thread_(spans_per_thread) {
  requireAtLeastOne("every", every);
  requireAtLeastOne("spans per thread", spans_per_thread);
}

void Tracer::prepare(int threads) {
  // Memory that was touched once stays: a run of a millisecond would spend as long on new pages.
  std::vector<ThreadTrace> before = std::exchange(threads_, {});
  for (std::size_t i = 0; i < static_cast<std::size_t>(threads); ++i) {
    threads_.emplace_back(every_, static_cast<std::size_t>(spans_per_thread_), i == 0,
                          i < before.size() ? &before[i] : nullptr);
  }
  begin_ = now();
}

Tracer::Instant Tracer::now() {
  using std::chrono::steady_clock;
  return {stampTicks(), std::chrono::duration<double>(steady_clock::now().time_since_epoch()).count()};
}

double Tracer::stampCost() const {
  constexpr int kRounds = 20;
  constexpr int kReadings = 1000;
  double least = 1.0;
  for (int round = 0; round < kRounds; ++round) {
    const double begin = now().seconds;
    std::uint64_t seen = 0;
    for (int i = 0; i < kReadings; ++i) seen |= stampTicks();
    const double took = now().seconds - begin;
    if (seen != 0) least = std::min(least, took / kReadings);
  }
  return least;
}

Trace Tracer::trace() const {
  Trace told;
  told.threads = static_cast<int>(threads_.size());
  told.every = every_;
  told.stamp_cost = stampCost();
  if (threads_.empty()) return told;

  const Instant middle = now();
  std::this_thread::sleep_for(std::chrono::duration<double>(kCalibration));
  const Instant end = now();
  const auto secondsPerTick = [](const Instant& from, const Instant& to) {
    return (to.seconds - from.seconds) / static_cast<double>(to.ticks - from.ticks);
  };
  const double tick = secondsPerTick(begin_, end);
  const double after_run = secondsPerTick(middle, end);
  if (std::abs(after_run - tick) > kUneven * tick) {
    told.clock_note = "the time-stamp counter runs unevenly: times may be wrong by " +
                      std::to_string(static_cast<int>(std::ceil(100.0 * std::abs(after_run - tick) / tick))) + " %";
  }
  const auto sinceBegin = [&](std::uint64_t ticks) { return tick * static_cast<double>(ticks - begin_.ticks); };

  std::map<std::pair<int, int>, WaitTotal> waits;
  for (int i = 0; i < told.threads; ++i) {
    const ThreadTrace& seen = threads_[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < seen.used_; ++k) {
      const ThreadTrace::Record& record = seen.records_[k];
      told.spans.push_back(
          {i, record.step, record.kind, sinceBegin(record.begin), sinceBegin(record.end), record.for_whom});
      if (record.kind != Span::Kind::kWait) continue;
      WaitTotal& total = waits[{i, record.for_whom}];
      total.thread = i;
      total.for_whom = record.for_whom;
      ++total.count;
      total.seconds += tick * static_cast<double>(record.end - record.begin);
    }
    told.stamps += seen.stamps_;
    told.dropped_steps += seen.dropped_;
  }
  for (const auto& [pair, total] : waits) told.waits.push_back(total);
  std::ranges::stable_sort(told.waits, std::ranges::greater{}, &WaitTotal::seconds);

  const ThreadTrace& first = threads_.front();
  told.traced_steps = first.traced_;
  told.steps = first.steps_.summary(tick);
  told.overhead = told.stamp_cost * static_cast<double>(first.stamps_);
  told.run_seconds = tick * static_cast<double>(first.last_end_ - first.first_begin_);
  return told;
}

}  // namespace vehicle
