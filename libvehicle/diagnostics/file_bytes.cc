#include "libvehicle/diagnostics/file_bytes.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace vehicle {

FileBytes readBytes(const std::filesystem::path& path, std::size_t most) {
  FileBytes read;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  int error = descriptor < 0 ? errno : 0;
  std::array<char, 65536> block;
  while (error == 0) {
    const ssize_t got = ::read(descriptor, block.data(), block.size());
    if (got < 0 && errno != EINTR) error = errno;
    if (got == 0) break;
    if (got > 0) read.bytes.append(block.data(), static_cast<std::size_t>(got));
    if (read.bytes.size() > most) error = EFBIG;
  }
  if (descriptor >= 0) ::close(descriptor);
  if (error != 0) read = {{}, std::error_code(error, std::generic_category())};
  return read;
}

}  // namespace vehicle
