#include "apps/cli/remarks.h"

#include <iostream>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace vehicle::cli {

void printNote(const std::string& text, const CommonOptions& common) {
  if (!common.quiet) std::cerr << "note: " << text << '\n';
}

void printNotes(const std::vector<Note>& notes, const CommonOptions& common) {
  for (const Note& each : notes) printNote(each.line(), common);
}

void printNotesOn(const std::vector<Scenario>& scenarios, const CommonOptions& common) {
  std::set<std::string> printed;
  for (const Scenario& scenario : scenarios) {
    for (const Note& each : notesOn(scenario)) {
      if (printed.insert(each.line()).second) printNote(each.line(), common);
    }
  }
}

void printWarnings(const Warnings& warnings) {
  std::map<WarningCode, std::size_t> printed;
  for (const Warning& each : warnings) {
    if (++printed[each.code] <= kMostOfACode) std::cerr << each.text() << '\n';
  }
  for (const auto& [code, count] : printed) {
    if (count <= kMostOfACode) continue;
    std::cerr << fmt::format("warning: {} more of this kind, which --format csv and json list [{}]\n",
                             count - kMostOfACode, wordOf(code));
  }
}

ExitStatus statusAfter(const Warnings& warnings, const CommonOptions& common) {
  return common.strict && !warnings.empty() ? kCheckDidNotHold : kDone;
}

Table warningTable(const Warnings& warnings) {
  Table table{"warnings",
              {{"code", ""},
               {"file", ""},
               {"line", ""},
               {"subject", ""},
               {"value", ""},
               {"unit", ""},
               {"time", "s"},
               {"message", ""}},
              {}};
  for (const Warning& each : warnings) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.emplace_back(std::string(wordOf(each.code)));
    row.emplace_back(each.place.file);
    row.emplace_back(static_cast<long>(each.place.line));
    row.emplace_back(each.subject);
    addCell(row, each.value);
    row.emplace_back(each.unit);
    addCell(row, each.time);
    row.emplace_back(each.remedy.empty() ? each.message : each.message + "; " + each.remedy);
  }
  return table;
}

void addWarnings(const Warnings& warnings, const CommonOptions& common, Document& document) {
  if (common.format != Format::kTable) document.tables.push_back(warningTable(warnings));
}

}  // namespace vehicle::cli
