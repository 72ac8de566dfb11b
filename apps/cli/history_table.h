#pragma once

#include "apps/cli/document.h"
#include "libvehicle/result/time_history.h"

namespace vehicle::cli {

/// One line a column: smallest, largest, largest size and when, root mean square over the samples.
[[nodiscard]] Table historyTable(const TimeHistory& history);

}  // namespace vehicle::cli
