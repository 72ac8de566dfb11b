#pragma once

#include "apps/cli/document.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "libvehicle/realtime/realtime_run.h"

namespace vehicle::cli {

/// `vehicle profile --realtime`: runs the model by the clock, prints how it went, returns the exit status.
/// @param period  [s]
[[nodiscard]] int profileByTheClock(const Model& model, const RunChoice& choice, double period,
                                    const CommonOptions& common);

/// What it prints after the names of the run.
[[nodiscard]] Document documentOf(const RealtimeRun& run, double period);

}  // namespace vehicle::cli
