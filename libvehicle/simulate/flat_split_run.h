#pragma once

#include <span>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/schemes/independent_parts.h"

namespace vehicle {

// The methods rk4_split and exact_split: bounce and pitch of a flat vehicle whose front and rear are alike, each
// as a run of its own in (3.4)-(3.7) of docs/theory/vertical.md. On two threads there is no exchange between them; the
// numbers are the same bits on one and on two, and differ from those of rk4 and exact by rounding.

/// @param team  1 or 2 threads; on 1 the caller's own steps both halves in one loop
/// @throws std::invalid_argument  with splitMisfit(); for more than two threads; and as runRk4()
PartsRun runFlatRk4Split(const FlatForm& form, const Input& input, const Schedule& schedule, FixedStep step,
                         std::span<const double> x0, const Observer& observe, const TeamChoice& team = {});

/// @param team  1 or 2 threads; on 1 the caller's own runs bounce, then pitch, and shows samples with the second
/// @throws std::invalid_argument  with splitMisfit(); for more than two threads; and as runExact()
PartsRun runFlatExactSplit(const FlatForm& form, const Input& input, const Schedule& schedule,
                           std::span<const double> x0, const Observer& observe, const TeamChoice& team = {});

}  // namespace vehicle
