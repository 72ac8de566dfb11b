#pragma once

#include <string>
#include <vector>

#include "libvehicle/report/document/document.h"
#include "libvehicle/report/run/run_document.h"
#include "libvehicle/simulate/profile.h"
#include "libvehicle/threads/duration_histogram.h"
#include "libvehicle/threads/team.h"

namespace vehicle::report {

/// "al-oraiqat-2017: rk4 stages on 4 threads, 2 cores"
[[nodiscard]] std::string titleOf(const Profile& profile, const std::string& vehicle);

/// How threads shared a run and what they waited for.
[[nodiscard]] Document documentOf(const RunNames& names, const Profile& profile);

/// Cores and priority of each thread: before and after pinning, and what was not granted.
[[nodiscard]] Table placementTable(const TeamReport& team);

/// Durations in about a dozen bins of equal ratio.
/// @param name  of the table   @param what  is counted, e.g. "steps"
[[nodiscard]] Table histogramTable(const std::string& name, const std::string& what, const DurationSummary& durations);

/// p50, p99, p99.9 and the longest as a row: {name, count, mean, p50, p99, p99.9, longest} in microseconds.
[[nodiscard]] std::vector<Cell> quantileRow(const std::string& name, const DurationSummary& durations);
[[nodiscard]] Table quantileTable(const std::string& name, std::vector<std::vector<Cell>> rows);

}  // namespace vehicle::report
