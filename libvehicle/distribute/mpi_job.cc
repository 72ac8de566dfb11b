#include "libvehicle/distribute/mpi_job.h"

#include <chrono>
#include <deque>
#include <stdexcept>
#include <thread>
#include <utility>

#include "libvehicle/study/execute/work_pool.h"

namespace vehicle {

void restALittle() { std::this_thread::sleep_for(std::chrono::microseconds(100)); }

MpiJob::MpiJob(int own_threads) {
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

MpiJob::~MpiJob() {
  if (rank == 0) {
    release();
  } else if (!said_bye_) {
    refuse();
  }
  mailbox.finish();
  MPI_Finalize();
}

void MpiJob::release() {
  for (int follower = 1; follower < ranks; ++follower) mailbox.send(follower, Note::kEnd);
  for (int left = ranks - 1; left > 0;) {
    const auto letter = mailbox.poll();
    if (!letter) {
      restALittle();
    } else if (letter->note == Note::kBye) {
      --left;
    }
  }
}

// A rank that could not begin, or cannot go on: the leader must not wait for it.
void MpiJob::refuse() {
  sendFailure("it could not evaluate the study; its own message tells why");
  while (!said_bye_) {
    const auto letter = mailbox.poll();
    if (!letter) {
      restALittle();
    } else if (letter->note == Note::kAbandon) {
      mailbox.send(0, Note::kIdle);
    } else if (letter->note == Note::kEnd) {
      sendShutdown();
    }
  }
}

void MpiJob::serve(const Evaluator& evaluator) {
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
      if (auto batch = pool.take(std::chrono::milliseconds(1))) {
        busy = true;
        mailbox.send(0, Note::kBatch, packBatch(*batch));
        pool.recycle(std::move(*batch));
      }
    } catch (const std::exception& error) {
      sendFailure(error.what());
    }
    if (pool.outstanding() == 0) {
      portions.clear();
      if (std::exchange(idle_wanted, false)) mailbox.send(0, Note::kIdle);
      if (ending) break;
    }
    if (!busy) restALittle();
  }
  sendShutdown();
}

void MpiJob::sendFailure(const std::string& text) {
  if (std::exchange(failure_sent_, true)) return;
  Packer message;
  message.putText(text);
  mailbox.send(0, Note::kFailed, message.take());
}

void MpiJob::sendShutdown() {
  said_bye_ = true;
  mailbox.send(0, Note::kBye);
}

}  // namespace vehicle
