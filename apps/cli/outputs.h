#pragma once

#include <string>
#include <vector>

#include "apps/cli/cli11.h"
#include "apps/cli/model_options.h"
#include "libvehicle/storage/output_guard.h"

namespace vehicle::cli {

/// --overwrite, which a command with outputs takes.
/// @param more  what it does beside replacing files, after the sentence of the help
void addOverwrite(CLI::App& command, Overwrite& overwrite, const std::string& more = "");

/// --overwrite without any of the outputs that it is about.
/// @param outputs  the options of the command that name files to write
/// @throws std::invalid_argument
void requireOutputForOverwrite(const CLI::App& command, const std::vector<std::string>& outputs);

/// Every file that the model was read from.
void protectModel(OutputGuard& guard, const Model& model);

}  // namespace vehicle::cli
