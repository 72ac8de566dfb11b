#pragma once

#include "apps/cli/document.h"
#include "libvehicle/study/study_inputs.h"
#include "libvehicle/study/summary.h"

namespace vehicle::cli {

/// A study as a document: the designs compared with the first one ("base"), the best of each objective, the Pareto
/// front, what the factors do, and designs that failed. For eyes a cell holds the value in a unit that is read easily,
/// its difference to `base` in percent and a "!" where a limit is broken; for csv and json every number is SI and has a
/// cell of its own.
[[nodiscard]] Document documentOf(const StudySummary& summary, const StudyInputs& inputs, Format format);

}  // namespace vehicle::cli
