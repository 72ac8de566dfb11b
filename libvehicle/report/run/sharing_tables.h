#pragma once

#include <vector>

#include "libvehicle/report/document/document.h"
#include "libvehicle/simulate/simulate.h"

namespace vehicle::report {

/// How a run was shared: scheme and threads; where that was left open, the reason for the choice too.
[[nodiscard]] std::vector<Fact> sharingFacts(const RunResult& result);

/// What --threads auto weighed: each way with the time of a step that was predicted and measured; without rows where
/// nothing was left open.
[[nodiscard]] Table decisionTable(const Decision& decision);

}  // namespace vehicle::report
