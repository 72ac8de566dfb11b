#pragma once

#include <string>
#include <vector>

#include "apps/cli/model_options.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/storage/history_file.h"

namespace vehicle::cli {

/// Asks before the run what would be in vain after it: the extension, and whether the file can be written.
/// @throws std::invalid_argument  another extension than .csv and .h5, or a file named twice
/// @throws RunFailed              the folder is missing or may not be written
void requireWritable(const std::vector<std::string>& outputs);

/// The run with everything needed to repeat it: version, names, settings, statistics, input files as they were read.
[[nodiscard]] RunRecord recordOf(const Model& model, const RunChoice& choice, const RunResult& result);

}  // namespace vehicle::cli
