#include "libvehicle/storage/read_file.h"

#include <cstddef>
#include <utility>

#include "libvehicle/diagnostics/file_bytes.h"

namespace vehicle {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 28;

}  // namespace

Outcome<std::string> readFile(const std::filesystem::path& path) {
  Outcome<std::string> outcome;
  FileBytes read = readBytes(path, kMostBytes);
  if (read.error) {
    const Place place{path.string(), 0};
    outcome.problems.add({place, "", "cannot be read: " + read.error.message(), ""});
  } else {
    outcome.value = std::move(read.bytes);
  }
  return outcome;
}

}  // namespace vehicle
