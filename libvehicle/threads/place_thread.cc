#include "libvehicle/threads/place_thread.h"

#include <sched.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace vehicle {

namespace {

constexpr int kNice = -10;  // above every ordinary program, below the kernel's own threads
constexpr int kFifo = 10;   // above the other real-time programs that ask for nothing special

// Moves the thread there; the message if the system refuses.
std::string pinTo(int core) {
  std::array<cpu_set_t, 8> mask{};
  CPU_SET_S(static_cast<std::size_t>(core), sizeof mask, mask.data());
  if (sched_setaffinity(0, sizeof mask, mask.data()) == 0) return "";
  return "core " + std::to_string(core) + " was refused (" + std::strerror(errno) + ")";
}

// The lowest nice value that RLIMIT_NICE leaves to a user without CAP_SYS_NICE.
int lowestPermittedNice() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NICE, &limit) != 0) return 0;
  return 20 - static_cast<int>(std::min<rlim_t>(limit.rlim_cur, 40));
}

GrantedPriority raiseNice() {
  // In Linux PRIO_PROCESS with 0 is the calling thread alone.
  if (setpriority(PRIO_PROCESS, 0, kNice) == 0) return {"nice " + std::to_string(kNice), ""};
  const std::string refusal = "nice " + std::to_string(kNice) + " was refused (" + std::strerror(errno) +
                              "); it needs CAP_SYS_NICE or a nice limit (ulimit -e)";
  const int permitted = lowestPermittedNice();
  if (permitted < 0 && setpriority(PRIO_PROCESS, 0, permitted) == 0) {
    return {"nice " + std::to_string(permitted), refusal};
  }
  return {"normal", refusal};
}

}  // namespace

GrantedPriority raiseThisThread(Priority priority, bool spare) {
  if (priority == Priority::kNormal) return {"normal", ""};
  if (priority == Priority::kRaised) return raiseNice();
  std::string refusal = "SCHED_FIFO needs a core to spare: take fewer threads than cores";
  if (spare) {
    const sched_param wanted{.sched_priority = kFifo};
    if (sched_setscheduler(0, SCHED_FIFO, &wanted) == 0) return {"SCHED_FIFO " + std::to_string(kFifo), ""};
    refusal = std::string("SCHED_FIFO was refused (") + std::strerror(errno) +
              "); it needs CAP_SYS_NICE or a real-time limit (ulimit -r)";
  }
  GrantedPriority raised = raiseNice();
  raised.note = raised.note.empty() ? refusal : refusal + "; " + raised.note;
  return raised;
}

void placeThisThread(const TeamPolicy& policy, int number, TeamReport& team) {
  const std::vector<int>& cores = team.cores;
  MemberReport& report = team.members[static_cast<std::size_t>(number)];
  report.core_before = sched_getcpu();
  if (policy.pinning == Pinning::kFree) {
    report.pinning_note = "not asked for";
  } else {
    report.pinning_note = pinTo(cores[static_cast<std::size_t>(number) % cores.size()]);
    report.pinned = report.pinning_note.empty();
  }
  report.core_after = sched_getcpu();
  GrantedPriority granted = raiseThisThread(policy.priority, team.members.size() < cores.size());
  report.priority = std::move(granted.got);
  report.priority_note = std::move(granted.note);
}

}  // namespace vehicle
