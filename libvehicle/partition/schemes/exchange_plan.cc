#include "libvehicle/partition/schemes/exchange_plan.h"

#include <algorithm>
#include <cstddef>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

int equationsIn(const Shares& shares) {
  std::size_t equations = 0;
  for (const std::vector<int>& share : shares) equations += share.size();
  return static_cast<int>(equations);
}

/// Adds an equation, to the last piece where it continues that.
void add(std::vector<ExchangePlan::Piece>& pieces, int slot, int equation) {
  if (!pieces.empty()) {
    ExchangePlan::Piece& last = pieces.back();
    if (last.first + last.count == equation && last.slot + 2 * last.count == slot) {
      ++last.count;
      return;
    }
  }
  pieces.push_back({slot, equation, 1});
}

}  // namespace

ExchangePlan::ExchangePlan(const Shares& shares, const Shares& read) : parts(shares.size()) {
  const std::vector<int> owner = ownersOf(shares, equationsIn(shares));
  std::vector<char> is_read(owner.size(), 0);
  std::vector<std::vector<char>> meets(shares.size(), std::vector<char>(shares.size(), 0));
  for (std::size_t thread = 0; thread < read.size(); ++thread) {
    for (const int e : read[thread]) {
      is_read[at(e)] = 1;
      meets[thread][at(owner[at(e)])] = meets[at(owner[at(e)])][thread] = 1;
    }
  }
  std::vector<int> place(owner.size(), -1);  // of an equation in its owner's slot
  for (std::size_t thread = 0; thread < shares.size(); ++thread) {
    std::vector<int> shown;
    for (const int e : shares[thread]) {
      if (!is_read[at(e)]) continue;
      place[at(e)] = 2 * static_cast<int>(shown.size());
      shown.push_back(e);
    }
    parts[thread].shown = runsOf(shown);
    values.push_back(2 * static_cast<int>(shown.size()));
  }
  for (std::size_t thread = 0; thread < shares.size(); ++thread) {
    for (std::size_t other = 0; other < shares.size(); ++other) {
      if (!meets[thread][other]) continue;
      Source source{.owner = static_cast<int>(other), .pieces = {}};
      for (const int e : read[thread]) {
        if (at(owner[at(e)]) == other) add(source.pieces, place[at(e)], e);
      }
      parts[thread].sources.push_back(std::move(source));
    }
  }
}

Shares neighboursOf(const EquationGraph& graph, const Shares& shares) {
  const std::vector<int> owner = ownersOf(shares, graph.size());
  Shares read;
  for (const std::vector<int>& share : shares) {
    std::vector<int> others;
    for (const int e : share) {
      for (const int n : graph.neighbours(e)) {
        if (owner[at(n)] != owner[at(e)]) others.push_back(n);
      }
    }
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    read.push_back(std::move(others));
  }
  return read;
}

Shares halosOf(const EquationGraph& graph, const Shares& shares) {
  const std::vector<int> owner = ownersOf(shares, graph.size());
  Shares read;
  for (const std::vector<int>& share : shares) {
    EquationRun reach = hullOf(share);
    for (int stage = 0; stage < 4; ++stage) reach = graph.reach(reach);
    std::vector<int> others;
    for (int e = reach.first; e < reach.last; ++e) {
      if (owner[at(e)] != owner[at(share.front())]) others.push_back(e);
    }
    read.push_back(std::move(others));
  }
  return read;
}

}  // namespace vehicle
