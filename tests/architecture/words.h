#pragma once

#include <filesystem>

#include "tests/architecture/house.h"

namespace vehicle::test {

/// Words of our own in code and pages where the field has a standard term; each with what to say instead. The glossary
/// of docs/notation.md has the terms; CHANGELOG.md speaks of the past and is not read.
[[nodiscard]] Violations privateWords(const std::filesystem::path& root);

}  // namespace vehicle::test
