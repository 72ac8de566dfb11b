#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

/// The most bytes that a file may have: hundreds of times the largest vehicle, and read in a moment.
inline constexpr std::size_t kMostBytes = std::size_t{1} << 20;

/// The most problems that are told of one file; one more line says that there are others.
inline constexpr std::size_t kMostProblems = 200;

/// That one line.
[[nodiscard]] Problem tooMany(const Place& place);

/// A text that an XML library may read; `text` is empty where there are problems.
struct GuardedText {
  std::string text;  // with spaces instead of what is ignored, so that lines stay where they are
  ProblemList problems;
};

/// Judges the text before any XML library sees it: size, UTF-8, no control characters, and the form of its
/// markup (markup_guard.h). An XML library would expand, skip or repair much of this without a word, and
/// differently from the next library.
[[nodiscard]] GuardedText guardText(std::string_view text, const std::string& file_name);

/// The characters of XML 1.0, section 2.2.
[[nodiscard]] bool isXmlCharacter(std::uint32_t code);

}  // namespace vehicle
