#include "libvehicle/study/search/search.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/algorithms/nspso.hpp>
#include <pagmo/bfe.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

namespace vehicle {

namespace {

// Thrown through pagmo, which lets it pass, when the caller has had enough.
struct SearchStopped {};

// All objectives of a point that oversteps limits: above those of every point that keeps them. Relative violations from
// 1e-15 up stay apart in a double.
constexpr double kOverstepped = 1e30;
constexpr double kNoResults = 1e60;

double penalised(double violation) {
  return std::isfinite(violation) ? std::min(kOverstepped * (1.0 + violation), 1e-3 * kNoResults) : kNoResults;
}

/// The caller's function, counting generations. pagmo copies what it is given; all copies look at this one.
class Generations {
 public:
  Generations(const EvaluateGeneration& evaluate, std::size_t objectives)
      : evaluate_(evaluate), objectives_(objectives) {}

  std::vector<double> next(std::span<const double> points, std::size_t variables) {
    const std::size_t count = points.size() / variables;
    std::vector<double> values(count * objectives_);
    std::vector<double> violations(count);
    if (!evaluate_(generation_++, points, {values, violations})) throw SearchStopped{};
    for (std::size_t i = 0; i < count; ++i) {
      if (violations[i] == 0.0) continue;
      std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(i * objectives_), objectives_, penalised(violations[i]));
    }
    return values;
  }

 private:
  const EvaluateGeneration& evaluate_;
  std::size_t objectives_;
  int generation_ = 0;
};

// What pagmo calls a user-defined problem.
struct BoundedProblem {
  std::vector<double> low;
  std::vector<double> high;
  std::size_t objectives = 2;
  Generations* generations = nullptr;

  [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& point) const {
    return generations->next(point, low.size());
  }
  [[nodiscard]] pagmo::vector_double::size_type get_nobj() const { return objectives; }
  [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const { return {low, high}; }
};

// And its batch evaluator: whole generations in one call.
struct WholeGeneration {
  Generations* generations = nullptr;

  pagmo::vector_double operator()(const pagmo::problem& problem, const pagmo::vector_double& points) const {
    return generations->next(points, problem.get_nx());
  }
};

void checkArguments(const Search& settings, const SearchBounds& bounds, std::size_t objectives) {
  if (bounds.low.empty() || bounds.low.size() != bounds.high.size()) {
    throw std::invalid_argument("search: " + std::to_string(bounds.low.size()) + " lower and " +
                                std::to_string(bounds.high.size()) + " upper bounds, must be one of each a variable");
  }
  for (std::size_t i = 0; i < bounds.low.size(); ++i) {
    if (std::isfinite(bounds.low[i]) && std::isfinite(bounds.high[i]) && bounds.low[i] < bounds.high[i]) continue;
    throw std::invalid_argument("search: variable " + std::to_string(i) + " from " + std::to_string(bounds.low[i]) +
                                " to " + std::to_string(bounds.high[i]) + ", must be finite and rising");
  }
  if (objectives < 2) {
    throw std::invalid_argument("search: " + std::to_string(objectives) +
                                " objectives, must be at least 2: a front has two sides");
  }
  const bool nsga2 = settings.method == SearchMethod::kNsga2;
  const bool fits = nsga2 ? settings.population >= 8 && settings.population % 4 == 0 : settings.population >= 4;
  if (!fits) {
    throw std::invalid_argument("search: population = " + std::to_string(settings.population) +
                                (nsga2 ? ", must be a multiple of 4, at least 8" : ", must be at least 4"));
  }
  if (settings.generations < 1) {
    throw std::invalid_argument("search: generations = " + std::to_string(settings.generations) + ", must be >= 1");
  }
}

}  // namespace

bool search(const Search& settings, const SearchBounds& bounds, std::size_t objectives,
            const EvaluateGeneration& evaluate) {
  checkArguments(settings, bounds, objectives);
  Generations generations(evaluate, objectives);
  const pagmo::bfe batch{WholeGeneration{&generations}};
  const auto seed = static_cast<unsigned>(settings.seed);
  const auto count = static_cast<unsigned>(settings.generations);
  try {
    pagmo::population start(pagmo::problem(BoundedProblem{bounds.low, bounds.high, objectives, &generations}), batch,
                            static_cast<pagmo::population::size_type>(settings.population), seed);
    if (settings.method == SearchMethod::kNsga2) {
      pagmo::nsga2 method(count, 0.95, 10.0, 0.01, 50.0, seed);  // pagmo's own defaults, but for the seed
      method.set_bfe(batch);
      (void)method.evolve(std::move(start));
    } else {
      pagmo::nspso method(count, 0.6, 2.0, 2.0, 1.0, 0.5, 2, "crowding distance", false, seed);  // as above
      method.set_bfe(batch);
      (void)method.evolve(std::move(start));
    }
  } catch (const SearchStopped&) {
    return false;
  }
  return true;
}

}  // namespace vehicle
