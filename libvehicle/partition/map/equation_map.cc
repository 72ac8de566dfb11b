#include "libvehicle/partition/map/equation_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "libvehicle/partition/map/bisection.h"
#include "libvehicle/partition/map/equation_graph.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

using Shares = std::vector<std::vector<int>>;

std::string plural(int count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

[[noreturn]] void refuseThreads(EquationMap map, int threads, int most, const char* one, const char* many) {
  throw std::invalid_argument(plural(threads, "thread", "threads") + " for " + plural(most, one, many) + ": map " +
                              nameOf(map) + " gives every thread at least one; take at most " + std::to_string(most));
}

std::vector<double> costsOf(const EquationSet& set, std::span<const double> given) {
  const std::vector<Equation>& equations = set.equations();
  if (given.empty()) {
    std::vector<double> cost;
    for (const Equation& equation : equations) {
      cost.push_back(1.0 + 0.5 * (equation.last_channel - equation.first_channel));
    }
    return cost;
  }
  if (given.size() != equations.size()) {
    throw std::invalid_argument("equation map: " + std::to_string(given.size()) + " costs, must be " +
                                std::to_string(equations.size()) + ", one an equation");
  }
  for (std::size_t e = 0; e < given.size(); ++e) {
    if (!(given[e] > 0.0 && std::isfinite(given[e]))) {
      throw std::invalid_argument("equation map: cost[" + std::to_string(e) + "] = " + std::to_string(given[e]) +
                                  ", must be finite and > 0");
    }
  }
  return {given.begin(), given.end()};
}

/// Ends of `parts` contiguous runs of items: the heaviest run as light as can be, then the places where least is cut.
/// @param cut  (items + 1) what is read across the border before each item
std::vector<int> lightestRuns(const std::vector<double>& cost, const std::vector<double>& cut, int parts) {
  const int items = static_cast<int>(cost.size());
  std::vector<double> before(cost.size() + 1, 0.0);
  std::partial_sum(cost.begin(), cost.end(), before.begin() + 1);
  // Rounding of a sum of costs must not cost a run.
  const double slack = 1e-9 * before.back();
  const auto runs = [&](double most) {
    int count = 1;
    double from = 0.0;
    for (int i = 0; i < items; ++i) {
      if (before[at(i) + 1] - from <= most + slack) continue;
      from = before[at(i)];
      ++count;
    }
    return count;
  };
  double low = std::max(before.back() / parts, *std::max_element(cost.begin(), cost.end()));
  double high = before.back();
  for (int i = 0; i < 60 && high - low > slack; ++i) {
    const double middle = 0.5 * (low + high);
    (runs(middle) <= parts ? high : low) = middle;
  }
  // A few percent more on the heaviest run buy a border that fewer values cross.
  const double most = std::max(high, 1.03 * before.back() / parts) + slack;
  // need[i]: the fewest runs that hold the items from i on, none above `most`.
  std::vector<int> need(cost.size() + 1, 0);
  for (int i = items - 1, end = items; i >= 0; --i) {
    while (before[at(end)] - before[at(i)] > most) --end;
    need[at(i)] = 1 + need[at(end)];
  }
  std::vector<int> ends;
  int begin = 0;
  for (int left = parts - 1; left > 0; --left) {
    const double ideal = before[at(begin)] + (before.back() - before[at(begin)]) / (left + 1);
    const auto better = [&](int one, int other) {
      if (cut[at(one)] != cut[at(other)]) return cut[at(one)] < cut[at(other)];
      return std::abs(before[at(one)] - ideal) < std::abs(before[at(other)] - ideal);
    };
    int best = -1;
    for (int end = begin + 1; end <= items - left && before[at(end)] - before[at(begin)] <= most; ++end) {
      if (need[at(end)] <= left && (best < 0 || better(end, best))) best = end;
    }
    ends.push_back(best);
    begin = best;
  }
  ends.push_back(items);
  return ends;
}

Shares paperShares(const EquationSet& set, int threads) {
  const auto refuse = [](const std::string& what, const char* remedy = "take map auto or body") {
    throw std::invalid_argument(
        "map paper divides the four equations of the source paper's vehicle among four threads; " + what + "; " +
        remedy);
  };
  if (set.equations().size() != 4) {
    refuse("here are " + plural(static_cast<int>(set.equations().size()), "equation", "equations"));
  }
  if (threads != 4) refuse("here are " + plural(threads, "thread", "threads"), "take 4, or map auto or body");
  Shares shares;
  for (const char* number : {"(5)", "(2)", "(3)", "(4)"}) {
    const auto found = std::find_if(set.equations().begin(), set.equations().end(), [&](const Equation& equation) {
      return equation.name.find(number) != std::string::npos;
    });
    if (found == set.equations().end()) refuse("here no equation is named " + std::string(number));
    shares.push_back({static_cast<int>(found - set.equations().begin())});
  }
  // The thread of the rail hands its rows on with its state, so every other must await it.
  const EquationGraph graph(set);
  if (graph.neighbours(shares[kRailThread].front()).size() != 3) refuse("here the bounce does not join all others");
  return shares;
}

/// The body of an equation: what stands before its motion, in "carbody bounce (2)" and in "coach_3.carbody.z".
std::string bodyOf(const std::string& equation) {
  const std::size_t blank = equation.find(' ');
  return equation.substr(0, blank != std::string::npos ? blank : equation.rfind('.'));
}

Shares bodyShares(const EquationSet& set, int threads, const std::vector<double>& cost) {
  std::vector<std::string> names;
  Shares bodies;
  std::vector<double> weight;
  for (int e = 0; e < static_cast<int>(set.equations().size()); ++e) {
    const std::string body = bodyOf(set.equations()[at(e)].name);
    // Along a train the body is near the end of the list.
    const auto found = std::find(names.rbegin(), names.rend(), body);
    const auto index = static_cast<std::size_t>(names.rend() - found) - (found == names.rend() ? 0 : 1);
    if (found == names.rend()) {
      names.push_back(body);
      bodies.emplace_back();
      weight.push_back(0.0);
      bodies.back().push_back(e);
      weight.back() += cost[at(e)];
      continue;
    }
    bodies[index].push_back(e);
    weight[index] += cost[at(e)];
  }
  const int count = static_cast<int>(bodies.size());
  if (threads > count) refuseThreads(EquationMap::kBody, threads, count, "body", "bodies");
  Shares shares(at(threads));
  int begin = 0;
  std::size_t thread = 0;
  for (const int end : lightestRuns(weight, std::vector<double>(weight.size() + 1, 0.0), threads)) {
    for (; begin < end; ++begin) {
      shares[thread].insert(shares[thread].end(), bodies[at(begin)].begin(), bodies[at(begin)].end());
    }
    std::sort(shares[thread].begin(), shares[thread].end());
    ++thread;
  }
  return shares;
}

// A chain reads others near it only, beside its length.
bool isChain(const EquationGraph& graph) {
  int widest = 0;
  for (int e = 0; e < graph.size(); ++e) widest = std::max(widest, graph.highest(e) - graph.lowest(e));
  return 2 * widest <= graph.size();
}

Shares autoShares(const EquationGraph& graph, int threads, const std::vector<double>& cost) {
  if (!isChain(graph)) return bisected(graph, cost, threads);
  // cut[p]: values that cross a border before equation p, a reader and a read equation counting once each way.
  std::vector<double> cut(cost.size() + 1, 0.0);
  for (int e = 0; e < graph.size(); ++e) {
    for (int p = graph.lowest(e) + 1; p <= e; ++p) cut[at(p)] += 1.0;
    for (int p = e + 1; p <= graph.highest(e); ++p) cut[at(p)] += 1.0;
  }
  Shares shares;
  int begin = 0;
  for (const int end : lightestRuns(cost, cut, threads)) {
    std::vector<int> share(at(end - begin));
    std::iota(share.begin(), share.end(), begin);
    shares.push_back(std::move(share));
    begin = end;
  }
  return shares;
}

}  // namespace

std::vector<std::vector<int>> shareEquations(const EquationSet& set, EquationMap map, int threads,
                                             std::span<const double> cost) {
  const int equations = static_cast<int>(set.equations().size());
  if (threads < 1) {
    throw std::invalid_argument("equation map: threads = " + std::to_string(threads) + ", must be >= 1");
  }
  if (map == EquationMap::kPaper) return paperShares(set, threads);
  const std::vector<double> costs = costsOf(set, cost);
  if (map == EquationMap::kBody) return bodyShares(set, threads, costs);
  if (threads > equations) refuseThreads(map, threads, equations, "equation", "equations");
  return autoShares(EquationGraph(set), threads, costs);
}

}  // namespace vehicle
