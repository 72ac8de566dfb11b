#pragma once

#include <string>

namespace vehicle::report {

/// A word of a command line that is shown to be copied, as a shell takes it: in quotes where it needs them.
[[nodiscard]] std::string shellWord(const std::string& word);

}  // namespace vehicle::report
