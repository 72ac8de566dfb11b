#include "libvehicle/study/plan/design_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/storage/csv_text.h"

namespace vehicle {

namespace {

constexpr const char* kExample = "a header reads e.g. \"secondary.stiffness_z [kN/m],carbody.mass [t]\"";

// Adds the values of a row to the list, or tells what is wrong with it.
void readRow(std::string_view row, const Place& place, const std::vector<Channel>& columns, const BoundStudy& study,
             DesignList& list, ProblemList& problems) {
  const auto fields = splitFields(row);
  if (!fields || fields->size() != columns.size()) {
    problems.add(place, "",
                 fmt::format("the row has {} fields, the header {}", fields ? fields->size() : 1, columns.size()), "");
    return;
  }
  for (std::size_t i = 0; i < columns.size() && problems.size() < kMostCsvProblems; ++i) {
    const Dimension dimension = study.parameters[list.parameters[i]].dimension;
    const std::string field(trimmed((*fields)[i]));
    const ParsedQuantity parsed = parseQuantity(field + ' ' + columns[i].unit, dimension);
    if (parsed.si && std::isfinite(*parsed.si)) {
      list.values.push_back(*parsed.si);
    } else {
      problems.add(place, "", fmt::format("column \"{}\": \"{}\" is no number", columns[i].name, field), "");
    }
  }
}

}  // namespace

Outcome<std::vector<std::string>> listedAddresses(std::string_view text, const std::string& file) {
  Outcome<std::vector<std::string>> outcome;
  std::vector<std::string> addresses;
  for (Channel& each : takeHeader(text, file, kExample, outcome.problems)) addresses.push_back(std::move(each.name));
  if (outcome.problems.empty()) outcome.value = std::move(addresses);
  return outcome;
}

Outcome<DesignList> readDesignList(std::string_view text, const std::string& file, const BoundStudy& study) {
  Outcome<DesignList> outcome;
  ProblemList& problems = outcome.problems;
  const std::vector<Channel> columns = takeHeader(text, file, kExample, problems);
  DesignList list;
  for (const Channel& column : columns) {
    if (column.name.empty()) continue;  // told already
    const auto found = std::find_if(study.parameters.begin(), study.parameters.end(),
                                    [&](const StudyParameter& each) { return each.address == column.name; });
    if (found == study.parameters.end()) {
      problems.add({file, 1}, "", fmt::format("column \"{}\" is no parameter of the study", column.name), "");
      continue;
    }
    list.parameters.push_back(static_cast<std::size_t>(found - study.parameters.begin()));
    const ParsedQuantity one = parseQuantity("1 " + column.unit, found->dimension);
    if (one.si) continue;
    problems.add({file, 1}, "", fmt::format("column \"{}\": the unit [{}] {}", column.name, column.unit, one.message),
                 one.remedy);
  }
  if (!problems.empty()) return outcome;

  for (int line = 2; !text.empty() && problems.size() < kMostCsvProblems; ++line) {
    const std::string_view row = takeLine(text);
    if (!row.empty()) readRow(row, {file, line}, columns, study, list, problems);
  }
  if (problems.empty() && list.values.empty()) {
    problems.add({file, 0}, "", "holds no design", "write one a row under the header");
  }
  if (problems.empty()) outcome.value = std::move(list);
  return outcome;
}

}  // namespace vehicle
