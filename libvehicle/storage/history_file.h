#pragma once

#include <filesystem>

#include "libvehicle/storage/run_record.h"

namespace vehicle {

enum class HistoryFormat {
  kCsv,
  kHdf5
};

/// By the extension, in any letter case: .csv or .h5. Asked before a run, so that a wrong name costs no waiting.
/// @throws std::invalid_argument naming the path and both extensions
[[nodiscard]] HistoryFormat historyFormatOf(const std::filesystem::path& path);

/// Writes the run in the format of the extension; .csv holds the history alone, .h5 the whole record.
/// @throws std::invalid_argument  another extension, or a history that cannot be stored
/// @throws RunFailed              the file cannot be written; names the path and the system's reason
void writeHistory(const std::filesystem::path& path, const RunRecord& record);

}  // namespace vehicle
