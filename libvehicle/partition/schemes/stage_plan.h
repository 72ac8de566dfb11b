#pragma once

#include <vector>

#include "libvehicle/partition/map/equation_graph.h"
#include "libvehicle/partition/schemes/shown_piece.h"

namespace vehicle {

/// Who shows what to whom at every stage. A thread shows the equations that are neighbours of another's, in ascending
/// order.
struct StagePlan {
  struct Source {
    int owner = 0;
    std::vector<ShownPiece> pieces;
  };
  struct Part {
    std::vector<int> share;           // own equations, ascending
    std::vector<EquationRun> own;     // the same as runs
    std::vector<EquationRun> shown;
    std::vector<Source> sources;      // symmetric: who is read reads
    EquationRun held;                 // own equations and neighbours
    ChannelRun channels;              // that enter own equations
  };
  std::vector<Part> parts;            // (threads)
  std::vector<int> values;            // (threads) doubles shown a stage

  StagePlan(const EquationGraph& graph, const std::vector<std::vector<int>>& shares);
};

}  // namespace vehicle
