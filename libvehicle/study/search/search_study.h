#pragma once

#include <cstdint>
#include <string>

#include "libvehicle/study/plan/design_plan.h"
#include "libvehicle/study/runner.h"

namespace vehicle {

/// The designs of a study with a <search> by their numbers: first those that the plan tells (base, named designs), then
/// the points of one generation after the other. Generation 0 is the random start.
class SearchNumbers {
 public:
  SearchNumbers(const DesignPlan& plan, const Search& settings)
      : told_(plan.size()),
        population_(static_cast<std::uint64_t>(settings.population)),
        generations_(static_cast<std::uint64_t>(settings.generations) + 1) {}

  [[nodiscard]] std::uint64_t size() const { return told_ + generations_ * population_; }
  [[nodiscard]] std::uint64_t told() const { return told_; }
  [[nodiscard]] std::uint64_t firstOf(int generation) const {
    return told_ + static_cast<std::uint64_t>(generation) * population_;
  }
  /// "generation 3 #12"; @param design  >= told()
  [[nodiscard]] std::string nameOf(std::uint64_t design) const;

 private:
  std::uint64_t told_;
  std::uint64_t population_;
  std::uint64_t generations_;
};

/// What the database of a study with a <search> says of itself: recordOf() with the points of the search counted.
[[nodiscard]] StudyRecord searchRecordOf(const DesignPlan& plan, const Search& settings, const StudyTarget& target);

/// Runs a study with a <search>: base and named designs, then generation by generation (search.h) within the ranges of
/// its <vary>, every design kept. With `resume` the search is gone through again from its seed: what the database holds
/// is read instead of evaluated, so that the outcome is that of an uninterrupted run. A limit counts by how far it is
/// overstepped relative to its own size (absolutely where it is 0).
/// @param inputs  bound as the plan's study
/// @throws InvalidInput, RunFailed  as runStudy(); RunFailed also if the stored points are not those of this search
///         (another version of the search library has written them)
StudyOutcome searchStudy(const StudyInputs& inputs, const DesignPlan& plan, const StudyTarget& target,
                         Executor& executor, const StudyWatch& watch = {});

}  // namespace vehicle
