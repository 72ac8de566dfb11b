#include "libvehicle/partition/map/bisection.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Some equations on two sides, which shall carry the costs in the ratio of the parts each is cut into later.
class Bisection {
 public:
  Bisection(const EquationGraph& graph, const std::vector<double>& cost, std::vector<int> equations, int left_parts,
            int right_parts)
      : graph_(graph),
        cost_(cost),
        equations_(std::move(equations)),
        parts_{left_parts, right_parts},
        side_(cost.size(), -1) {
    double total = 0.0;
    for (const int e : equations_) total += cost_[at(e)];
    const double share = total * left_parts / (left_parts + right_parts);
    double left = 0.0;
    const int count = static_cast<int>(equations_.size());
    for (int i = 0; i < count; ++i) {
      const int e = equations_[at(i)];
      const bool must_left = i < left_parts;
      const bool must_right = count - i <= right_parts;
      const bool is_left = must_left || (!must_right && left + 0.5 * cost_[at(e)] <= share);
      side_[at(e)] = is_left ? 0 : 1;
      left += is_left ? cost_[at(e)] : 0.0;
    }
  }

  void better() {
    // Each round lowers (heaviest side, neighbours across), of which there are finitely many.
    while (moveOne() || exchangeTwo()) {
    }
  }

  std::vector<int> side(int which) const {
    std::vector<int> chosen;
    for (const int e : equations_) {
      if (side_[at(e)] == which) chosen.push_back(e);
    }
    return chosen;
  }

 private:
  // Heaviest side per part, to a billionth so that rounding is no gain; then neighbours across.
  std::tuple<long, int> badness() const {
    double load[2] = {0.0, 0.0};
    double total = 0.0;
    int across = 0;
    for (const int e : equations_) {
      load[side_[at(e)]] += cost_[at(e)];
      total += cost_[at(e)];
      for (const int n : graph_.neighbours(e)) {
        if (n > e && side_[at(n)] >= 0 && side_[at(n)] != side_[at(e)]) ++across;
      }
    }
    const double heaviest = std::max(load[0] / parts_[0], load[1] / parts_[1]);
    return {static_cast<long>(1e9 * heaviest / total + 0.5), across};
  }

  bool keepIfBetter(const std::tuple<long, int>& before, int one, int other) {
    if (badness() < before) return true;
    std::swap(side_[at(one)], side_[at(other)]);
    return false;
  }

  bool moveOne() {
    const auto before = badness();
    for (const int e : equations_) {
      const int from = side_[at(e)];
      const auto here = std::count_if(equations_.begin(), equations_.end(),
                                      [&](int other) { return side_[at(other)] == from; });
      if (here <= parts_[from]) continue;  // every part keeps an equation
      side_[at(e)] = 1 - from;
      if (badness() < before) return true;
      side_[at(e)] = from;
    }
    return false;
  }

  bool exchangeTwo() {
    const auto before = badness();
    for (const int one : equations_) {
      for (const int other : equations_) {
        if (side_[at(one)] != 0 || side_[at(other)] != 1) continue;
        std::swap(side_[at(one)], side_[at(other)]);
        if (keepIfBetter(before, one, other)) return true;
      }
    }
    return false;
  }

  const EquationGraph& graph_;
  const std::vector<double>& cost_;
  std::vector<int> equations_;
  int parts_[2];
  std::vector<int> side_;  // 0 left, 1 right, -1 not of these equations
};

void cut(const EquationGraph& graph, const std::vector<double>& cost, std::vector<int> equations, int parts,
         std::vector<std::vector<int>>& shares) {
  if (parts == 1) {
    shares.push_back(std::move(equations));
    return;
  }
  Bisection halves(graph, cost, std::move(equations), parts / 2, parts - parts / 2);
  halves.better();
  cut(graph, cost, halves.side(0), parts / 2, shares);
  cut(graph, cost, halves.side(1), parts - parts / 2, shares);
}

}  // namespace

std::vector<std::vector<int>> bisected(const EquationGraph& graph, const std::vector<double>& cost, int parts) {
  std::vector<int> all(cost.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::vector<int>> shares;
  cut(graph, cost, std::move(all), parts, shares);
  std::sort(shares.begin(), shares.end());
  return shares;
}

}  // namespace vehicle
