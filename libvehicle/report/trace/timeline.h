#pragma once

#include <string>

#include "libvehicle/threads/trace.h"

namespace vehicle::report {

/// Two traced steps of member 0 as a picture: one of median duration and the longest. A lane a thread, computing and
/// waiting in two colours, waits labelled with the thread waited for, an axis in microseconds from the step's
/// begin. What the other threads did before and after that step is shown as far as it was traced.
/// @return an SVG document
[[nodiscard]] std::string timelineOf(const Trace& trace, const std::string& title);

}  // namespace vehicle::report
