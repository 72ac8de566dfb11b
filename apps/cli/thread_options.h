#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "apps/cli/document.h"
#include "apps/cli/options.h"
#include "libvehicle/simulate/simulate.h"

namespace vehicle::cli {

/// --threads, --scheme and --map: how many threads share a run, and how. They change its speed and no bit of it.
/// @param default_threads  as the help tells it; `choice.sharing.threads` already holds it
void addSharing(CLI::App& command, RunChoice& choice, const std::string& default_threads);

/// --waiting, --pinning and --priority: what a team of threads asks of the scheduler.
void addTeam(CLI::App& command, TeamPolicy& team);

/// How a run was shared: scheme and threads; where that was left open, the reason for the choice too.
[[nodiscard]] std::vector<Fact> sharingFacts(const RunResult& result);

/// Says why --threads auto left a run on one thread that no other could share.
void noteUnshared(const RunChoice& choice, const RunResult& result, const CommonOptions& common);

/// What --threads auto weighed: each way with the time of a step that was predicted and measured; without rows where
/// nothing was left open.
[[nodiscard]] Table decisionTable(const Decision& decision);

}  // namespace vehicle::cli
