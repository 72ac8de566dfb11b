#include "libvehicle/report/document/warning_table.h"

#include <map>

#include <fmt/format.h>

namespace vehicle::report {

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

std::vector<std::string> warningLines(const Warnings& warnings) {
  std::vector<std::string> lines;
  std::map<WarningCode, std::size_t> counts;
  for (const Warning& each : warnings) {
    if (++counts[each.code] <= kMostOfACode) lines.push_back(each.text());
  }
  for (const auto& [code, count] : counts) {
    if (count <= kMostOfACode) continue;
    lines.push_back(fmt::format("warning: {} more of this kind, which --format csv and json list [{}]",
                                count - kMostOfACode, wordOf(code)));
  }
  return lines;
}

}  // namespace vehicle::report
