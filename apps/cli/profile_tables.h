#pragma once

#include <string>
#include <vector>

#include "apps/cli/document.h"
#include "apps/cli/profile_run.h"
#include "libvehicle/threads/duration_histogram.h"
#include "libvehicle/threads/team.h"

namespace vehicle::cli {

/// Facts that say which run this was.
[[nodiscard]] std::vector<Fact> namesOf(const Model& model, const std::string& form, const std::string& method,
                                        double speed);

/// "al-oraiqat-2017: rk4 stages on 4 threads, 2 cores"
[[nodiscard]] std::string titleOf(const Profile& profile, const std::string& vehicle);

/// Everything that `vehicle profile` prints after the names of the run.
[[nodiscard]] Document documentOf(const Profile& profile);

/// Cores and priority of each thread: before and after pinning, and what was not granted. Told by `--realtime` too.
[[nodiscard]] Table placementTable(const TeamReport& team);

/// Durations in about a dozen bins of equal ratio.
/// @param name  of the table   @param what  is counted, e.g. "steps"
[[nodiscard]] Table histogramTable(const std::string& name, const std::string& what, const DurationSummary& durations);

/// p50, p99, p99.9 and the longest as a row: {name, count, mean, p50, p99, p99.9, longest} in microseconds.
[[nodiscard]] std::vector<Cell> quantileRow(const std::string& name, const DurationSummary& durations);
[[nodiscard]] Table quantileTable(const std::string& name, std::vector<std::vector<Cell>> rows);

}  // namespace vehicle::cli
