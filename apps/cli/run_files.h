#pragma once

#include <string>
#include <vector>

#include "apps/cli/model_options.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/storage/history_file.h"

namespace vehicle::cli {

/// The run with everything needed to repeat it: version, names, settings, statistics, input files as they were read.
[[nodiscard]] RunRecord recordOf(const Model& model, const RunChoice& choice, const RunResult& result);

}  // namespace vehicle::cli
