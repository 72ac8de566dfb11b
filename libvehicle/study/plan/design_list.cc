#include "libvehicle/study/plan/design_list.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/storage/csv_text.h"
#include "libvehicle/units/decimal.h"

namespace vehicle {

namespace {

constexpr const char* kExample = "a header reads e.g. \"secondary.stiffness_z [kN/m],carbody.mass [t]\"";

bool isNumber(std::string_view field) {
  const std::optional<Decimal> number = cutDecimal(field);
  return number && field.empty() && std::isfinite(number->nearest());
}

void reportNoNumber(const Channel& column, const std::string& field, const Place& place, ProblemList& problems) {
  problems.add(place, "", fmt::format("column \"{}\": \"{}\" is no number", column.name, field), "");
}

void checkRow(std::string_view row, const Place& place, const std::vector<Channel>& columns, ProblemList& problems) {
  const auto fields = splitFields(row);
  if (!fields || fields->size() != columns.size()) {
    problems.add(place, "",
                 fmt::format("the row has {} fields, the header {}", fields ? fields->size() : 1, columns.size()), "");
    return;
  }
  for (std::size_t i = 0; i < columns.size() && problems.size() < kMostCsvProblems; ++i) {
    const std::string field(trimmed((*fields)[i]));
    if (!isNumber(field)) reportNoNumber(columns[i], field, place, problems);
  }
}

/// The sign that separates fields instead of the comma; 0 if the header has commas, or one column.
char wrongSeparator(std::string_view text) {
  const std::string_view header = takeLine(text);
  if (header.find(',') != std::string_view::npos) return 0;
  const std::size_t found = header.find_first_of(";\t|");
  return found == std::string_view::npos ? '\0' : header[found];
}

/// Calls `visit` with every row that is not empty and the number of its line.
template <class Visit>
void forEachRow(std::string_view rest, const ProblemList& problems, Visit visit) {
  for (int line = 2; !rest.empty() && problems.size() < kMostCsvProblems; ++line) {
    const std::string_view row = takeLine(rest);
    if (!row.empty()) visit(row, line);
  }
}

}  // namespace

Outcome<ListedColumns> listedColumns(std::string_view text, const std::string& file) {
  Outcome<ListedColumns> outcome;
  ProblemList& problems = outcome.problems;
  ListedColumns& listed = outcome.value.emplace();
  listed.place = {file, 1};
  if (const char separator = wrongSeparator(text); separator != 0) {
    const std::string shown = separator == '\t' ? "a tab" : fmt::format("\"{}\"", separator);
    problems.add(listed.place, "", fmt::format("the fields are separated by {}", shown),
                 fmt::format("separate them by commas, and write decimals with a point: {}", kExample));
    return outcome;
  }
  const std::vector<Channel> header = takeHeader(text, file, kExample, problems);
  for (const Channel& each : header) {
    if (!each.name.empty()) listed.columns.push_back(each);
  }
  bool has_rows = false;
  forEachRow(text, problems, [&](std::string_view row, int line) {
    has_rows = true;
    checkRow(row, {file, line}, header, problems);
  });
  if (!has_rows && problems.empty()) {
    problems.add({file, 0}, "", "holds no design", "write one a row under the header");
  }
  return outcome;
}

Outcome<DesignList> readDesignList(std::string_view text, const std::string& file, const BoundStudy& study) {
  Outcome<DesignList> outcome;
  ProblemList& problems = outcome.problems;
  const std::vector<Channel> columns = takeHeader(text, file, kExample, problems);
  DesignList list;
  for (const Channel& column : columns) {
    const auto found = std::find_if(study.parameters.begin(), study.parameters.end(),
                                    [&](const StudyParameter& each) { return each.address == column.name; });
    if (found == study.parameters.end()) {
      throw std::invalid_argument("readDesignList: the study is not bound with the column " + column.name);
    }
    list.parameters.push_back(static_cast<std::size_t>(found - study.parameters.begin()));
  }
  forEachRow(text, problems, [&](std::string_view row, int line) {
    const auto fields = splitFields(row);
    for (std::size_t i = 0; fields && i < std::min(fields->size(), columns.size()); ++i) {
      const std::string field(trimmed((*fields)[i]));
      const Dimension dimension = study.parameters[list.parameters[i]].dimension;
      const ParsedQuantity parsed = parseQuantity(field + ' ' + columns[i].unit, dimension);
      if (parsed.si && std::isfinite(*parsed.si)) {
        list.values.push_back(*parsed.si);
      } else {
        reportNoNumber(columns[i], field, {file, line}, problems);
      }
    }
  });
  if (problems.empty()) outcome.value = std::move(list);
  return outcome;
}

}  // namespace vehicle
