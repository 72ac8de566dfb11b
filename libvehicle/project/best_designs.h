#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libvehicle/project/study_work.h"
#include "libvehicle/study/summary.h"

namespace vehicle {

/// What the files of the best designs are called, without ending. The names follow from the study alone, so that
/// what is there already is known before any design is evaluated. All files of all designs differ.
class BestNames {
 public:
  /// @param best  designs of each objective
  BestNames(const StudyWork& work, std::size_t best);

  /// Of a study with objectives: OBJECTIVE-RANK. @param rank  from 0
  [[nodiscard]] const std::string& ofRank(std::size_t objective, std::size_t rank) const {
    return of_objectives_[objective][rank];
  }
  /// Of one without: the named design's own name. @param design  from 1; 0 is the base
  [[nodiscard]] const std::string& ofNamed(std::size_t design) const { return of_designs_[design - 1]; }
  [[nodiscard]] std::vector<std::string> all() const;

 private:
  std::vector<std::vector<std::string>> of_objectives_;  // (objectives) (ranks)
  std::vector<std::string> of_designs_;                  // (named designs)
};

/// Every file that may be written, within the folder: NAME.xml, of a train NAME-UNIT.xml too.
[[nodiscard]] std::vector<std::string> filesOfBest(const BestNames& names, const StudyWork& work);

/// Writes the best designs of each objective as vehicle files; without objectives these are the named designs. A train
/// is written as its own file and those of its vehicles. All files are written, or none.
/// @returns the files written
/// @throws std::invalid_argument  a train's file cannot hold a design
/// @throws RunFailed              a file cannot be written
std::vector<std::string> writeBest(const std::string& folder, const StudySummary& summary, const StudyWork& work,
                                   const BestNames& names);

}  // namespace vehicle
