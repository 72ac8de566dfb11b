#include "libvehicle/partition/schemes/independent_parts.h"

// Samples travel in rings with one writer, the member that runs the part, and one reader, member 0.
//
// 1. The writer fills slots and then stores their number into written_ (release); the reader loads it (acquire)
//    before it reads a slot. So a slot that is read is whole.
// 2. The reader stores the number of slots it is done with into read_ (release); the writer loads it (acquire)
//    before it reuses a slot. So a slot that is overwritten has been read.
// 3. Both publish every kBatch samples only: the two counters would else travel between the cores at every sample,
//    which costs as much as ten steps. At its end a part publishes what is left.
// 4. Member 0 never waits for the others while its own ring has room; it shows what all parts have reached.
//    The writer waits for a ring that is full and for nothing else, so nobody waits in a circle.

#include <algorithm>
#include <atomic>
#include <bit>
#include <memory>
#include <stdexcept>
#include <string>

namespace vehicle {
namespace {

constexpr long kRing = 4096;  // samples that one part may be ahead of another
constexpr long kBatch = 16;

/// States of one part on their way to the observer.
class PartSamples {
 public:
  PartSamples(int states, long samples)
      : states_(static_cast<std::size_t>(states)),
        samples_(static_cast<long>(std::bit_ceil(static_cast<unsigned long>(samples)))) {
    values_.resize(states_ * static_cast<std::size_t>(samples_));
  }

  [[nodiscard]] std::size_t states() const { return states_; }

  // By the writer. A ring that holds the whole run needs no member to wait by.
  void put(std::span<const double> x, Member* me) {
    if (put_ - known_read_ == samples_) {
      publish();
      const auto hasRoom = [&] { return put_ - (known_read_ = read_.load(std::memory_order_acquire)) < samples_; };
      if (me != nullptr) me->wait(hasRoom, 0);
    }
    std::copy(x.begin(), x.end(), slot(put_));
    ++put_;
    if (put_ % kBatch != 0) return;
    if (me != nullptr) me->disturb(put_);
    publish();
  }
  void publish() { written_.store(put_, std::memory_order_release); }
  [[nodiscard]] long count() const { return put_; }

  // By the reader.
  [[nodiscard]] bool has(long sample) {
    if (sample < known_written_) return true;
    known_written_ = written_.load(std::memory_order_acquire);
    return sample < known_written_;
  }
  [[nodiscard]] const double* at(long sample) const { return values_.data() + place(sample); }
  void release(long sample) {
    if ((sample + 1) % kBatch == 0) read_.store(sample + 1, std::memory_order_release);
  }

 private:
  [[nodiscard]] std::size_t place(long sample) const {
    return static_cast<std::size_t>(sample & (samples_ - 1)) * states_;
  }
  double* slot(long sample) { return values_.data() + place(sample); }

  const std::size_t states_;
  const long samples_;  // a power of two: a division would cost as much as a step
  std::vector<double> values_;
  alignas(64) std::atomic<long> written_{0};
  long put_ = 0;         // the writer's
  long known_read_ = 0;  // the writer's
  alignas(64) std::atomic<long> read_{0};
  long known_written_ = 0;  // the reader's
};

/// The whole run, seen by the members that share it.
class PartsTeam {
 public:
  PartsTeam(const std::vector<IndependentPart>& parts, int samples, const Observer& observe, int threads)
      : parts_(parts), samples_(samples), observe_(observe), threads_(static_cast<std::size_t>(threads)),
        statistics_(parts.size()) {
    std::size_t all = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const bool last_of_member = p + threads_ >= parts.size();
      rings_.push_back(std::make_unique<PartSamples>(parts[p].states,
                                                    isMerging(p)     ? kRing
                                                    : last_of_member ? std::min<long>(kRing, samples)
                                                                     : samples));
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
        PartSamples& ring = *rings_[p];
        statistics_[p] = parts_[p].run([&](int sample, int, double, std::span<const double> x) {
          ring.put(x, me);
          return me == nullptr || sample % kBatch != 0 || !me->stopped();
        }, me);
        ring.publish();
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
    PartSamples& ring = *rings_[own];
    statistics_[own] = parts_[own].run([&](int sample, int segment, double t, std::span<const double> x) {
      while (sample - shown_ >= kRing && !stopped_) showNext(me);
      ring.put(x, nullptr);
      ring.publish();
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

  /// A part that has not reached the next sample, or none.
  [[nodiscard]] PartSamples* missing(std::size_t* which = nullptr) {
    for (std::size_t p = 0; p < rings_.size(); ++p) {
      if (rings_[p]->has(shown_)) continue;
      if (which != nullptr) *which = p;
      return rings_[p].get();
    }
    return nullptr;
  }

  void showNext(Member* me) {
    std::size_t which = 0;
    // Alone, nothing can be missing: the other parts are whole, or requireAll() has thrown.
    while (PartSamples* late = missing(&which)) {
      me->wait([&] { return late->has(shown_); }, static_cast<int>(which % threads_));
    }
    if (me != nullptr) me->disturb(shown_);
    auto to = row_.begin();
    for (const auto& ring : rings_) {
      to = std::copy_n(ring->at(shown_), ring->states(), to);
      ring->release(shown_);
    }
    const Moment moment = moments_[static_cast<std::size_t>(shown_ % kRing)];
    stopped_ = !observe_(static_cast<int>(shown_), moment.segment, moment.t, row_);
    ++shown_;
  }

  const std::vector<IndependentPart>& parts_;
  const long samples_;
  const Observer& observe_;
  const std::size_t threads_;
  std::vector<std::unique_ptr<PartSamples>> rings_;
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
                             const TeamChoice& team) {
  const auto count = static_cast<int>(parts.size());
  if (count < 1) throw std::invalid_argument("independent parts: there are none, must be at least one");
  if (team.threads < 1 || team.threads > count) {
    throw std::invalid_argument("independent parts: threads = " + std::to_string(team.threads) + ", must be 1.." +
                                std::to_string(count) + ", one a part at most");
  }
  PartsTeam work(parts, samples, observe, team.threads);
  PartsRun run;
  if (team.threads == 1) {
    work.work(0, nullptr);
  } else {
    run.team = runTeam(team, [&](Member& me) { work.work(static_cast<std::size_t>(me.number()), &me); });
  }
  run.statistics = work.statistics();
  return run;
}

}  // namespace vehicle
