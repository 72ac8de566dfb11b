#pragma once

#include <vector>

#include "libvehicle/partition/map/equation_graph.h"
#include "libvehicle/system/equation_set.h"

namespace vehicle {

/// Where the entries of a thread's own equations stand in the System's state.
class OwnState {
 public:
  OwnState(const EquationSet& set, const std::vector<int>& share) : order_(set.stateOrder()), runs_(runsOf(share)) {}

  /// Writes the own entries to x, in the System's order.
  /// @param from  from(e): (q, q') of equation e, the first of a contiguous run
  /// @return whether all are finite
  template <class From>
  bool copyTo(double* x, From from) const {
    double zero = 0.0;
    for (const EquationRun& run : runs_) {
      const double* values = from(run.first);
      for (int i = 0; i < 2 * run.size(); ++i) {
        zero += 0.0 * values[i];
        x[order_[static_cast<std::size_t>(2 * run.first + i)]] = values[i];
      }
    }
    return zero == 0.0;
  }

 private:
  const std::vector<int>& order_;
  std::vector<EquationRun> runs_;
};

}  // namespace vehicle
