#pragma once

#include <memory>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/schemes/pipeline.h"
#include "libvehicle/system/run_problem.h"

namespace vehicle {

// Methods on the flat form by type: the compiler sees equations and stepper as one, no virtual call in between. The
// paper's own form is the one that is run most. Each gives the bits of its namesake, which takes every other form and
// the printed variants.

/// The problem's system where it is the flat form, else nullptr.
[[nodiscard]] const FlatForm* flatFormOf(const System& system);

/// makeRk4() by type; of other systems that can be cut and are longer than one vehicle, makeBlockedRk4().
[[nodiscard]] std::unique_ptr<Integrator> makeFlatRk4(const RunProblem& problem, FixedStep step);

/// makeDopri5() by type.
[[nodiscard]] std::unique_ptr<Integrator> makeFlatDopri5(const RunProblem& problem, Accuracy accuracy);

/// runPipeline() by type.
PipelineRun runFlatPipeline(const RunProblem& problem, FixedStep step, const Observer& observe, int threads,
                            const TeamPolicy& team);

}  // namespace vehicle
