#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "libvehicle/distribute/mailbox.h"
#include "libvehicle/study/evaluate/evaluation.h"

namespace vehicle {

/// An MPI job as one of its ranks sees it: started when it is made, left when it goes. Only the thread that makes it
/// calls MPI. Private to this room.
class MpiJob {
 public:
  /// @throws std::runtime_error if MPI was started before
  explicit MpiJob(int own_threads);
  /// The leader lets the other ranks go; one that has not said good-bye tells the leader not to wait for it.
  ~MpiJob();
  MpiJob(const MpiJob&) = delete;
  MpiJob& operator=(const MpiJob&) = delete;

  [[nodiscard]] bool leads() const { return rank == 0; }

  /// Ranks other than the leader: evaluates what comes until the end.
  void serve(const Evaluator& evaluator);

  int rank = 0;
  int ranks = 1;
  std::vector<int> threads;        // (ranks)
  std::vector<std::int64_t> lent;  // (ranks) leader: designs that a follower has and has not given back
  Mailbox mailbox;

 private:
  void release();
  void refuse();
  void sendFailure(const std::string& text);
  void sendShutdown();

  bool failure_sent_ = false;
  bool said_bye_ = false;
};

/// Waits a little where there was nothing to do: ranks may share cores.
void restALittle();

}  // namespace vehicle
