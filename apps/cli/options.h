#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/cli/cli11.h"
#include "apps/cli/printing.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/storage/output_guard.h"
#include "libvehicle/units/quantity.h"

namespace vehicle::cli {

void addCommonOptions(CLI::App& command, CommonOptions& options);

/// An option with a unit; the message of a wrong one names the dimension expected and an example.
/// @param store  called with the value in SI, which is finite and > 0
CLI::Option* addQuantity(CLI::App& command, const std::string& name, Dimension dimension, const std::string& help,
                         std::function<void(double)> store);

/// A whole number; the message of a wrong one names the range.
/// @param most  1..most are right
CLI::Option* addCount(CLI::App& command, const std::string& name, int& count, const std::string& help,
                      int most = 1'000'000);

/// --speed of a command that runs at each of several speeds, one after the other (project/speeds.h).
/// @param speeds  [m/s] where they go, in the order given
void addSpeeds(CLI::App& command, const std::string& help, std::vector<double>& speeds);

/// Speed, step and tolerances of a run, as far as the methods read them.
void addRunSettings(CLI::App& command, RunChoice& choice);

/// --overwrite, which a command with outputs takes.
/// @param more  what it does beside replacing files, after the sentence of the help
void addOverwrite(CLI::App& command, Overwrite& overwrite, const std::string& more = "");

/// --overwrite without any of the outputs that it is about.
/// @param outputs  the options of the command that name files to write
/// @throws std::invalid_argument
void requireOutputForOverwrite(const CLI::App& command, const std::vector<std::string>& outputs);

/// One name of a list; a wrong one gets the nearest right one named.
CLI::Validator oneOf(const std::vector<std::string>& names);

/// Flags too: whoever gives an option twice means two things by it.
/// @throws CLI::ParseError
void requireGivenOnce(const CLI::App& command);

/// What is wrong with the command line, in one line, with the nearest right option or command.
[[nodiscard]] std::string explain(const CLI::App& program, const CLI::ParseError& error);

}  // namespace vehicle::cli
