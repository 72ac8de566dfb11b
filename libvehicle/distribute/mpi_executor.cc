#include "libvehicle/distribute/mpi_executor.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "libvehicle/distribute/mailbox.h"
#include "libvehicle/study/execute/work_pool.h"

namespace vehicle {

namespace {

using std::chrono::milliseconds;

/// Waits a little where there was nothing to do: ranks may share cores.
void rest() { std::this_thread::sleep_for(std::chrono::microseconds(100)); }

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

}  // namespace

bool isRankOfJob() {
  // OpenMPI's mpirun; PMIx and PMI, which srun and other launchers speak.
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

/// What both sides keep of the job.
class MpiExecutor::Job {
 public:
  explicit Job(int own_threads) {
    int started = 0;
    MPI_Initialized(&started);
    if (started) throw std::runtime_error("MPI was started before in this process: make one MpiExecutor");
    int granted = 0;
    // Only the thread that makes this object calls MPI; the threads of the pool never do.
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &granted);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    threads.resize(static_cast<std::size_t>(ranks));
    MPI_Allgather(&own_threads, 1, MPI_INT, threads.data(), 1, MPI_INT, MPI_COMM_WORLD);
    lent.resize(static_cast<std::size_t>(ranks));
  }

  ~Job() {
    if (rank == 0) {
      letGo();
    } else if (!said_bye_) {
      refuse();
    }
    mailbox.finish();
    MPI_Finalize();
  }

  void letGo() {
    for (int follower = 1; follower < ranks; ++follower) mailbox.send(follower, Note::kEnd);
    for (int left = ranks - 1; left > 0;) {
      const auto letter = mailbox.poll();
      if (!letter) {
        rest();
      } else if (letter->note == Note::kBye) {
        --left;
      }
    }
  }

  /// A rank that could not begin, or cannot go on: the leader must not wait for it.
  void refuse() {
    tellFailure("it could not evaluate the study; its own message tells why");
    while (!said_bye_) {
      const auto letter = mailbox.poll();
      if (!letter) {
        rest();
      } else if (letter->note == Note::kAbandon) {
        mailbox.send(0, Note::kIdle);
      } else if (letter->note == Note::kEnd) {
        sayBye();
      }
    }
  }

  /// Ranks other than the leader: evaluates what comes until the end.
  void serve(const Evaluator& evaluator) {
    WorkPool pool(evaluator, threads[static_cast<std::size_t>(rank)]);
    std::deque<Portion> portions;  // their numbers stay until their designs are through
    bool idle_wanted = false;
    bool ending = false;
    while (true) {
      bool busy = false;
      while (const auto letter = mailbox.poll()) {
        busy = true;
        if (letter->note == Note::kWork) {
          const Portion& portion = portions.emplace_back(unpackPortion(letter->bytes, evaluator.given()));
          pool.add({&portion.range, 1}, portion.given);
        } else {
          pool.abandon();
          (letter->note == Note::kEnd ? ending : idle_wanted) = true;
        }
      }
      try {
        if (auto batch = pool.take(milliseconds(1))) {
          busy = true;
          mailbox.send(0, Note::kBatch, packBatch(*batch));
          pool.recycle(std::move(*batch));
        }
      } catch (const std::exception& error) {
        tellFailure(error.what());
      }
      if (pool.outstanding() == 0) {
        portions.clear();
        if (std::exchange(idle_wanted, false)) mailbox.send(0, Note::kIdle);
        if (ending) break;
      }
      if (!busy) rest();
    }
    sayBye();
  }

  int rank = 0;
  int ranks = 1;
  std::vector<int> threads;        // (ranks)
  std::vector<std::int64_t> lent;  // (ranks) leader: designs that a follower has and has not given back
  Mailbox mailbox;

 private:
  void tellFailure(const std::string& text) {
    if (std::exchange(told_failure_, true)) return;
    Packer message;
    message.putText(text);
    mailbox.send(0, Note::kFailed, message.take());
  }
  void sayBye() {
    said_bye_ = true;
    mailbox.send(0, Note::kBye);
  }

  bool told_failure_ = false;
  bool said_bye_ = false;
};

namespace {

/// Designs that keep a rank busy until the next portion comes: one batch in the hands of every thread, one waiting.
std::int64_t enoughFor(const Evaluator& evaluator, int threads) { return 2 * evaluator.batchSize() * threads; }

}  // namespace

MpiExecutor::MpiExecutor(int threads) : threads_(ThreadExecutor(threads).threads()) {
  job_ = std::make_unique<Job>(threads_);
}

MpiExecutor::~MpiExecutor() = default;

bool MpiExecutor::leads() const { return job_->rank == 0; }
int MpiExecutor::ranks() const { return job_->ranks; }
int MpiExecutor::rank() const { return job_->rank; }

int MpiExecutor::threads() const {
  int sum = 0;
  for (const int each : job_->threads) sum += each;
  return sum;
}

Ending MpiExecutor::run(const Evaluator& evaluator, const Workload& workload, const Sink& sink, const GoOn& go_on) {
  if (!leads()) {
    job_->serve(evaluator);
    return Ending::kFinished;
  }
  checkWorkload(evaluator, workload);
  Job& job = *job_;
  WorkPool pool(evaluator, threads_);
  Supply supply(workload, evaluator.given());
  Batch arrived;
  std::int64_t taken = 0;
  std::string failure;
  bool stopped = false;
  int not_idle = 0;  // followers that were told to abandon and have not said kIdle
  auto asked = std::chrono::steady_clock::now();

  const auto stop = [&] {
    if (stopped) return;
    stopped = true;
    supply.drop();
    pool.abandon();
    for (int follower = 1; follower < job.ranks; ++follower) job.mailbox.send(follower, Note::kAbandon);
    not_idle = job.ranks - 1;
  };
  // @param keep  false: what comes is thrown away
  const auto receive = [&](bool keep) {
    bool any = false;
    while (const auto letter = job.mailbox.poll()) {
      any = true;
      std::int64_t& lent = job.lent[static_cast<std::size_t>(letter->rank)];
      if (letter->note == Note::kBatch) {
        if (!keep) continue;
        unpackBatch(letter->bytes, evaluator.columns(), arrived);
        lent -= arrived.range.size();
        sink(arrived);
        taken += arrived.range.size();
      } else if (letter->note == Note::kFailed) {
        if (failure.empty()) {
          failure = "rank " + std::to_string(letter->rank) + ": " + Unpacker(letter->bytes).getText();
        }
        stop();
      } else if (letter->note == Note::kIdle) {
        lent = 0;
        --not_idle;
      }
    }
    return any;
  };
  const auto busy = [&] {
    if (!supply.empty() || pool.outstanding() > 0 || not_idle > 0) return true;
    return !stopped && std::any_of(job.lent.begin(), job.lent.end(), [](std::int64_t each) { return each > 0; });
  };

  try {
    while (busy()) {
      for (int follower = 1; follower < job.ranks && !supply.empty(); ++follower) {
        const auto place = static_cast<std::size_t>(follower);
        const std::int64_t enough = enoughFor(evaluator, job.threads[place]);
        if (2 * job.lent[place] > enough) continue;
        const Task task = supply.cut(enough - job.lent[place]);
        job.lent[place] += task.range.size();
        job.mailbox.send(follower, Note::kWork, packPortion(task));
      }
      const std::int64_t enough = enoughFor(evaluator, threads_);
      if (const std::int64_t has = pool.outstanding(); !supply.empty() && 2 * has <= enough) {
        const Task task = supply.cut(enough - has);
        pool.add({&task.range, 1}, task.given);
      }
      bool any = receive(true);
      if (auto batch = pool.take(milliseconds(1))) {
        any = true;
        sink(*batch);
        taken += batch->range.size();
        pool.recycle(std::move(*batch));
      }
      const auto now = std::chrono::steady_clock::now();
      if (!stopped && go_on && now - asked >= kBetweenQuestions) {
        asked = now;
        if (!go_on()) stop();
      }
      if (!any) rest();
    }
  } catch (...) {
    // The other ranks come to rest before anyone may ask for another run; what they still send belongs to this one.
    stop();
    while (not_idle > 0) {
      if (!receive(false)) rest();
    }
    throw;
  }
  if (!failure.empty()) throw std::runtime_error(failure);
  return taken == workload.designs() ? Ending::kFinished : Ending::kStopped;
}

}  // namespace vehicle
