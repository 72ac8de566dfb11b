#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include <mpi.h>

#include "libvehicle/distribute/message.h"

namespace vehicle {

struct Letter {
  int rank = 0;  // of the sender
  Note note = Note::kIdle;
  std::vector<std::byte> bytes;
};

/// Messages of this rank. Sending never waits for the receiver: two ranks that send each other large messages at the
/// same time would otherwise wait for ever.
class Mailbox {
 public:
  /// @param bytes  at most 2 GB, MPI's own limit for one message
  void send(int rank, Note note, std::vector<std::byte> bytes = {});
  /// The next message, in the order of each sender; nothing if there is none now.
  [[nodiscard]] std::optional<Letter> poll();
  /// Waits until all that was sent has left.
  void finish();

 private:
  struct Sending {
    std::vector<std::byte> bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  std::deque<Sending> sendings_;  // a deque: elements stay where they are while MPI reads them
};

}  // namespace vehicle
