#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vehicle {

/// One line in which two texts differ.
struct LineChange {
  std::size_t line = 0;            // in the new text, from 1; for a line that is gone, where it would stand
  std::optional<std::string> was;  // nothing: the line is new
  std::optional<std::string> is;   // nothing: the line is gone
};

/// The lines in which `now` differs from `before`, by a longest common subsequence of lines; lines that were replaced
/// come as pairs. Texts of very many changed lines (a thousand times a thousand) are compared line by line instead.
[[nodiscard]] std::vector<LineChange> lineDiff(std::string_view before, std::string_view now);

}  // namespace vehicle
