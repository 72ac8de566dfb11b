#pragma once

#include "libvehicle/definition/metric.h"
#include "libvehicle/ensemble/ensemble.h"

namespace vehicle {

/// Whether an ensemble's summary holds this statistic; the others need samples or amplitudes.
[[nodiscard]] inline bool comesFromSummary(Statistic statistic) {
  return statistic != Statistic::kPercentile && statistic != Statistic::kAbsolutePercentile &&
         statistic != Statistic::kBand;
}

/// @param statistic  one that comesFromSummary()
[[nodiscard]] inline double fromSummary(Statistic statistic, const ColumnSummary& summary) {
  switch (statistic) {
    case Statistic::kRms:
      return summary.rms;
    case Statistic::kMean:
      return summary.mean;
    case Statistic::kMin:
      return summary.lowest;
    case Statistic::kMax:
      return summary.highest;
    default:
      return summary.peak();
  }
}

}  // namespace vehicle
