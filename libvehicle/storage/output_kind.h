#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace vehicle {

/// The kinds of file that this program writes.
enum class OutputKind {
  kHistory,     // columns over time: .csv, .h5
  kStudyTable,  // the designs of a study: .csv
  kDatabase,    // a study: .sqlite
  kVehicle,     // a vehicle or train made of a design: .xml
  kTrace,       // spans of threads for Perfetto: .json
  kTimeline,    // steps of threads as a picture: .svg
};

struct OutputEnding {
  std::string_view ending;   // ".csv", in lower case; names may have any
  std::string_view meaning;  // "text"
};

struct OutputKindInfo {
  OutputKind kind;
  std::string_view name;  // "time history", as messages call such a file
  std::span<const OutputEnding> endings;
};
/// All of them, in the order of the enumerators.
[[nodiscard]] std::span<const OutputKindInfo> outputKinds();
[[nodiscard]] const OutputKindInfo& infoOf(OutputKind kind);

/// Whether the program has written that file, as an output of that kind: by the header of a CSV, the groups of an HDF5
/// file, the application id of a database, the marks below of other texts.
[[nodiscard]] bool isOurs(const std::filesystem::path& path, OutputKind kind);
/// Whether it is an SQLite database, whoever has written it.
[[nodiscard]] bool isSqlite(const std::filesystem::path& path);

// What marks a text as written by this program; within its first 1000 bytes.
inline constexpr std::string_view kVehicleMark = "<!-- a design of a study, written by the program vehicle -->";
inline constexpr std::string_view kTraceMark = "\"otherData\":{\"program\":\"vehicle profile\"}";
inline constexpr std::string_view kTimelineMark = "<desc>timeline of threads by vehicle profile</desc>";

}  // namespace vehicle
