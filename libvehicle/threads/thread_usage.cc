#include "libvehicle/threads/thread_usage.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <sstream>

namespace vehicle {

namespace {

double monotonicSeconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string fileOfThisThread(const char* name) {
  return "/proc/self/task/" + std::to_string(syscall(SYS_gettid)) + "/" + name;
}

// The clock counts to the nanosecond; schedstat's own run time stands still between two ticks of the scheduler, which
// in a run of milliseconds is all of it.
void readRunTime(ThreadUsage& usage) {
  timespec used{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used) == 0) {
    usage.running = static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  } else {
    usage.missing.emplace_back("run time: CLOCK_THREAD_CPUTIME_ID is not available");
  }
}

// schedstat: run time, then run-queue time, both in ns.
void readRunQueueTime(ThreadUsage& usage) {
  std::ifstream file(fileOfThisThread("schedstat"));
  double ran = 0.0;
  double waited = 0.0;
  if (file >> ran >> waited) {
    usage.preempted = 1e-9 * waited;
  } else {
    usage.missing.emplace_back("preempted time: /proc/self/task/<tid>/schedstat is not available");
  }
}

// Field 42, delayacct_blkio_ticks. The second field may hold spaces, so fields are counted from its bracket.
void readBlockedTime(ThreadUsage& usage) {
  std::ifstream file(fileOfThisThread("stat"));
  std::string line;
  std::getline(file, line);
  const auto bracket = line.rfind(')');
  double ticks = -1.0;
  if (bracket != std::string::npos) {
    std::istringstream fields(line.substr(bracket + 1));
    std::string skipped;
    for (int field = 3; field < 42; ++field) fields >> skipped;
    if (!(fields >> ticks)) ticks = -1.0;
  }
  std::ifstream accounting("/proc/sys/kernel/task_delayacct");
  int accounted = 1;
  if (accounting >> accounted && accounted == 0) {
    usage.missing.emplace_back("blocked time: the kernel does not count it (kernel.task_delayacct = 0)");
  } else if (ticks < 0.0) {
    usage.missing.emplace_back("blocked time: /proc/self/task/<tid>/stat is not available");
  } else {
    usage.blocked_io = ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
  }
}

void readMigrations(ThreadUsage& usage) {
  std::ifstream file(fileOfThisThread("sched"));
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("se.nr_migrations")) continue;
    std::istringstream value(line.substr(line.find(':') + 1));
    if (value >> usage.migrations) return;
  }
  usage.migrations = -1;
  usage.missing.emplace_back("migrations: /proc/self/task/<tid>/sched is not available");
}

void readSwitches(ThreadUsage& usage) {
  rusage counted{};
  if (getrusage(RUSAGE_THREAD, &counted) != 0) {
    usage.missing.emplace_back("context switches: getrusage(RUSAGE_THREAD) is not available");
    return;
  }
  usage.voluntary = counted.ru_nvcsw;
  usage.involuntary = counted.ru_nivcsw;
}

template <class Number>
Number difference(Number begin, Number end) {
  return begin < Number{0} || end < Number{0} ? Number{-1} : end - begin;
}

}  // namespace

ThreadUsage usageOfThisThread() {
  ThreadUsage usage;
  readSwitches(usage);
  readRunQueueTime(usage);
  readBlockedTime(usage);
  readMigrations(usage);
  readRunTime(usage);
  usage.wall = monotonicSeconds();
  return usage;
}

ThreadUsage between(const ThreadUsage& begin, const ThreadUsage& end) {
  return {.wall = difference(begin.wall, end.wall),
          .running = difference(begin.running, end.running),
          .preempted = difference(begin.preempted, end.preempted),
          .blocked_io = difference(begin.blocked_io, end.blocked_io),
          .voluntary = difference(begin.voluntary, end.voluntary),
          .involuntary = difference(begin.involuntary, end.involuntary),
          .migrations = difference(begin.migrations, end.migrations),
          .missing = end.missing};
}

}  // namespace vehicle
