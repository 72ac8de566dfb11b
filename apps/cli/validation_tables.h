#pragma once

#include <vector>

#include "apps/cli/document.h"
#include "apps/cli/exit_status.h"
#include "libvehicle/validation/validation.h"

namespace vehicle::cli {

/// How much of a case is told.
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

/// What becomes of pairs that could not be judged.
enum class Unjudged {
  kFail,    // they are no pass
  kAccept,  // the judged ones decide
};

/// A failed run comes before a pair outside, that before an early end, that before pairs that were not judged. Where
/// nothing was judged at all no check did hold, accepted or not.
[[nodiscard]] ExitStatus exitStatusOf(const std::vector<ValidationReport>& reports, Unjudged unjudged);

}  // namespace vehicle::cli
