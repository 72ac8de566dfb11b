#include "libvehicle/distribute/mailbox.h"

#include <limits>
#include <stdexcept>

namespace vehicle {

void Mailbox::send(int rank, Note note, std::vector<std::byte> bytes) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::runtime_error("a message of more than 2 GB between ranks: evaluate fewer designs at a time");
  }
  Sending& sending = sendings_.emplace_back();
  sending.bytes = std::move(bytes);
  MPI_Isend(sending.bytes.data(), static_cast<int>(sending.bytes.size()), MPI_BYTE, rank, static_cast<int>(note),
            MPI_COMM_WORLD, &sending.request);
}

std::optional<Letter> Mailbox::poll() {
  while (!sendings_.empty()) {
    int done = 0;
    MPI_Test(&sendings_.front().request, &done, MPI_STATUS_IGNORE);
    if (!done) break;
    sendings_.pop_front();
  }
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (!there) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Letter letter{status.MPI_SOURCE, static_cast<Note>(status.MPI_TAG),
                std::vector<std::byte>(static_cast<std::size_t>(size))};
  MPI_Recv(letter.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return letter;
}

void Mailbox::finish() {
  for (Sending& each : sendings_) MPI_Wait(&each.request, MPI_STATUS_IGNORE);
  sendings_.clear();
}

}  // namespace vehicle
