#pragma once

#include "apps/cli/cli11.h"
#include "apps/cli/options.h"
#include "libvehicle/project/suite_work.h"

namespace vehicle::cli {

/// One case, or all of a suite.
struct ValidationWork {
  SuiteWork cases;
  bool is_suite = false;
  /// A suite, or one vehicle and scenario at several speeds: one line for each case.
  [[nodiscard]] bool hasSeveral() const { return is_suite || cases.cases.size() > 1; }
};

/// Options of `validate` that would have no effect beside the others and the files given are refused: settings that no
/// method reads, --speed on rigs, what is about shared runs where none is, --details where all is printed or nothing
/// more is; and a form or method that is named twice.
/// @param given  what the command line says, without the suite's forms and methods
/// @throws std::invalid_argument  with the reason and what to do
void requireValidationOptionsUsed(const CLI::App& command, const ValidationWork& work, const ValidationChoice& given,
                                  const CommonOptions& common);

}  // namespace vehicle::cli
