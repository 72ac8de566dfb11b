#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/report/document/document.h"

namespace vehicle::report {

/// Warnings for csv and json: {code, file, line, subject, value, unit, time, message}; no rows without warnings.
[[nodiscard]] Table warningTable(const Warnings& warnings);

/// Warnings for people, one line each; of many of one code the first kMostOfACode and how many more.
inline constexpr std::size_t kMostOfACode = 4;
[[nodiscard]] std::vector<std::string> warningLines(const Warnings& warnings);

}  // namespace vehicle::report
