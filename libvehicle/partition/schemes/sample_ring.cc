#include "libvehicle/partition/schemes/sample_ring.h"

#include <algorithm>

#include "libvehicle/integrate/failure.h"

namespace vehicle {
namespace {

// A long state would push the equations' own data out of the cache.
int slotsFor(int states) { return states <= 4096 ? SampleRing::kMostSlots : 2; }

}  // namespace

SampleRing::SampleRing(const char* method, int threads, int states, const Observer& observe)
    : method_(method),
      observe_(observe),
      size_(static_cast<std::size_t>(states)),
      stride_((static_cast<std::size_t>(states) + 7) / 8 * 8),
      slots_(slotsFor(states)),
      states_(stride_ * static_cast<std::size_t>(slots_)),
      lines_(static_cast<std::size_t>(threads)) {}

bool SampleRing::begin(Member& me, const RunProblem& problem) {
  const Interval start = problem.schedule.intervals().front();
  statistics_.stopped = !observe_(0, start.segment, start.begin, problem.x0);
  if (!statistics_.stopped) return true;
  stopped_.store(true, std::memory_order_relaxed);
  me.stopTeam();
  return false;
}

void SampleRing::note(Member& me, long pause, const StepPause& here) {
  // Its own note of an earlier pause lies in the same place: that pause is shown first.
  while (pause - shown_.load(std::memory_order_relaxed) >= slots_ && !statistics_.stopped) showNext(me);
  notes_[pause % slots_] = here;
}

void SampleRing::makeRoom(Member& me, long pause) {
  me.wait(
      [&] {
        return pause - shown_.load(std::memory_order_acquire) < slots_ || stopped_.load(std::memory_order_relaxed);
      },
      0);
}

bool SampleRing::done(Member& me, long pause, bool finite) {
  Line& line = lines_[static_cast<std::size_t>(me.number())];
  line.finite[pause % slots_] = finite;
  me.injectDelay(pause);
  line.written.store(pause + 1, std::memory_order_release);
  me.ring();
  if (me.number() != 0) return !stopped_.load(std::memory_order_relaxed);
  while (!statistics_.stopped) {
    const long next = shown_.load(std::memory_order_relaxed);
    if (next > pause || !complete(next)) break;
    showNext(me);
  }
  return !statistics_.stopped;
}

bool SampleRing::complete(long pause) const {
  return std::all_of(lines_.begin(), lines_.end(), [&](const Line& line) {
    return line.written.load(std::memory_order_acquire) > pause;
  });
}

void SampleRing::showNext(Member& me) {
  const long pause = shown_.load(std::memory_order_relaxed);
  bool finite = true;
  for (std::size_t thread = 0; thread < lines_.size(); ++thread) {
    const Line& line = lines_[thread];
    me.wait([&] { return line.written.load(std::memory_order_acquire) > pause; }, static_cast<int>(thread));
    finite = finite && line.finite[pause % slots_];
  }
  const StepPause& here = notes_[pause % slots_];
  const std::span<const double> x(slot(pause), size_);
  if (!finite) failNotFinite(method_, here.reached, x);
  statistics_.steps = here.steps;
  if (here.sample >= 0) statistics_.stopped = !observe_(here.sample, here.segment, here.end, x);
  shown_.store(pause + 1, std::memory_order_release);
  me.ring();
  if (!statistics_.stopped) return;
  stopped_.store(true, std::memory_order_relaxed);
  me.stopTeam();
}

void SampleRing::finish(Member& me) {
  const long last = begun(me);
  while (!statistics_.stopped && shown_.load(std::memory_order_relaxed) < last) showNext(me);
}

}  // namespace vehicle
