#pragma once

#include <cstddef>
#include <iosfwd>

#include "libvehicle/report/document/document.h"

namespace vehicle::report {

/// Prints a table as aligned columns below its name. Where it is wider than the page: headers are broken; then the
/// columns stand in blocks below each other, each behind the key columns; a text that is too wide for a block is wrapped
/// between its words. A line is longer than the page only where one column behind the keys cannot be made narrower.
/// @param width  [letters]
void printTable(const Table& table, std::size_t width, std::ostream& out);

}  // namespace vehicle::report
