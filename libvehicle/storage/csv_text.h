#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/units/channel.h"

namespace vehicle {

// Comma-separated text (RFC 4180), the pieces that every table of ours is read and written with.

/// Appends a field; only a text that needs it is quoted: a comma in a name would shift every later column.
void appendField(std::string& line, std::string_view text);
/// Appends the shortest text that reads back to the same bits.
void appendNumber(std::string& line, double value);

/// Cuts the next line off `rest`, without its end (LF, CR LF, or CR alone).
[[nodiscard]] std::string_view takeLine(std::string_view& rest);
/// Fields of a line, quotes removed; nothing if a quote stays open.
[[nodiscard]] std::optional<std::vector<std::string>> splitFields(std::string_view line);

/// Without the blanks about it, which people type after commas.
[[nodiscard]] std::string_view trimmed(std::string_view field);

/// "carbody.z [m]" taken apart, blanks about it left out; nothing if there is no name or no unit in brackets. A plain
/// number has "[]".
[[nodiscard]] std::optional<Channel> channelOf(std::string_view field);

/// Most problems that are told of one file.
inline constexpr std::size_t kMostCsvProblems = 20;

/// Cuts the header off a table: "time [s],carbody.z [m]". A byte-order mark before it is skipped.
/// Problems, at most kMostCsvProblems: a quote that stays open, a field without name and unit, a name that stands there
/// twice.
/// @param file     what messages call the text
/// @param example  remedy of a field that cannot be read: a header as it should be
/// @returns one channel a field; empty ones where they cannot be read
[[nodiscard]] std::vector<Channel> takeHeader(std::string_view& rest, const std::string& file,
                                              const std::string& example, ProblemList& problems);

}  // namespace vehicle
