#pragma once

#include <vector>

#include "libvehicle/system/equation_set.h"

namespace vehicle {

/// Equations first .. last-1 in cut order.
struct EquationRun {
  int first = 0;
  int last = 0;
  [[nodiscard]] int size() const { return last - first; }
  friend bool operator==(const EquationRun&, const EquationRun&) = default;
};

/// Channels first .. last-1 in cut order.
struct ChannelRun {
  int first = 0;
  int last = 0;
  [[nodiscard]] int size() const { return last - first; }
};

/// Who reads whom, made symmetric: two equations are neighbours if one of them reads the other.
class EquationGraph {
 public:
  /// @throws std::invalid_argument for a set without equations, or with a read or a channel that does not exist
  explicit EquationGraph(const EquationSet& set);

  [[nodiscard]] int size() const { return static_cast<int>(neighbours_.size()); }
  [[nodiscard]] const std::vector<int>& neighbours(int equation) const {
    return neighbours_[static_cast<std::size_t>(equation)];
  }
  /// The lowest and the highest of an equation and its neighbours.
  [[nodiscard]] int lowest(int equation) const { return lowest_[static_cast<std::size_t>(equation)]; }
  [[nodiscard]] int highest(int equation) const { return highest_[static_cast<std::size_t>(equation)]; }

  /// The smallest run that holds the equations of `run` and all their neighbours.
  [[nodiscard]] EquationRun reach(EquationRun run) const;
  /// The smallest run of channels that holds those of the equations of `run`; empty where they have none.
  [[nodiscard]] ChannelRun channels(EquationRun run) const;

 private:
  const EquationSet* set_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<int> lowest_;
  std::vector<int> highest_;
};

/// The smallest run that holds every equation of a share (not empty).
[[nodiscard]] EquationRun hullOf(const std::vector<int>& share);

/// A share, ascending, as the contiguous runs it consists of.
[[nodiscard]] std::vector<EquationRun> runsOf(const std::vector<int>& share);

/// Entry e: the thread whose share holds equation e.
[[nodiscard]] std::vector<int> ownersOf(const std::vector<std::vector<int>>& shares, int equations);

}  // namespace vehicle
