#pragma once

#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/study/study_inputs.h"
#include "libvehicle/study/summary.h"

namespace vehicle {

/// What is doubtful of a study before its first design: the vehicle itself (file_warnings.h), metrics of modes that the vehicle does not have (UNKNOWN_MODE),
/// the size of a Saltelli plan (SAMPLE_SIZE).
/// Cost: an eigenvalue problem where a mode is asked for.
[[nodiscard]] Warnings warningsBefore(const StudyInputs& inputs);

/// What is doubtful of its results: how many designs left what the model can say, one warning a code; and once all
/// designs are stored the outputs of a Saltelli plan without indices (NO_INDEX).
[[nodiscard]] Warnings warningsAfter(const StudyInputs& inputs, const StudySummary& summary);

}  // namespace vehicle
