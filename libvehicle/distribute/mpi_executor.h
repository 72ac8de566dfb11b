#pragma once

#include <memory>

#include "libvehicle/study/execute/executor.h"

namespace vehicle {

/// Whether a launcher (mpirun, srun) has started this process as a rank of a job.
[[nodiscard]] bool isRankOfJob();

/// The ranks of an MPI job, `mpirun -n 4 vehicle study ...`. Rank 0 leads: it hands out designs in small portions,
/// evaluates too, and alone calls the sink. Every rank must be given the same study.
///
/// On the other ranks run() serves until the leader's executor is gone, whatever number of runs that makes; so all runs
/// of one executor are of one evaluator.
/// A rank that is lost (killed, machine down) ends the job by MPI's own rule; what the sink was given is kept.
class MpiExecutor : public Executor {
 public:
  /// Starts MPI. One executor a process: MPI cannot be started twice.
  /// @param threads  of each rank; 0: one a processing unit of its affinity mask (mpirun binds ranks to cores)
  /// @throws std::invalid_argument for threads < 0; std::runtime_error if MPI was started before
  explicit MpiExecutor(int threads = 1);
  /// The leader lets the other ranks go; then MPI ends.
  ~MpiExecutor() override;
  MpiExecutor(const MpiExecutor&) = delete;
  MpiExecutor& operator=(const MpiExecutor&) = delete;

  /// @throws std::runtime_error  what ended the work of another rank, with its number
  Ending run(const Evaluator& evaluator, const Workload& workload, const Sink& sink, const GoOn& go_on = {}) override;
  [[nodiscard]] bool leads() const override;
  [[nodiscard]] int threads() const override;  // of all ranks
  [[nodiscard]] int ranks() const;
  [[nodiscard]] int rank() const;

 private:
  std::unique_ptr<class MpiJob> job_;
};

}  // namespace vehicle
