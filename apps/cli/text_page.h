#pragma once

#include <cstddef>
#include <iosfwd>

#include "apps/cli/document.h"

namespace vehicle::cli {

/// Facts, tables and remarks for people, in handy units, no line longer than the page as far as its words allow.
/// @param width  [letters]
void printPage(const Document& document, std::size_t width, std::ostream& out);

}  // namespace vehicle::cli
