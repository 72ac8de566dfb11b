#pragma once

#include <filesystem>

#include "tests/architecture/house.h"

namespace vehicle::test {

// The pages are README.md, CHANGELOG.md and every .md file under docs/.

/// Links of pages whose file does not exist or lies outside the tree, or whose #heading is none of the page linked to.
/// What stands in code (fences, backticks) is no link; links to other sites are not followed.
[[nodiscard]] Violations deadLinks(const std::filesystem::path& root);

/// Paths that pages and C++ files name and that do not exist: words of a page, code included, that begin with a folder
/// of the top ("models/vehicles/coach.xml") or, in backticks, with a room ("`xml/reader.h`"); in comments under
/// libvehicle/ and apps/ words that begin with "docs/". A `*`, a `<` or `...` makes a word a pattern, not a path.
[[nodiscard]] Violations pathsToNothing(const std::filesystem::path& root);

/// Pages under docs/ that no chain of links leads to from README.md.
[[nodiscard]] Violations lonelyPages(const std::filesystem::path& root);

}  // namespace vehicle::test
