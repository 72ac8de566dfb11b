#include "libvehicle/storage/csv.h"

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/storage/csv_text.h"
#include "libvehicle/storage/csv_writer.h"
#include "libvehicle/storage/read_file.h"
#include "libvehicle/storage/run_record.h"

namespace vehicle {

namespace {

constexpr const char* kExample = "a header reads e.g. \"time [s],carbody.z [m]\"";

// Of a header that could be read.
void requireTimeFirst(const std::vector<Channel>& columns, const std::string& file, ProblemList& problems) {
  if (columns.empty() || columns.front().name.empty() || columns.front() == Channel{"time", "s"}) return;
  problems.add(
      {file, 1}, "",
      fmt::format("the first column is \"{} [{}]\", must be \"time [s]\"", columns.front().name, columns.front().unit),
      kExample);
}

// Fills `row` from a line; adds a problem where that is impossible.
void readRow(std::string_view line, const Place& place, const std::vector<Channel>& columns, std::vector<double>& row,
             ProblemList& problems) {
  row.clear();
  std::size_t fields = 0;
  for (bool more = true; more; ++fields) {
    const std::size_t comma = line.find(',');
    const std::string_view field = line.substr(0, comma);
    more = comma != std::string_view::npos;
    line.remove_prefix(more ? comma + 1 : line.size());
    if (fields >= columns.size()) continue;
    double value = 0.0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value)) {
      problems.add(place, "", fmt::format("column \"{}\": \"{}\" is no finite number", columns[fields].name, field),
                   "");
      return;
    }
    row.push_back(value);
  }
  if (fields != columns.size()) {
    problems.add(place, "", fmt::format("the row has {} fields, the header {}", fields, columns.size()), "");
  }
}

}  // namespace

void writeCsv(const TimeHistory& history, const std::filesystem::path& path) {
  requireStorable(history);
  CsvWriter(path).writeAll(history, {});
}

Outcome<TimeHistory> readCsv(const std::filesystem::path& path) {
  Outcome<TimeHistory> outcome;
  const Outcome<std::string> bytes = readFile(path);
  outcome.problems = bytes.problems;
  if (!bytes.ok()) return outcome;

  std::string_view rest = *bytes.value;
  const std::string file = path.string();
  const std::vector<Channel> columns = takeHeader(rest, file, kExample, outcome.problems);
  requireTimeFirst(columns, file, outcome.problems);
  if (!outcome.problems.empty()) return outcome;

  TimeHistory history(std::vector<Channel>(columns.begin() + 1, columns.end()));
  std::vector<double> row;
  for (int line = 2; !rest.empty() && outcome.problems.size() < kMostCsvProblems; ++line) {
    const Place place{file, line};
    readRow(takeLine(rest), place, columns, row, outcome.problems);
    if (!outcome.problems.empty()) continue;
    std::copy(row.begin(), row.end(), history.append(row[0]).begin());
  }
  if (outcome.problems.empty()) outcome.value = std::move(history);
  return outcome;
}

}  // namespace vehicle
