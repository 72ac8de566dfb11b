#include "libvehicle/storage/read_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>

namespace vehicle {
namespace {

// A device without end must not take the memory of the machine.
constexpr std::size_t kMostBytes = std::size_t{1} << 28;

}  // namespace

Outcome<std::string> readFile(const std::filesystem::path& path) {
  Outcome<std::string> outcome;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  int error = descriptor < 0 ? errno : 0;
  std::string bytes;
  std::array<char, 65536> block;
  while (error == 0) {
    const ssize_t got = ::read(descriptor, block.data(), block.size());
    if (got < 0 && errno != EINTR) error = errno;
    if (got == 0) break;
    if (got > 0) bytes.append(block.data(), static_cast<std::size_t>(got));
    if (bytes.size() > kMostBytes) error = EFBIG;
  }
  if (descriptor >= 0) ::close(descriptor);
  if (error == 0) {
    outcome.value = std::move(bytes);
  } else {
    const Place place{path.string(), 0};
    outcome.problems.add({place, "", "cannot be read: " + std::generic_category().message(error), ""});
  }
  return outcome;
}

}  // namespace vehicle
