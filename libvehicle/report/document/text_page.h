#pragma once

#include <cstddef>
#include <iosfwd>

#include "libvehicle/report/document/document.h"

namespace vehicle::report {

/// Facts, tables and remarks for people, in handy units, no line longer than the page as far as its words allow.
/// @param width  [letters]
void printPage(const Document& document, std::size_t width, std::ostream& out);

}  // namespace vehicle::report
