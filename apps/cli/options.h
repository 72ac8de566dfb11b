#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/cli11.h"
#include "apps/cli/document.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/units/quantity.h"

namespace vehicle::cli {

/// What every command takes: --format, --quiet and --strict.
struct CommonOptions {
  Format format = Format::kTable;
  bool quiet = false;   // no progress, no notes
  bool strict = false;  // a warning makes exit status 4
};
void addCommonOptions(CLI::App& command, CommonOptions& options);

/// An option with a unit; the message of a wrong one names the dimension expected and an example.
/// @param store  called with the value in SI, which is finite and > 0
CLI::Option* addQuantity(CLI::App& command, const std::string& name, Dimension dimension, const std::string& help,
                         std::function<void(double)> store);

/// A whole number; the message of a wrong one names the range.
/// @param most  1..most are right
CLI::Option* addCount(CLI::App& command, const std::string& name, int& count, const std::string& help,
                      int most = 1'000'000);

/// Speed, step and tolerances of a run, as far as the methods read them.
void addRunSettings(CLI::App& command, RunChoice& choice);

/// One name of a list; a wrong one gets the nearest right one named.
CLI::Validator oneOf(const std::vector<std::string>& names);

/// Flags too: whoever gives an option twice means two things by it.
/// @throws CLI::ParseError
void requireGivenOnce(const CLI::App& command);

/// What is wrong with the command line, in one line, with the nearest right option or command.
[[nodiscard]] std::string explain(const CLI::App& program, const CLI::ParseError& error);

}  // namespace vehicle::cli
