#pragma once

#include <string>
#include <vector>

#include "libvehicle/validation/validation.h"

namespace vehicle {

/// "coach on waves at 72 km/h"
[[nodiscard]] std::string caseName(const ValidationReport& report);

/// What the runs of one or several cases warn of: of a vehicle itself once, of its motion with the case, where there are
/// several.
[[nodiscard]] Warnings warningsOf(const std::vector<ValidationReport>& reports, bool has_several);

/// What becomes of pairs that could not be judged.
enum class Unjudged {
  kFail,    // they are no pass
  kAccept,  // the judged ones decide
};

/// What all cases together say.
enum class Overall {
  kHolds,
  kDoesNotHold,  // a pair is outside, nothing was judged, or a pair could not be and that is not accepted
  kFailed,       // a run could not be finished
  kInterrupted,  // ended early on request
};

/// A failed run comes before a pair outside, that before an early end, that before pairs that were not judged. Where
/// nothing was judged at all no check did hold, accepted or not.
[[nodiscard]] Overall overallOf(const std::vector<ValidationReport>& reports, Unjudged unjudged);

}  // namespace vehicle
