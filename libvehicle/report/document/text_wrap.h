#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace vehicle::report {

/// The width of a page whose lines may be of any length.
inline constexpr std::size_t kAnyWidth = std::numeric_limits<std::size_t>::max();

/// Letters as a terminal counts them: bytes that do not continue a UTF-8 sequence.
[[nodiscard]] std::size_t lettersOf(const std::string& text);

[[nodiscard]] std::string trimmed(std::string line);

/// Pieces put together to lines of at most `width` letters, blanks at their ends removed. A longer piece has a line of
/// its own: nothing is cut. No piece at all makes one empty line.
[[nodiscard]] std::vector<std::string> linesOf(const std::vector<std::string>& pieces, std::size_t width);

/// The words of a text, each with the blanks that follow it.
[[nodiscard]] std::vector<std::string> wordsOf(const std::string& text);

/// A name or header where it may be broken: "secondary_front." "deflection." "rms " "@ 80 km/h " "[mm]". Speeds and what
/// stands in brackets stay whole.
[[nodiscard]] std::vector<std::string> partsOfName(const std::string& name);

/// The text with line breaks between words, so that its lines have at most `width` letters; all lines but the first
/// begin with `indent` blanks, the first is thought to stand there already. Line breaks of the text remain.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t width, std::size_t indent = 0);

/// Sentences as wide as the page; command lines ("Example: ", indented, or going on with a backslash) as they are, to be
/// copied. Each line ends with a line break.
[[nodiscard]] std::string wrappedPage(const std::string& text, std::size_t width);

/// Lines of two columns, each indented by two blanks; what of the right one does not fit stands below its beginning.
[[nodiscard]] std::string twoColumns(const std::vector<std::pair<std::string, std::string>>& lines, std::size_t width);

}  // namespace vehicle::report
