#pragma once

#include <string>
#include <vector>

#include "libvehicle/project/model.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/storage/history_writer.h"

namespace vehicle {

/// Where the histories of a run go.
struct RunOutputs {
  std::vector<std::string> files;  // .csv, .h5; none: no history is kept
  std::string version;             // of the program, kept with each
};

/// Everything needed to repeat the run: version, names, settings, statistics, input files as they were read.
[[nodiscard]] RunDescription descriptionOf(const Model& model, const RunChoice& choice, const RunResult& result,
                                           const std::string& version);

/// Simulates and writes the histories as the run goes; they appear when it has ended, one that was ended early too, and
/// not where it failed. Of the result's history the columns alone are kept.
/// @param choice    of this run; what it says of the history to keep is not read
/// @param progress  of the share done, 0..1; false ends the run
/// @throws as simulate(); RunFailed if a file cannot be written
[[nodiscard]] RunResult simulateAndStore(const Model& model, RunChoice choice, const RunOutputs& outputs,
                                         const Progress& progress = {});

/// Runs at each of several speeds, one after the other; a run that is ended early is the last.
/// @param choice   of all runs, but for the speed   @param speeds  [m/s]
/// @param outputs  files of all runs, each written by its name at the speed: fileAtSpeed()
/// @param progress  of the share of all runs that is done, 0..1; false ends them
/// @throws InvalidInput  before the first run if one of them cannot be; else as simulateAndStore()
[[nodiscard]] std::vector<RunResult> simulateSpeeds(const Model& model, const RunChoice& choice,
                                                    const std::vector<double>& speeds, const RunOutputs& outputs,
                                                    const Progress& progress = {});

}  // namespace vehicle
