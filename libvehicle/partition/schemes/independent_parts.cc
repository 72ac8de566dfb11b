#include "libvehicle/partition/schemes/independent_parts.h"

// Samples travel in rings (spsc_ring.h) whose writer is the member that runs the part and whose reader is member 0.
// Member 0 never waits for the others while its own ring has room; it shows what all parts have reached. The writer
// waits for a ring that is full and for nothing else, so nobody waits in a circle.

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "libvehicle/threads/spsc_ring.h"

namespace vehicle {
namespace {

constexpr long kRing = 4096;  // samples that one part may be ahead of another
constexpr long kBatch = 16;

/// The whole run, seen by the members that share it.
class PartsTeam {
 public:
  PartsTeam(const std::vector<IndependentPart>& parts, int samples, const Observer& observe, int threads)
      : parts_(parts), samples_(samples), observe_(observe), threads_(static_cast<std::size_t>(threads)),
        statistics_(parts.size()) {
    std::size_t all = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const bool last_of_member = p + threads_ >= parts.size();
      rings_.push_back(std::make_unique<SpscRing>(parts[p].states,
                                                  isMerging(p)     ? kRing
                                                  : last_of_member ? std::min<long>(kRing, samples)
                                                                   : samples,
                                                  isMerging(p) ? 1 : kBatch));
      all += static_cast<std::size_t>(parts[p].states);
    }
    row_.resize(all);
    moments_.resize(kRing);
  }

  /// All parts of one member; alone, `me` is none.
  void work(std::size_t number, Member* me) {
    for (std::size_t p = number; p < parts_.size(); p += threads_) {
      if (isMerging(p)) {
        merge(p, me);
      } else {
        SpscRing& ring = *rings_[p];
        statistics_[p] = parts_[p].run(
            [&](int sample, int, double, std::span<const double> x) {
              // A ring that holds the whole run needs no member to wait by.
              if (me != nullptr && !ring.hasRoom()) me->wait([&] { return ring.hasRoom(); }, 0);
              if (me != nullptr && (sample + 1) % kBatch == 0) me->injectDelay(sample + 1);
              (void)ring.put(sample, x);
              if (me != nullptr && (sample + 1) % kBatch == 0) me->ring();
              return me == nullptr || sample % kBatch != 0 || !me->stopped();
            },
            me);
        ring.flush();
        if (me != nullptr) me->ring();
        if (me == nullptr || !me->stopped()) requireAll(p);
      }
    }
  }

  [[nodiscard]] Statistics statistics() const {
    Statistics all = statistics_.front();
    all.stopped = stopped_;
    for (std::size_t p = 1; p < parts_.size(); ++p) {
      all.evaluations += statistics_[p].evaluations;
      all.rejected += statistics_[p].rejected;
    }
    return all;
  }

 private:
  struct Moment {
    int segment;
    double t;
  };

  /// The last part of member 0: while it runs, samples are shown.
  [[nodiscard]] bool isMerging(std::size_t p) const { return p % threads_ == 0 && p + threads_ >= parts_.size(); }

  void merge(std::size_t own, Member* me) {
    SpscRing& ring = *rings_[own];
    statistics_[own] = parts_[own].run([&](int sample, int segment, double t, std::span<const double> x) {
      while (sample - shown_ >= kRing && !stopped_) showNext(me);
      (void)ring.put(sample, x);
      moments_[static_cast<std::size_t>(sample % kRing)] = {segment, t};
      put_ = sample + 1;
      while (shown_ < put_ && !stopped_ && !missing()) showNext(me);
      return !stopped_;
    }, me);
    while (shown_ < put_ && !stopped_) showNext(me);
    if (!stopped_) requireAll(own);
    if (stopped_ && me != nullptr) me->stopTeam();
  }

  /// Else the others would wait for ever.
  void requireAll(std::size_t part) const {
    if (rings_[part]->count() == samples_) return;
    throw std::invalid_argument("independent parts: part " + std::to_string(part) + " has " +
                                std::to_string(rings_[part]->count()) + " samples, must have the schedule's " +
                                std::to_string(samples_));
  }

  static bool isNextIn(SpscRing& ring) {
    long sample = 0;
    return ring.front(sample) != nullptr;
  }

  /// A part that has not reached the next sample, or none.
  [[nodiscard]] SpscRing* missing(std::size_t* which = nullptr) {
    for (std::size_t p = 0; p < rings_.size(); ++p) {
      if (isNextIn(*rings_[p])) continue;
      if (which != nullptr) *which = p;
      return rings_[p].get();
    }
    return nullptr;
  }

  void showNext(Member* me) {
    std::size_t which = 0;
    // Alone, nothing can be missing: the other parts are whole, or requireAll() has thrown.
    while (SpscRing* late = missing(&which)) {
      me->wait([&] { return isNextIn(*late); }, static_cast<int>(which % threads_));
    }
    if (me != nullptr) me->injectDelay(shown_);
    auto to = row_.begin();
    for (const auto& ring : rings_) {
      long sample = 0;
      to = std::copy_n(ring->front(sample), ring->width(), to);
      ring->pop();
    }
    if (me != nullptr && (shown_ + 1) % kBatch == 0) me->ring();
    const Moment moment = moments_[static_cast<std::size_t>(shown_ % kRing)];
    stopped_ = !observe_(static_cast<int>(shown_), moment.segment, moment.t, row_);
    ++shown_;
  }

  const std::vector<IndependentPart>& parts_;
  const long samples_;
  const Observer& observe_;
  const std::size_t threads_;
  std::vector<std::unique_ptr<SpscRing>> rings_;  // the oldest row of each is sample shown_
  std::vector<Statistics> statistics_;  // (parts) each written by its member

  // Member 0's alone.
  std::vector<double> row_;      // states of all parts at one sample
  std::vector<Moment> moments_;  // (kRing)
  long put_ = 0;                 // samples of its own part
  long shown_ = 0;
  bool stopped_ = false;
};

}  // namespace

PartsRun runIndependentParts(const std::vector<IndependentPart>& parts, int samples, const Observer& observe,
                             int threads, const TeamPolicy& team) {
  const auto count = static_cast<int>(parts.size());
  if (count < 1) throw std::invalid_argument("independent parts: there are none, must be at least one");
  if (threads < 1 || threads > count) {
    throw std::invalid_argument("independent parts: threads = " + std::to_string(threads) + ", must be 1.." +
                                std::to_string(count) + ", one a part at most");
  }
  PartsTeam work(parts, samples, observe, threads);
  PartsRun run;
  if (threads == 1) {
    work.work(0, nullptr);
  } else {
    run.team = runTeam(threads, team, [&](Member& me) { work.work(static_cast<std::size_t>(me.number()), &me); });
  }
  run.statistics = work.statistics();
  return run;
}

}  // namespace vehicle
