#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "libvehicle/study/evaluate/evaluation.h"

namespace vehicle {

/// Designs to be evaluated.
struct Workload {
  std::vector<DesignSpan> ranges;  // ascending, disjoint, none empty
  std::vector<double> given;       // (designs of all ranges x evaluator.given()), row-major

  [[nodiscard]] std::int64_t designs() const;
};

/// Takes results as they finish, on the thread that called run(); batches come in any order. What it throws ends the
/// run.
using Sink = std::function<void(Batch& batch)>;

/// Asked on the calling thread at least ten times a second; returning false ends the run with what is finished.
using GoOn = std::function<bool()>;

enum class Ending {
  kFinished,  // every design went to the sink
  kStopped,   // go_on said no: what was begun was finished and went to the sink
};

/// Who evaluates a study's designs: the threads of this process, or the ranks of a job.
class Executor {
 public:
  virtual ~Executor() = default;

  /// Evaluates every design of the workload once and hands each to the sink once.
  ///
  /// An exception of a worker ends the run: no new batch is begun, those under way go to the sink, and the exception
  /// is thrown again here.
  /// @throws std::invalid_argument  if workload and evaluator do not fit
  virtual Ending run(const Evaluator& evaluator, const Workload& workload, const Sink& sink,
                     const GoOn& go_on = {}) = 0;

  /// Whether this process owns the study: writes its database and speaks to the user. The other ranks of a job do
  /// not; their run() ignores workload and sink, and serves until the leader's executor is gone.
  [[nodiscard]] virtual bool leads() const { return true; }

  /// Threads that evaluate, in all processes.
  [[nodiscard]] virtual int threads() const = 0;
};

/// The threads of this process. Each begins with an equal share of the designs, and who is through takes half of what
/// the one with most has left.
class ThreadExecutor : public Executor {
 public:
  /// @param threads  0: one a processing unit of the affinity mask (taskset, a container's cpuset)
  /// @throws std::invalid_argument for threads < 0
  explicit ThreadExecutor(int threads = 0);

  Ending run(const Evaluator& evaluator, const Workload& workload, const Sink& sink, const GoOn& go_on = {}) override;
  [[nodiscard]] int threads() const override { return threads_; }

 private:
  int threads_;
};

/// @throws std::invalid_argument  unless ranges are ascending, disjoint and not empty, and `given` has their size
void checkWorkload(const Evaluator& evaluator, const Workload& workload);

/// How long a thread waits for a batch before it asks whether to go on.
inline constexpr std::chrono::milliseconds kBetweenQuestions{50};

}  // namespace vehicle
