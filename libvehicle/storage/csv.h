#pragma once

#include <filesystem>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/result/time_history.h"

namespace vehicle {

/// Writes a history as comma-separated text: one line of names and units, then one line a sample.
///
///     time [s],carbody.z [m],carbody.pitch [rad]
///     0,0,0
///     0.005,7.62682862341839e-09,2.2137389103607e-08
///
/// Every number is the shortest text that reads back to the same bits. Written atomically (atomic_file.h).
/// @throws RunFailed             the file cannot be written; names the path and the system's reason
/// @throws std::invalid_argument the history has no columns or holds a value that is not finite; names column and time
void writeCsv(const TimeHistory& history, const std::filesystem::path& path);

/// Reads what writeCsv writes, bit for bit. Lines may end in CR LF; a byte-order mark is skipped.
/// Problems (at most 20, then the reading ends): a header without unit or whose first column is not "time [s]", a
/// column that appears twice, a row with another number of fields, a field that is no finite number.
[[nodiscard]] Outcome<TimeHistory> readCsv(const std::filesystem::path& path);

}  // namespace vehicle
