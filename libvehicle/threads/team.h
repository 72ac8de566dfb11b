#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "libvehicle/threads/doorbell.h"
#include "libvehicle/threads/thread_usage.h"
#include "libvehicle/threads/trace.h"
#include "libvehicle/threads/waiting.h"

namespace vehicle {

/// Where the threads of a team may run.
enum class Pinning {
  kCores,  // thread i stays on entry i % size of allowedCores()
  kFree,   // the scheduler moves them inside the affinity mask
};

/// What a team asks of the scheduler; what it got stands in the report.
enum class Priority {
  kNormal,
  kRaised,  // a lower nice value
  kFifo,    // SCHED_FIFO: only with a core to spare, and then no thread waits without end; else as kRaised
};

/// How the threads of a team are placed, wait and are watched, however many they are.
struct TeamPolicy {
  Pinning pinning = Pinning::kCores;
  Priority priority = Priority::kNormal;
  WaitingKind waiting = WaitingKind::kAuto;
  std::function<void(int thread, long epoch)> injectDelay{};  // tests: called at every exchange by the thread itself
  Tracer* tracer = nullptr;                               // watched where set; outlives the run
};

/// Ends the work of a member whose team was stopped. Never reaches the caller of runTeam(): let it pass.
struct TeamStopped {};

/// One thread of a running team, as its work sees it. A line of its own: what a member counts while it waits must
/// not travel to its neighbours.
class alignas(64) Member {
 public:
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] int threads() const { return threads_; }

  /// Returns as soon as ready() is true; looks again by the team's policy.
  /// @param ready     cheap and without side effects, e.g. an acquire load and a comparison
  /// @param for_whom  the member that makes it true and rings, also for the trace
  /// @throws TeamStopped if the team was stopped and ready() is not true
  template <class Ready>
  void wait(Ready ready, int for_whom) {
    if (!ready()) waitLonger(ready, for_whom, [this, for_whom] { return sharesCore(for_whom) ? for_whom : kNobody; });
  }

  /// The same for a caller who knows better which other member needs this core.
  /// @param who_wants_core  asked between two looks: a member, then there is no pause and the core is given away until
  ///                        that member rings; or kNobody
  template <class Ready, class Wanted>
  void wait(Ready ready, int for_whom, Wanted who_wants_core) {
    if (!ready()) waitLonger(ready, for_whom, who_wants_core);
  }
  static constexpr int kNobody = -1;

  /// More threads than cores: the others that run in turn with this one are number() % stride() + k stride(). Free
  /// threads may stand anywhere, so then it is all of them (1). 0: everyone has a core.
  [[nodiscard]] int stride() const { return stride_; }
  [[nodiscard]] bool sharesCore(int other) const { return stride_ > 0 && (other - number_) % stride_ == 0; }

  /// Wakes those that block until this member has published something: call it after every release store that somebody
  /// waits for. Forgotten, they look once a sleep.
  void ring() { bells_[number_].ring(); }

  /// Lets a test delay this exchange.
  void injectDelay(long epoch) const {
    if (inject_delay_ != nullptr) [[unlikely]]
      (*inject_delay_)(number_, epoch);
  }

  /// Frame a step for the trace; both cost one branch without a tracer.
  void beginStep(long step) {
    if (trace_ != nullptr) [[unlikely]]
      trace_->beginStep(step);
  }
  void beginSteps(long first, long last) {
    if (trace_ != nullptr) [[unlikely]]
      trace_->beginSteps(first, last);
  }
  void endStep(long step) {
    if (trace_ != nullptr) [[unlikely]]
      trace_->endStep(step);
  }

  /// Every member that waits for something not ready throws TeamStopped; the caller itself returns from its work.
  void stopTeam() {
    stopped_->store(true, std::memory_order_release);
    for (int member = 0; member < threads_; ++member) bells_[member].ring();
  }
  [[nodiscard]] bool stopped() const { return stopped_->load(std::memory_order_acquire); }

 private:
  friend class TeamRun;
  /// What all members of a team share.
  struct Shared {
    int threads;
    int stride;
    const Waiting& waiting;
    Doorbell* bells;
    std::atomic<bool>& stopped;
    const TeamPolicy& policy;
  };
  Member(int number, const Shared& team)
      : number_(number),
        threads_(team.threads),
        stride_(team.stride),
        stays_(team.policy.pinning == Pinning::kCores),
        waiting_(team.waiting),
        bells_(team.bells),
        stopped_(&team.stopped),
        inject_delay_(team.policy.injectDelay ? &team.policy.injectDelay : nullptr),
        trace_(team.policy.tracer != nullptr ? &team.policy.tracer->thread(number) : nullptr) {}

  template <class Ready, class Wanted>
  void waitLonger(Ready& ready, int for_whom, Wanted who_wants_core) {
    if (trace_ != nullptr) [[unlikely]]
      trace_->beginWait(for_whom);
    Patience patience(waiting_, yields_);
    do {
      if (stopped()) throw TeamStopped{};
      const int wants = who_wants_core();
      if (patience.turn(wants != kNobody)) continue;
      // The core goes to who wants it, and comes back when that member rings: no other core has to be woken for it.
      const auto enough = [&] { return ready() || who_wants_core() != wants; };
      // On one core no ring is missed (doorbell.h), and a long limit spares the kernel a timer.
      const bool on_this_core = wants != kNobody && stays_;
      bells_[wants != kNobody ? wants : for_whom].await(enough, on_this_core ? kLongSleep : waiting_.sleep);
    } while (!ready());
    if (trace_ != nullptr) [[unlikely]]
      trace_->endWait();
  }

  static constexpr double kLongSleep = 5e-3;  // [s]

  int number_;
  int threads_;
  int stride_;
  bool stays_;  // on its core
  Waiting waiting_;
  YieldMemory yields_;
  Doorbell* bells_;  // (threads)
  std::atomic<bool>* stopped_;
  const std::function<void(int, long)>* inject_delay_;
  ThreadTrace* trace_;
};

/// What became of one thread of a team.
struct MemberReport {
  int core_before = -1;  // where the scheduler had put it
  int core_after = -1;   // where it stood when it was released
  bool pinned = false;
  std::string pinning_note{};   // why not, or empty
  std::string priority{};       // "normal" | "nice -10" | "SCHED_FIFO 10"
  std::string priority_note{};  // why less than asked, or empty
  ThreadUsage usage{};          // from release to return
};

struct TeamReport {
  std::vector<MemberReport> members;
  Waiting waiting;
  std::vector<int> cores;  // allowedCores() of the caller
};

/// Runs work(member) on that many new threads: created, placed and held until all of them stand, released together,
/// joined. The caller's own affinity and priority stay as they are; it waits meanwhile.
///
/// An exception that leaves the work of a member stops the team; the first one is thrown again here, after all
/// threads have ended.
/// @throws std::invalid_argument for threads < 1, kSpin with more threads than cores, kSpin or kYield with SCHED_FIFO
/// @throws std::runtime_error if the system grants no more threads
TeamReport runTeam(int threads, const TeamPolicy& policy, const std::function<void(Member&)>& work);

}  // namespace vehicle
