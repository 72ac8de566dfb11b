#pragma once

#include <string>

#include "libvehicle/threads/trace.h"

namespace vehicle::report {

/// The spans of a trace in the JSON that Perfetto (ui.perfetto.dev) and chrome://tracing open: one track a thread,
/// "compute" and "wait for thread j", times in microseconds since the team was prepared; threads count from 1.
/// Source: Trace Event Format, complete events ("ph": "X") and metadata events ("ph": "M").
[[nodiscard]] std::string chromeTraceOf(const Trace& trace, const std::string& title);

}  // namespace vehicle::report
