#include "libvehicle/study/execute/executor.h"

#include <limits>
#include <stdexcept>
#include <string>

#include "libvehicle/study/execute/work_pool.h"
#include "libvehicle/threads/placement.h"

namespace vehicle {

std::int64_t Workload::designs() const {
  std::int64_t sum = 0;
  for (const DesignSpan& range : ranges) sum += range.size();
  return sum;
}

void checkWorkload(const Evaluator& evaluator, const Workload& workload) {
  std::int64_t end = std::numeric_limits<std::int64_t>::min();
  for (const DesignSpan& range : workload.ranges) {
    if (range.first < end || range.end <= range.first) {
      throw std::invalid_argument("workload: the range " + std::to_string(range.first) + " .. " +
                                  std::to_string(range.end) + " must not be empty and must follow the one before");
    }
    end = range.end;
  }
  const std::size_t wanted = static_cast<std::size_t>(workload.designs()) * evaluator.given();
  if (workload.given.size() != wanted) {
    throw std::invalid_argument("workload: " + std::to_string(workload.given.size()) +
                                " numbers are given, the evaluator needs " + std::to_string(wanted));
  }
}

ThreadExecutor::ThreadExecutor(int threads) : threads_(threads) {
  if (threads < 0) {
    throw std::invalid_argument("threads = " + std::to_string(threads) + ", must be >= 1, or 0 for all cores");
  }
  if (threads == 0) threads_ = static_cast<int>(allowedCores().size());
}

Ending ThreadExecutor::run(const Evaluator& evaluator, const Workload& workload, const Sink& sink, const GoOn& go_on) {
  checkWorkload(evaluator, workload);
  WorkPool pool(evaluator, threads_);
  pool.add(workload.ranges, workload.given);
  bool stopped = false;
  std::int64_t taken = 0;
  auto asked = std::chrono::steady_clock::now();
  while (pool.outstanding() > 0) {
    if (std::optional<Batch> batch = pool.take(kBetweenQuestions)) {
      sink(*batch);
      taken += batch->range.size();
      pool.recycle(std::move(*batch));
    }
    const auto now = std::chrono::steady_clock::now();
    if (stopped || !go_on || now - asked < kBetweenQuestions) continue;
    asked = now;
    stopped = !go_on();
    if (stopped) pool.abandon();
  }
  pool.take(std::chrono::milliseconds(0));  // throws what a worker has thrown
  return taken == workload.designs() ? Ending::kFinished : Ending::kStopped;
}

}  // namespace vehicle
