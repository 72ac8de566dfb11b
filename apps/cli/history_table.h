#pragma once

#include <vector>

#include "apps/cli/document.h"
#include "libvehicle/result/column_summary.h"
#include "libvehicle/units/channel.h"

namespace vehicle::cli {

/// One line a column: smallest, largest, largest size and when, mean and root mean square over the run; for people in
/// units of handy size, else in SI.
/// @param columns  "time" first   @param summaries  of the others
[[nodiscard]] Table historyTable(const std::vector<Channel>& columns, const std::vector<ColumnSummary>& summaries,
                                 Format format);

}  // namespace vehicle::cli
