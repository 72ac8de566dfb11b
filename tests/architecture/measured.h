#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tests/architecture/house.h"

namespace vehicle::test {

// Numbers that were measured stand in benchmarks/results/MACHINE/bench_NAME.csv; pages print some of them. The file
// benchmarks/results/printed_numbers.txt says which: the words of the page with the rows of results in braces in place
// of the numbers. So every printed number can be traced, and a test holds the pages against the results.

/// A number as a page prints it ("8 017", "0.27"): its value, and the half unit of its last digit. Zeros at the end of
/// a whole number count as digits up to the third only.
struct PrintedNumber {
  double value = 0.0;
  double half_unit = 0.0;
};
[[nodiscard]] PrintedNumber printedNumber(std::string_view text);
/// A value with as many digits as `like` has, at least two, in the same style.
[[nodiscard]] std::string printedLike(std::string_view like, double value);

enum class Pages {
  kJudge,
  kCorrect  // numbers that differ are written anew
};
/// Printed numbers that are not those of the results, templates whose words no page has, and rows of the tables under
/// the headings that the file claims to cover which no template covers.
[[nodiscard]] Violations wrongNumbers(const std::filesystem::path& root, Pages pages);

}  // namespace vehicle::test
