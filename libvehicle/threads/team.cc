#include "libvehicle/threads/team.h"

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

Waiting waitingOf(const TeamChoice& choice, int cores) {
  const Waiting named = waitingNamed(choice.waiting, choice.threads, cores);
  if (choice.priority != Priority::kFifo || givesWay(named)) return named;
  throw std::invalid_argument("waiting \"" + choice.waiting +
                              "\" with SCHED_FIFO could lock the machine; take auto | sleep");
}

}  // namespace

class TeamRun {
 public:
  TeamRun(const TeamChoice& choice, const std::function<void(Member&)>& work)
      : choice_(choice), work_(work), report_{.members = {}, .waiting = {}, .cores = allowedCores()} {
    const int cores = static_cast<int>(report_.cores.size());
    report_.waiting = waitingOf(choice, cores);
    report_.members.resize(static_cast<std::size_t>(choice.threads));
    if (choice.tracer != nullptr) choice.tracer->prepare(choice.threads);
  }

  TeamReport run() {
    std::vector<std::thread> threads;
    threads.reserve(report_.members.size());
    try {
      for (int i = 0; i < choice_.threads; ++i) threads.emplace_back([this, i] { live(i); });
    } catch (const std::system_error& refused) {
      fail(std::make_exception_ptr(
          std::runtime_error("team: " + refusedThread(threads.size() + 1, choice_.threads, refused))));
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
      Member member(number, stride(), report_.waiting, stopped_, choice_);
      placeThisThread(choice_, number, report_.cores, report);
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
    if (choice_.threads <= cores) return 0;
    return choice_.pinning == Pinning::kCores ? cores : 1;
  }

  void arrive() {
    standing_.fetch_add(1, std::memory_order_acq_rel);
    Patience patience(kAtTheGate);
    while (standing_.load(std::memory_order_acquire) < choice_.threads) {
      if (stopped_.load(std::memory_order_acquire)) throw TeamStopped{};
      patience.turn();
    }
  }

  void fail(std::exception_ptr failure) {
    {
      const std::lock_guard lock(failure_mutex_);
      if (!failure_) failure_ = std::move(failure);
    }
    stopped_.store(true, std::memory_order_release);
  }

  const TeamChoice& choice_;
  const std::function<void(Member&)>& work_;
  TeamReport report_;
  // Read by every thread that waits, written once: on a line that nothing else makes travel.
  alignas(64) std::atomic<bool> stopped_{false};
  alignas(64) std::atomic<int> standing_{0};
  std::mutex failure_mutex_;
  std::exception_ptr failure_;
};

TeamReport runTeam(const TeamChoice& choice, const std::function<void(Member&)>& work) {
  if (choice.threads < 1) {
    throw std::invalid_argument("team: threads = " + std::to_string(choice.threads) + ", must be >= 1");
  }
  return TeamRun(choice, work).run();
}

}  // namespace vehicle
