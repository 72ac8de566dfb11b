#pragma once

#include <string>
#include <vector>

#include "apps/cli/cli11.h"
#include "libvehicle/project/model.h"
#include "libvehicle/simulate/simulate.h"

namespace vehicle::cli {

/// --threads, --scheme and --map: how many threads share a run, and how. They change its speed and no bit of it.
/// @param default_threads  as the help names it; `choice.sharing.threads` already holds it
void addSharing(CLI::App& command, RunChoice& choice, const std::string& default_threads);

/// --waiting, --pinning and --priority: what a team of threads asks of the scheduler.
void addTeam(CLI::App& command, TeamPolicy& team);

// Options of a run that would have no effect beside the others and the files given are refused, each with the reason
// and what to do. All throw std::invalid_argument. `command` knows which options were given.

/// "--step has no effect: WHY; REMEDY"
[[noreturn]] void refuseWithoutEffect(const std::string& option, const std::string& why, const std::string& remedy);

/// Of one run: step, tolerances, speed, and how threads share it.
void requireRunOptionsUsed(const CLI::App& command, const RunChoice& choice, const Model& model);

/// --step, --rtol, --atol and --accuracy for runs by these methods.
/// @param methods  all that will run
/// @param why      the methods in words: "the method exact"
void requireSettingsUsed(const CLI::App& command, const std::vector<std::string>& methods, const std::string& why);

/// --speed, which a rig that lasts a time does not need.
/// @param scenarios  all that will be run
void requireSpeedUsed(const CLI::App& command, const std::vector<Scenario>& scenarios);

/// --scheme and --map for a run on so many threads.
void requireSharingUsed(const CLI::App& command, const RunChoice& choice);

/// Options that only a run on several threads reads, where it is known to have one.
void requireThreadsFor(const CLI::App& command, const std::vector<std::string>& options, const RunChoice& choice);

}  // namespace vehicle::cli
