#include "libvehicle/distribute/mpi_executor.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "libvehicle/distribute/mpi_job.h"
#include "libvehicle/study/execute/work_pool.h"

namespace vehicle {

namespace {

using Clock = std::chrono::steady_clock;

/// The designs of a workload that nobody has yet, cut from the front.
class Supply {
 public:
  Supply(const Workload& workload, std::size_t given) : workload_(workload), given_(given) {
    if (!workload.ranges.empty()) next_ = workload.ranges.front().first;
  }
  [[nodiscard]] bool empty() const { return range_ == workload_.ranges.size(); }
  Task cut(std::int64_t most) {
    const DesignSpan& whole = workload_.ranges[range_];
    const DesignSpan range{next_, std::min(next_ + most, whole.end)};
    const std::size_t numbers = static_cast<std::size_t>(range.size()) * given_;
    const Task task{range, std::span<const double>(workload_.given).subspan(place_, numbers)};
    place_ += numbers;
    next_ = range.end;
    if (next_ == whole.end && ++range_ < workload_.ranges.size()) next_ = workload_.ranges[range_].first;
    return task;
  }
  void drop() { range_ = workload_.ranges.size(); }

 private:
  const Workload& workload_;
  std::size_t given_;
  std::size_t range_ = 0;
  std::int64_t next_ = 0;
  std::size_t place_ = 0;  // in given
};

/// Designs that keep a rank busy until the next portion comes: one batch in the hands of every thread, one waiting.
std::int64_t enoughFor(const Evaluator& evaluator, int threads) { return 2 * evaluator.batchSize() * threads; }

/// One run as the leader sees it.
class Lead {
 public:
  Lead(MpiJob& job, const Evaluator& evaluator, const Workload& workload, const Sink& sink)
      : job_(job),
        evaluator_(evaluator),
        workload_(workload),
        sink_(sink),
        pool_(evaluator, job.threads.front()),
        supply_(workload, evaluator.given()) {}

  Ending run(const GoOn& go_on) {
    auto asked = Clock::now();
    try {
      while (busy()) {
        handOut();
        const bool received = receive([this](const Letter& letter) { take(letter); });
        const bool finished = takeOwn();
        const auto now = Clock::now();
        if (!stopped_ && go_on && now - asked >= kBetweenQuestions) {
          asked = now;
          if (!go_on()) stop();
        }
        if (!received && !finished) restALittle();
      }
    } catch (...) {
      // The other ranks come to rest before anyone may ask for another run; what they still send belongs to this one.
      stop();
      while (not_idle_ > 0) {
        if (!receive([](const Letter&) {})) restALittle();
      }
      throw;
    }
    if (!failure_.empty()) throw std::runtime_error(failure_);
    return taken_ == workload_.designs() ? Ending::kFinished : Ending::kStopped;
  }

 private:
  [[nodiscard]] bool busy() const {
    if (!supply_.empty() || pool_.outstanding() > 0 || not_idle_ > 0) return true;
    return !stopped_ && std::any_of(job_.lent.begin(), job_.lent.end(), [](std::int64_t each) { return each > 0; });
  }

  void handOut() {
    for (int follower = 1; follower < job_.ranks && !supply_.empty(); ++follower) {
      const auto place = static_cast<std::size_t>(follower);
      const std::int64_t enough = enoughFor(evaluator_, job_.threads[place]);
      if (2 * job_.lent[place] > enough) continue;
      const Task task = supply_.cut(enough - job_.lent[place]);
      job_.lent[place] += task.range.size();
      job_.mailbox.send(follower, Note::kWork, packPortion(task));
    }
    const std::int64_t enough = enoughFor(evaluator_, job_.threads.front());
    if (const std::int64_t has = pool_.outstanding(); !supply_.empty() && 2 * has <= enough) {
      const Task task = supply_.cut(enough - has);
      pool_.add({&task.range, 1}, task.given);
    }
  }

  /// @param take_batch  what becomes of results   @returns whether anything came
  template <class TakeBatch>
  bool receive(TakeBatch take_batch) {
    bool any = false;
    while (const auto letter = job_.mailbox.poll()) {
      any = true;
      if (letter->note == Note::kBatch) {
        take_batch(*letter);
      } else if (letter->note == Note::kFailed) {
        if (failure_.empty()) {
          failure_ = "rank " + std::to_string(letter->rank) + ": " + Unpacker(letter->bytes).getText();
        }
        stop();
      } else if (letter->note == Note::kIdle) {
        job_.lent[static_cast<std::size_t>(letter->rank)] = 0;
        --not_idle_;
      }
    }
    return any;
  }

  void take(const Letter& letter) {
    unpackBatch(letter.bytes, evaluator_.columns(), arrived_);
    job_.lent[static_cast<std::size_t>(letter.rank)] -= arrived_.range.size();
    sink_(arrived_);
    taken_ += arrived_.range.size();
  }

  bool takeOwn() {
    std::optional<Batch> batch = pool_.take(std::chrono::milliseconds(1));
    if (!batch) return false;
    sink_(*batch);
    taken_ += batch->range.size();
    pool_.recycle(std::move(*batch));
    return true;
  }

  void stop() {
    if (stopped_) return;
    stopped_ = true;
    supply_.drop();
    pool_.abandon();
    for (int follower = 1; follower < job_.ranks; ++follower) job_.mailbox.send(follower, Note::kAbandon);
    not_idle_ = job_.ranks - 1;
  }

  MpiJob& job_;
  const Evaluator& evaluator_;
  const Workload& workload_;
  const Sink& sink_;
  WorkPool pool_;
  Supply supply_;
  Batch arrived_;
  std::int64_t taken_ = 0;
  std::string failure_;
  bool stopped_ = false;
  int not_idle_ = 0;  // followers that were told to abandon and have not said kIdle
};

}  // namespace

bool isRankOfJob() {
  // OpenMPI's mpirun; PMIx and PMI, which srun and other launchers speak.
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

MpiExecutor::MpiExecutor(int threads) : job_(std::make_unique<MpiJob>(ThreadExecutor(threads).threads())) {}

MpiExecutor::~MpiExecutor() = default;

bool MpiExecutor::leads() const { return job_->leads(); }
int MpiExecutor::ranks() const { return job_->ranks; }
int MpiExecutor::rank() const { return job_->rank; }
int MpiExecutor::threads() const { return std::accumulate(job_->threads.begin(), job_->threads.end(), 0); }

Ending MpiExecutor::run(const Evaluator& evaluator, const Workload& workload, const Sink& sink, const GoOn& go_on) {
  if (!leads()) {
    job_->serve(evaluator);
    return Ending::kFinished;
  }
  checkWorkload(evaluator, workload);
  return Lead(*job_, evaluator, workload, sink).run(go_on);
}

}  // namespace vehicle
