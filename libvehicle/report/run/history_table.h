#pragma once

#include <vector>

#include "libvehicle/report/document/document.h"
#include "libvehicle/result/column_summary.h"
#include "libvehicle/units/channel.h"

namespace vehicle::report {

/// One line a column: smallest, largest, largest size and when, mean and root mean square over the run; for people in
/// units of handy size, else in SI.
/// @param columns  "time" first   @param summaries  of the others
[[nodiscard]] Table historyTable(const std::vector<Channel>& columns, const std::vector<ColumnSummary>& summaries,
                                 Format format);

/// What a run at one of several speeds measured.
struct HistorySummary {
  double speed = 0.0;  // [m/s]
  std::vector<ColumnSummary> columns;
};

/// The same for several speeds: each column, speed by speed.
[[nodiscard]] Table speedTable(const std::vector<Channel>& columns, const std::vector<HistorySummary>& runs,
                               Format format);

}  // namespace vehicle::report
