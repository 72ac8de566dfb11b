#pragma once

#include <string>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/report/document/document.h"

namespace vehicle::report {

/// Verdicts on files, without rows yet.
[[nodiscard]] Table problemTable();
/// Adds a line for each problem of a file, or one that it is "ok".
void addProblems(const std::string& file, const ProblemList& problems, Table& table);

}  // namespace vehicle::report
