#include "libvehicle/storage/output_kind.h"

#include <array>
#include <cstdint>
#include <fstream>

#include "libvehicle/storage/file_identity.h"
#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/study_tables.h"

namespace vehicle {

namespace {

constexpr std::array<OutputEnding, 2> kHistoryEndings = {{{".csv", "text"}, {".h5", "HDF5"}}};
constexpr std::array<OutputEnding, 1> kTableEndings = {{{".csv", "text"}}};
constexpr std::array<OutputEnding, 1> kDatabaseEndings = {{{".sqlite", "SQLite"}}};
constexpr std::array<OutputEnding, 1> kVehicleEndings = {{{".xml", "XML"}}};
constexpr std::array<OutputEnding, 1> kTraceEndings = {{{".json", "JSON"}}};
constexpr std::array<OutputEnding, 1> kTimelineEndings = {{{".svg", "SVG"}}};

constexpr std::array<OutputKindInfo, 6> kKinds = {{{OutputKind::kHistory, "time history", kHistoryEndings},
                                                   {OutputKind::kStudyTable, "table of a study", kTableEndings},
                                                   {OutputKind::kDatabase, "database of a study", kDatabaseEndings},
                                                   {OutputKind::kVehicle, "vehicle of a study", kVehicleEndings},
                                                   {OutputKind::kTrace, "trace of threads", kTraceEndings},
                                                   {OutputKind::kTimeline, "timeline of threads", kTimelineEndings}}};

/// The first bytes of a file; "" where it cannot be read.
std::string headOf(const std::filesystem::path& path) {
  constexpr std::size_t kHead = 1000;
  std::string head(kHead, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

/// Whether the first line of a CSV begins with these columns.
bool beginsWithColumns(std::string_view head, std::string_view columns) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
  if (!head.starts_with(columns)) return false;
  head.remove_prefix(columns.size());
  return head.empty() || head.front() == ',' || head.front() == '\n' || head.front() == '\r';
}

/// The application id is the big-endian number at byte 68.
/// Source: SQLite, Database File Format, section 1.3.
std::uint32_t applicationOf(std::string_view head) {
  constexpr std::size_t kAt = 68;
  if (head.size() < kAt + 4) return 0;
  std::uint32_t id = 0;
  for (const char byte : head.substr(kAt, 4)) id = 256 * id + static_cast<unsigned char>(byte);
  return id;
}

bool isSqliteHead(std::string_view head) { return head.starts_with(std::string_view("SQLite format 3\0", 16)); }

}  // namespace

std::span<const OutputKindInfo> outputKinds() { return kKinds; }

const OutputKindInfo& infoOf(OutputKind kind) { return kKinds.at(static_cast<std::size_t>(kind)); }

bool isSqlite(const std::filesystem::path& path) { return isSqliteHead(headOf(path)); }

bool isOurs(const std::filesystem::path& path, OutputKind kind) {
  const std::string head = headOf(path);
  const auto marked = [&](std::string_view mark) { return head.find(mark) != std::string::npos; };
  switch (kind) {
    case OutputKind::kHistory:
      return endingOf(path) == ".h5" ? isHdf5Run(path) : beginsWithColumns(head, "time [s]");
    case OutputKind::kStudyTable:
      return beginsWithColumns(head, "id,design,status") || beginsWithColumns(head, "id,status") ||
             beginsWithColumns(head, "design,name,status") || beginsWithColumns(head, "design,status");  // up to format 1
    case OutputKind::kDatabase:
      return isSqliteHead(head) && applicationOf(head) == kStudyApplication;
    case OutputKind::kVehicle:
      return marked(kVehicleMark);
    case OutputKind::kTrace:
      return marked(kTraceMark);
    case OutputKind::kTimeline:
      return marked(kTimelineMark);
  }
  return false;
}

}  // namespace vehicle
