#pragma once

#include <vector>

#include "libvehicle/partition/map/equation_graph.h"

namespace vehicle {

using Shares = std::vector<std::vector<int>>;  // (threads) ascending equations

/// Who shows which equations to whom at every exchange, and where they stand in the slots.
struct ExchangePlan {
  /// Equations first .. first+count-1 of one owner, neighbours in its slot as in a reader's state.
  struct Piece {
    int slot = 0;   // of the owner's slot [doubles]
    int first = 0;  // equation
    int count = 0;
  };
  struct Source {
    int owner = 0;
    std::vector<Piece> pieces;  // empty: a thread that only reads from us, and is awaited all the same (exchange.h)
  };
  struct Part {
    std::vector<EquationRun> shown;  // own equations that others read, in the order of the slot
    std::vector<Source> sources;     // by owner; symmetric: who is read reads, or awaits at least
  };
  std::vector<Part> parts;  // (threads)
  std::vector<int> values;  // (threads) doubles shown

  /// @param shares  each equation on one thread
  /// @param read    (threads) ascending equations of others that a thread reads
  ExchangePlan(const Shares& shares, const Shares& read);
};

/// What every thread reads of others for one evaluation of its own equations: their neighbours.
[[nodiscard]] Shares neighboursOf(const EquationGraph& graph, const Shares& shares);

/// What it reads for a whole step of rk4 that it computes alone: the run that four stages reach from its own.
[[nodiscard]] Shares halosOf(const EquationGraph& graph, const Shares& shares);

}  // namespace vehicle
