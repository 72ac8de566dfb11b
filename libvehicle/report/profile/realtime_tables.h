#pragma once

#include "libvehicle/report/run/run_document.h"
#include "libvehicle/realtime/realtime_run.h"

namespace vehicle::report {

/// How a run by the clock went.
/// @param period  [s]
[[nodiscard]] Document documentOf(const RunNames& names, const RealtimeRun& run, double period);

}  // namespace vehicle::report
