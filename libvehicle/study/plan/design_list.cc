#include "libvehicle/study/plan/design_list.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/storage/csv_text.h"

namespace vehicle {

namespace {

constexpr std::size_t kMostProblems = 20;
constexpr const char* kExample = "a header reads e.g. \"secondary.stiffness_z [kN/m],carbody.mass [t]\"";

void tell(ProblemList& problems, const std::string& file, int line, std::string message, std::string remedy = "") {
  if (problems.size() >= kMostProblems) return;
  Problem problem;
  problem.place.file = file;
  problem.place.line = line;
  problem.message = std::move(message);
  problem.remedy = std::move(remedy);
  problems.add(std::move(problem));
}

std::string_view withoutMark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

std::vector<NamedColumn> readHeader(std::string_view line, const std::string& file, ProblemList& problems) {
  std::vector<NamedColumn> columns;
  const auto fields = splitFields(line);
  if (!fields) {
    tell(problems, file, 1, "a quote in the header is never closed");
    return columns;
  }
  std::set<std::string> names;
  for (const std::string& field : *fields) {
    const std::optional<NamedColumn> column = columnOf(field);
    if (!column) {
      tell(problems, file, 1, fmt::format("column \"{}\" has no parameter with a unit in brackets", field), kExample);
    } else if (!names.insert(column->name).second) {
      tell(problems, file, 1, fmt::format("column \"{}\" stands there twice", column->name));
    } else {
      columns.push_back(*column);
    }
  }
  return columns;
}

}  // namespace

Outcome<std::vector<std::string>> listedAddresses(std::string_view text, const std::string& file) {
  Outcome<std::vector<std::string>> outcome;
  text = withoutMark(text);
  std::vector<std::string> addresses;
  for (const NamedColumn& each : readHeader(takeLine(text), file, outcome.problems)) addresses.push_back(each.name);
  if (outcome.problems.empty()) outcome.value = std::move(addresses);
  return outcome;
}

Outcome<DesignList> readDesignList(std::string_view text, const std::string& file, const BoundStudy& study) {
  Outcome<DesignList> outcome;
  ProblemList& problems = outcome.problems;
  text = withoutMark(text);
  const std::vector<NamedColumn> columns = readHeader(takeLine(text), file, problems);
  DesignList list;
  for (const NamedColumn& column : columns) {
    const auto found = std::find_if(study.parameters.begin(), study.parameters.end(),
                                    [&](const StudyParameter& each) { return each.address == column.name; });
    if (found == study.parameters.end()) {
      tell(problems, file, 1, fmt::format("column \"{}\" is no parameter of the study", column.name));
      continue;
    }
    list.parameters.push_back(static_cast<std::size_t>(found - study.parameters.begin()));
    const ParsedQuantity one = parseQuantity("1 " + column.unit, found->dimension);
    if (!one.si)
      tell(problems, file, 1, fmt::format("column \"{}\": the unit [{}] {}", column.name, column.unit, one.message),
           one.remedy);
  }
  if (!problems.empty()) return outcome;

  for (int line = 2; !text.empty() && problems.size() < kMostProblems; ++line) {
    const std::string_view row = takeLine(text);
    if (row.empty()) continue;
    const auto fields = splitFields(row);
    if (!fields || fields->size() != columns.size()) {
      tell(problems, file, line,
           fmt::format("the row has {} fields, the header {}", fields ? fields->size() : 1, columns.size()));
      continue;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Dimension dimension = study.parameters[list.parameters[i]].dimension;
      const ParsedQuantity parsed = parseQuantity((*fields)[i] + ' ' + columns[i].unit, dimension);
      if (parsed.si && std::isfinite(*parsed.si)) {
        list.values.push_back(*parsed.si);
      } else {
        tell(problems, file, line, fmt::format("column \"{}\": \"{}\" is no number", columns[i].name, (*fields)[i]));
      }
    }
  }
  if (problems.empty() && list.values.empty())
    tell(problems, file, 0, "holds no design", "write one a row under the header");
  if (problems.empty()) outcome.value = std::move(list);
  return outcome;
}

}  // namespace vehicle
