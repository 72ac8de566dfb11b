#pragma once

#include <cstddef>

#include "apps/cli/document.h"

namespace vehicle::cli {

/// Letters in a line of what people read on stdout: COLUMNS where the environment has a whole number > 0, else the width
/// of the terminal, else kAnyWidth: what goes to a file or a pipe is never broken.
[[nodiscard]] std::size_t pageWidth();

/// print() as wide as the page.
void printToStdout(const Document& document, Format format);

}  // namespace vehicle::cli
