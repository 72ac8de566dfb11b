#pragma once

#include <span>
#include <vector>

#include "libvehicle/units/channel.h"

namespace vehicle {

/// Takes the output samples of a run as they are made, in order: a history in memory, files on disk.
class HistorySink {
 public:
  virtual ~HistorySink() = default;

  /// Before the first sample.
  /// @param columns  "time" first   @param samples  that are to come if nothing ends the run early, >= 1
  /// @throws std::invalid_argument for columns that it cannot keep
  virtual void begin(const std::vector<Channel>& columns, long samples) = 0;
  /// @param row  (columns), finite, the time first; valid during the call only
  /// @throws RunFailed if it cannot be kept; the run ends with it
  virtual void add(std::span<const double> row) = 0;
};

}  // namespace vehicle
