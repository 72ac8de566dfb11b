#pragma once

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/schemes/pipeline.h"
#include "libvehicle/system/run_problem.h"

namespace vehicle {

// Methods on the flat form by type: the compiler sees equations and stepper as one, no virtual call in between. The
// paper's own form is the one that is run most. Each gives the bits of its namesake, which takes every other form and
// the printed variants.

/// The problem's system where it is the flat form, else nullptr.
[[nodiscard]] const FlatForm* flatFormOf(const RunProblem& problem);

/// runRk4() by type.
Statistics runFlatRk4(const RunProblem& problem, FixedStep step, const Observer& observe);

/// runPipeline() by type.
PipelineRun runFlatPipeline(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                            const TeamPolicy& team);

/// runDopri5() by type.
Statistics runFlatDopri5(const RunProblem& problem, Accuracy accuracy, const Observer& observe);

}  // namespace vehicle
