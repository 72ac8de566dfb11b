#pragma once

#include <span>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/partition/run.h"
#include "libvehicle/partition/schemes/pipeline.h"

namespace vehicle {

// Methods on the flat form by type: the compiler sees equations and stepper as one, no virtual call in between.
// Each gives the bits of its namesake on the same form; the printed variants go that way.

/// runRk4() by type.
Statistics runFlatRk4(const FlatForm& form, const Input& input, const Schedule& schedule, FixedStep step,
                      std::span<const double> x0, const Observer& observe);

/// runPipeline() by type.
PipelineRun runFlatPipeline(const FlatForm& form, const Input& input, const Schedule& schedule, FixedStep step,
                            std::span<const double> x0, const Observer& observe, const TeamChoice& team);

/// runStageExchange() by type: a thread's own equations and its step as one.
PartitionRun runFlatStages(const FlatForm& form, const Input& input, const Schedule& schedule, FixedStep step,
                           std::span<const double> x0, const Observer& observe, const PartitionChoice& choice);

/// runDopri5() by type.
Statistics runFlatDopri5(const FlatForm& form, const Input& input, const Schedule& schedule, Accuracy accuracy,
                         std::span<const double> x0, const Observer& observe);

}  // namespace vehicle
