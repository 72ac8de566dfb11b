#pragma once

#include "libvehicle/project/suite_work.h"

namespace vehicle {

/// Forms and methods that do not exist, with the nearest one that does.
[[nodiscard]] ProblemList checkNames(const Suite& suite);

/// What `validate` would refuse of the cases of a suite whose files and names are in order; each problem once, however
/// many cases have it.
[[nodiscard]] ProblemList checkCases(const SuiteWork& work);

}  // namespace vehicle
