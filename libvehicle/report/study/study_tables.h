#pragma once

#include "libvehicle/report/document/document.h"
#include "libvehicle/study/study_inputs.h"
#include "libvehicle/study/summary.h"

namespace vehicle::report {

/// A study as a document: how many designs it has and what became of them, the designs compared with the first one
/// ("base"), the best of each objective, the Pareto front, what the factors do, why values are missing, and designs that
/// failed. For people a cell holds the value in a unit that is read easily, its difference to `base` in percent and a
/// "!" where a limit is broken; for csv and json every number is SI and has a cell of its own, and a design has its
/// number in the database beside its name. A value that is missing is "-", an empty field, or null.
[[nodiscard]] Document documentOf(const StudySummary& summary, const StudyInputs& inputs, Format format);

}  // namespace vehicle::report
