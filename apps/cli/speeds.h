#pragma once

#include <string>
#include <vector>

#include "apps/cli/cli11.h"

namespace vehicle::cli {

/// --speed of a command that runs at each of several speeds: "72 km/h", a list "60 km/h, 80 km/h", a range
/// "80:10:160 km/h" (from : step : to, the last at or below to), or both in one list.
/// @param speeds  [m/s] where they go, in the order given
void addSpeeds(CLI::App& command, const std::string& help, std::vector<double>& speeds);

/// Speeds of such a text [m/s].
/// @throws std::invalid_argument  with the value, the rule and the remedy
[[nodiscard]] std::vector<double> parseSpeeds(const std::string& text);

/// "run.h5" at 80 km/h: "run-80kmh.h5".
[[nodiscard]] std::string fileAtSpeed(const std::string& file, double speed);

/// "80 km/h"
[[nodiscard]] std::string speedText(double speed);

}  // namespace vehicle::cli
