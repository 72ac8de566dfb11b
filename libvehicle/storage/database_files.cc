#include "libvehicle/storage/database_files.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "libvehicle/storage/output_kind.h"

namespace vehicle {

namespace fs = std::filesystem;

fs::path companionOf(const fs::path& database, std::string_view ending) {
  fs::path companion = database;
  companion += ending;
  return companion;
}

fs::path databaseOfCompanion(const fs::path& file) {
  const std::string name = file.string();
  for (const std::string_view ending : kCompanionEndings) {
    if (!name.ends_with(ending)) continue;
    const fs::path database = name.substr(0, name.size() - ending.size());
    if (isSqlite(database)) return database;
  }
  return {};
}

bool isCompanion(const fs::path& file, std::string_view ending) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return true;
  if (!fs::is_regular_file(status)) return false;
  if (fs::file_size(file, error) == 0 && !error) return true;
  std::string head(8, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  // Source: SQLite, Database File Format, sections 3 and 4.1; WAL-mode File Format, section 2.1.
  if (ending == "-wal") return head.starts_with("\x37\x7f\x06\x82") || head.starts_with("\x37\x7f\x06\x83");
  if (ending == "-journal") {
    const std::string zeros(8, '\0');  // a journal that SQLite has ended and kept
    return head == "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7" || head == zeros;
  }
  if (ending == "-shm") {
    constexpr std::uint32_t kIndexVersion = 3007000;  // in the byte order of the machine
    std::uint32_t version = 0;
    std::memcpy(&version, head.data(), sizeof version);
    return version == kIndexVersion || version == 0;
  }
  return false;  // a lock is empty
}

}  // namespace vehicle
