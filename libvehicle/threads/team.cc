#include "libvehicle/threads/team.h"

#include <chrono>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "libvehicle/threads/place_thread.h"
#include "libvehicle/threads/placement.h"
#include "libvehicle/threads/refused_thread.h"

namespace vehicle {

namespace {

// All threads stand at the gate before one passes it, so none steals a core from a thread that is being created.
constexpr Waiting kAtTheGate{.pauses = 0, .yields = 1000, .sleep = 50e-6};

Waiting waitingOf(const TeamPolicy& policy, int threads, int cores) {
  const Waiting waiting = waitingFor(policy.waiting, threads, cores);
  if (policy.priority != Priority::kFifo || givesWay(waiting)) return waiting;
  throw std::invalid_argument(std::string("waiting \"") + nameOf(policy.waiting) +
                              "\" with SCHED_FIFO could lock the machine; take auto | sleep");
}

}  // namespace

class TeamRun {
 public:
  TeamRun(int threads, const TeamPolicy& policy, const std::function<void(Member&)>& work)
      : threads_(threads),
        policy_(policy),
        work_(work),
        report_{.members = {}, .waiting = {}, .cores = allowedCores()},
        bells_(static_cast<std::size_t>(threads)) {
    const int cores = static_cast<int>(report_.cores.size());
    report_.waiting = waitingOf(policy, threads, cores);
    report_.members.resize(static_cast<std::size_t>(threads));
    if (policy.tracer != nullptr) policy.tracer->prepare(threads);
  }

  TeamReport run() {
    std::vector<std::thread> threads;
    threads.reserve(report_.members.size());
    try {
      for (int i = 0; i < threads_; ++i) threads.emplace_back([this, i] { live(i); });
    } catch (const std::system_error& refused) {
      fail(
          std::make_exception_ptr(std::runtime_error("team: " + refusedThread(threads.size() + 1, threads_, refused))));
    } catch (...) {  // those that stand already must be let go
      fail(std::current_exception());
    }
    for (std::thread& thread : threads) thread.join();
    if (failure_) std::rethrow_exception(failure_);
    return std::move(report_);
  }

 private:
  void live(int number) {
    MemberReport& report = report_.members[static_cast<std::size_t>(number)];
    try {
      Member member(number, {threads_, stride(), report_.waiting, bells_.data(), stopped_, policy_});
      placeThisThread(policy_, number, report_);
      arrive();
      const ThreadUsage before = usageOfThisThread();
      leaveUsage(before, report, [&] { work_(member); });
    } catch (const TeamStopped&) {
    } catch (...) {
      fail(std::current_exception());
    }
  }

  // A member that is stopped leaves its usage as well.
  template <class Work>
  static void leaveUsage(const ThreadUsage& before, MemberReport& report, Work work) {
    try {
      work();
    } catch (const TeamStopped&) {
    }
    report.usage = between(before, usageOfThisThread());
  }

  int stride() const {
    const int cores = static_cast<int>(report_.cores.size());
    if (threads_ <= cores) return 0;
    return policy_.pinning == Pinning::kCores ? cores : 1;
  }

  void arrive() {
    standing_.fetch_add(1, std::memory_order_acq_rel);
    YieldMemory yields;
    Patience patience(kAtTheGate, yields);
    while (standing_.load(std::memory_order_acquire) < threads_) {
      if (stopped_.load(std::memory_order_acquire)) throw TeamStopped{};
      if (!patience.turn()) std::this_thread::sleep_for(std::chrono::duration<double>(kAtTheGate.sleep));
    }
  }

  void fail(std::exception_ptr failure) {
    {
      const std::lock_guard lock(failure_mutex_);
      if (!failure_) failure_ = std::move(failure);
    }
    stopped_.store(true, std::memory_order_release);
    for (Doorbell& bell : bells_) bell.ring();
  }

  const int threads_;
  const TeamPolicy& policy_;
  const std::function<void(Member&)>& work_;
  TeamReport report_;
  std::vector<Doorbell> bells_;  // (threads) of each member
  // Read by every thread that waits, written once: on a line that nothing else makes travel.
  alignas(64) std::atomic<bool> stopped_{false};
  alignas(64) std::atomic<int> standing_{0};
  std::mutex failure_mutex_;
  std::exception_ptr failure_;
};

TeamReport runTeam(int threads, const TeamPolicy& policy, const std::function<void(Member&)>& work) {
  if (threads < 1) throw std::invalid_argument("team: threads = " + std::to_string(threads) + ", must be >= 1");
  return TeamRun(threads, policy, work).run();
}

}  // namespace vehicle
