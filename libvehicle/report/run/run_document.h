#pragma once

#include <string>
#include <vector>

#include "libvehicle/report/document/document.h"
#include "libvehicle/simulate/simulate.h"

namespace vehicle::report {

/// What ran, by its names.
struct RunNames {
  std::string vehicle;
  std::string scenario;
  std::string form;
  std::string method;
};
[[nodiscard]] std::vector<Fact> factsOf(const RunNames& names);
/// With the speed [m/s], which leads what is said of one run.
[[nodiscard]] std::vector<Fact> factsOf(const RunNames& names, double speed);

/// One run: how it was shared, its statistics, what was weighed, one line a column.
[[nodiscard]] Document documentOf(const RunNames& names, const RunResult& result, Format format);

/// Runs at several speeds: one line a run, and each column speed by speed.
/// @param runs  one or more, of one vehicle on one scenario; of a history the columns alone are read
[[nodiscard]] Document documentOf(const RunNames& names, const std::vector<RunResult>& runs, Format format);

}  // namespace vehicle::report
