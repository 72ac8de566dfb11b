#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/storage/output_guard.h"

namespace vehicle::cli {

/// What `simulate` was asked for.
struct SimulateOptions {
  ModelFiles files;
  RunChoice choice;
  std::vector<double> speeds;  // [m/s]; empty: the scenario's
  std::vector<std::string> outputs;
  Overwrite overwrite = Overwrite::kOwnFiles;
  CommonOptions common;
};

/// Simulates and writes the histories.
/// @param choice  of this run, its speed included   @param outputs  of this run
/// @param progress  of the share done, 0..1; false ends the run
[[nodiscard]] RunResult runAndStore(const Model& model, RunChoice choice, const std::vector<std::string>& outputs,
                                    const Progress& progress);

/// Names of the histories of a run at one of several speeds.
[[nodiscard]] std::vector<std::string> outputsAt(const SimulateOptions& options, double speed);

/// Runs at each speed: a line for every run, and one table of all columns by speed.
/// @return exit status
/// @throws InvalidInput  before the first run if one of them cannot be
[[nodiscard]] int simulateSpeeds(const SimulateOptions& options, const Model& model);

}  // namespace vehicle::cli
