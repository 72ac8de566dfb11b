#include "libvehicle/partition/map/equation_graph.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

[[noreturn]] void refuse(const Equation& equation, const std::string& what) {
  throw std::invalid_argument("equation \"" + equation.name + "\" " + what);
}

}  // namespace

EquationGraph::EquationGraph(const EquationSet& set) : set_(&set), neighbours_(set.equations().size()) {
  if (neighbours_.empty()) throw std::invalid_argument("equation graph: the set has no equations");
  for (int e = 0; e < size(); ++e) {
    const Equation& equation = set.equations()[at(e)];
    if (equation.first_channel < 0 || equation.last_channel < equation.first_channel ||
        equation.last_channel > set.channels()) {
      refuse(equation, "names the channels " + std::to_string(equation.first_channel) + " to " +
                           std::to_string(equation.last_channel) + ", must lie within 0 and " +
                           std::to_string(set.channels()));
    }
    for (const int other : equation.reads) {
      if (other < 0 || other >= size()) {
        refuse(equation, "reads equation " + std::to_string(other) + ", must be 0 to " + std::to_string(size() - 1));
      }
      if (other == e) continue;
      neighbours_[at(e)].push_back(other);
      neighbours_[at(other)].push_back(e);
    }
  }
  for (int e = 0; e < size(); ++e) {
    std::vector<int>& all = neighbours_[at(e)];
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    lowest_.push_back(all.empty() ? e : std::min(e, all.front()));
    highest_.push_back(all.empty() ? e : std::max(e, all.back()));
  }
}

EquationRun EquationGraph::reach(EquationRun run) const {
  EquationRun reached = run;
  for (int e = run.first; e < run.last; ++e) {
    reached.first = std::min(reached.first, lowest(e));
    reached.last = std::max(reached.last, highest(e) + 1);
  }
  return reached;
}

ChannelRun EquationGraph::channels(EquationRun run) const {
  ChannelRun hull{set_->channels(), 0};
  for (int e = run.first; e < run.last; ++e) {
    const Equation& equation = set_->equations()[at(e)];
    if (equation.first_channel == equation.last_channel) continue;
    hull.first = std::min(hull.first, equation.first_channel);
    hull.last = std::max(hull.last, equation.last_channel);
  }
  return hull.last > hull.first ? hull : ChannelRun{};
}

EquationRun hullOf(const std::vector<int>& share) {
  const auto [low, high] = std::minmax_element(share.begin(), share.end());
  return {*low, *high + 1};
}

std::vector<EquationRun> runsOf(const std::vector<int>& share) {
  std::vector<EquationRun> runs;
  for (const int e : share) {
    if (!runs.empty() && runs.back().last == e) {
      runs.back().last = e + 1;
    } else {
      runs.push_back({e, e + 1});
    }
  }
  return runs;
}

std::vector<int> ownersOf(const std::vector<std::vector<int>>& shares, int equations) {
  std::vector<int> owner(at(equations), -1);
  for (std::size_t thread = 0; thread < shares.size(); ++thread) {
    for (const int e : shares[thread]) owner[at(e)] = static_cast<int>(thread);
  }
  return owner;
}

}  // namespace vehicle
