#pragma once

#include <string>
#include <vector>

namespace vehicle {

/// Speeds [m/s] in the order given: of "72 km/h", of a list "60 km/h, 80 km/h", of a range "80:10:160 km/h" (from : step :
/// to, the last at or below to), or of both in one list.
/// @throws std::invalid_argument  with the value, the rule and the remedy: "\"3\" has no unit; ..."
[[nodiscard]] std::vector<double> parseSpeeds(const std::string& text);

/// "run.h5" at 80 km/h: "run-80kmh.h5".
[[nodiscard]] std::string fileAtSpeed(const std::string& file, double speed);
[[nodiscard]] std::vector<std::string> filesAtSpeed(const std::vector<std::string>& files, double speed);

/// "80 km/h"
[[nodiscard]] std::string speedText(double speed);

}  // namespace vehicle
