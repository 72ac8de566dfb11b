#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/architecture/house.h"

namespace vehicle::test {

// What the benchmark programs have measured: benchmarks/results/MACHINE/bench_NAME.csv.

/// The results of one machine, or of several that each were measured by some of the programs.
class Results {
 public:
  /// @param folders  hold bench_NAME.csv files; of a NAME in several the first counts
  explicit Results(const std::vector<std::filesystem::path>& folders);

  /// The value of "NAME:KEY:KEY...", the row of bench_NAME.csv that begins with these keys; its nanoseconds
  /// (ns_per_step, else median_ns). "...@COLUMN" names another column, "...#2" the second of several such rows.
  /// @throws std::invalid_argument  there is no such row or column, or several rows begin so
  [[nodiscard]] double at(std::string_view reference) const;

 private:
  using Row = std::vector<std::string>;
  std::map<std::string, std::vector<Row>> tables_;  // by NAME, header first
};

/// Value of an expression over results: REFERENCE, or FACTOR * REFERENCE, or the quotient of two of these, " / "
/// between them. A unit at the end divides nanoseconds: us, ms, s; % multiplies by 100.
[[nodiscard]] double valueOf(std::string_view expression, const Results& results);

/// Rows of results that do not name their commit, or name one of a tree that was modified: nobody could measure it
/// again.
[[nodiscard]] Violations untraceableResults(const std::filesystem::path& root);

}  // namespace vehicle::test
