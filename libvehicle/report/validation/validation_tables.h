#pragma once

#include <string>
#include <vector>

#include "libvehicle/report/document/document.h"
#include "libvehicle/validation/validation.h"

namespace vehicle::report {

/// How much of a case is shown.
enum class Detail {
  kSummary,  // quantities of the worst run of each form; pairs counted form by form, named where outside
  kAll,      // quantities of every run, every pair
};

/// One case: its runs, quantity groups against the exact solution, form against form, pairs with their expected
/// size and why, what does not fit.
[[nodiscard]] Document documentOf(const ValidationReport& report, Detail detail);

/// A suite: one line a case, and the pairs outside in full.
[[nodiscard]] Document documentOf(const std::vector<ValidationReport>& reports);

/// "flat rk4 against mbs dopri5: ... " for every pair outside and every run without a result, one line each.
[[nodiscard]] std::vector<std::string> complaintsOf(const ValidationReport& report);

/// Why a finished case judges nothing, in one line; empty where something is judged.
[[nodiscard]] std::string whyNothing(const ValidationReport& report);

}  // namespace vehicle::report
