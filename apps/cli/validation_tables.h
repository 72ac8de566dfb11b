#pragma once

#include <vector>

#include "apps/cli/document.h"
#include "libvehicle/validation/validation.h"

namespace vehicle::cli {

/// One case in full: its runs, every quantity group of every run against the exact solution, every pair with its
/// expected size and why, what does not fit.
[[nodiscard]] Document documentOf(const ValidationReport& report);

/// A suite: one line a case, and the pairs outside in full.
[[nodiscard]] Document documentOf(const std::vector<ValidationReport>& reports);

/// "flat rk4 against mbs dopri5: ... " for every pair outside and every run that failed, one line each.
[[nodiscard]] std::vector<std::string> complaintsOf(const ValidationReport& report);

}  // namespace vehicle::cli
