#include "libvehicle/partition/schemes/stage_plan.h"

#include <algorithm>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

ChannelRun channelsOf(const EquationGraph& graph, const std::vector<EquationRun>& own) {
  ChannelRun all{};
  for (const EquationRun& run : own) {
    const ChannelRun more = graph.channels(run);
    if (more.size() == 0) continue;
    all = all.size() == 0 ? more : ChannelRun{std::min(all.first, more.first), std::max(all.last, more.last)};
  }
  return all;
}

void take(StagePlan::Part& part, int owner, int place, int e) {
  auto source = std::find_if(part.sources.begin(), part.sources.end(),
                             [&](const StagePlan::Source& one) { return one.owner == owner; });
  if (source == part.sources.end()) {
    part.sources.push_back({owner, {}});
    source = part.sources.end() - 1;
  }
  addShown(source->pieces, place, e);
}

}  // namespace

StagePlan::StagePlan(const EquationGraph& graph, const std::vector<std::vector<int>>& shares) {
  const std::vector<int> owner = ownersOf(shares, graph.size());
  std::vector<int> place(at(graph.size()), -1);
  for (const std::vector<int>& share : shares) {
    Part part{.share = share, .own = runsOf(share), .shown = {}, .sources = {}, .held = hullOf(share), .channels = {}};
    part.channels = channelsOf(graph, part.own);
    std::vector<int> shown;
    for (const int e : share) {
      part.held.first = std::min(part.held.first, graph.lowest(e));
      part.held.last = std::max(part.held.last, graph.highest(e) + 1);
      const std::vector<int>& around = graph.neighbours(e);
      if (std::all_of(around.begin(), around.end(), [&](int n) { return owner[at(n)] == owner[at(e)]; })) continue;
      place[at(e)] = 2 * static_cast<int>(shown.size());
      shown.push_back(e);
    }
    part.shown = runsOf(shown);
    values.push_back(2 * static_cast<int>(shown.size()));
    parts.push_back(std::move(part));
  }
  for (std::size_t thread = 0; thread < shares.size(); ++thread) {
    std::vector<int> read;
    for (const int e : shares[thread]) {
      for (const int n : graph.neighbours(e)) {
        if (owner[at(n)] != static_cast<int>(thread)) read.push_back(n);
      }
    }
    std::sort(read.begin(), read.end());
    read.erase(std::unique(read.begin(), read.end()), read.end());
    for (const int e : read) take(parts[thread], owner[at(e)], place[at(e)], e);
  }
}

}  // namespace vehicle
