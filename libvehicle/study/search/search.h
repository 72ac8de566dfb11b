#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "libvehicle/definition/study.h"

namespace vehicle {

/// Where an optimiser may look.
struct SearchBounds {
  std::vector<double> low;   // (variables) finite
  std::vector<double> high;  // (variables) > low
};

/// What an optimiser learns of the points of one generation.
struct SearchAnswers {
  std::span<double> objectives;  // (points x objectives), row-major; all are minimised
  /// (points) by how much limits are overstepped in all, relative to them; 0 where all are kept, infinity for a point
  /// that has no results. Its objectives do not count then.
  std::span<double> violations;
};

/// Evaluates one generation: points (points x variables), row-major, each within the bounds. Generation 0 is the random
/// start. Returning false ends the search.
using EvaluateGeneration = std::function<bool(int generation, std::span<const double> points, SearchAnswers answers)>;

/// Looks for the points that no other dominates, by pagmo's NSGA-II or NSPSO.
///
/// Points that keep the limits dominate those that do not, and of two that do not the one that oversteps less wins
/// (constrained domination after Deb): pagmo is given the same very large number for all objectives of such a point,
/// rising with the violation. Every point goes through `evaluate`, whole generations at a time, (generations + 1) of
/// them with `population` points each; the same seed gives the same points, whatever `evaluate` runs on.
/// Source: K. Deb et al., IEEE Trans. Evol. Comput. 6 (2002) 182-197 (NSGA-II, constrained domination);
/// X. Li, GECCO 2003, LNCS 2723, 37-48 (NSPSO).
/// @param objectives  number of them, >= 2
/// @returns whether it went to its end; false: `evaluate` ended it
/// @throws std::invalid_argument  for bounds without width or not finite, one objective, a population that the method
///         does not take (NSGA-II: a multiple of 4, at least 8; NSPSO: at least 4), generations < 1
bool search(const Search& settings, const SearchBounds& bounds, std::size_t objectives,
            const EvaluateGeneration& evaluate);

}  // namespace vehicle
