#include "libvehicle/report/document/document.h"

#include <cmath>
#include <iterator>
#include <ostream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "libvehicle/report/document/cell_text.h"
#include "libvehicle/report/document/text_page.h"
#include "libvehicle/storage/csv_text.h"

namespace vehicle::report {
namespace {

using Json = nlohmann::ordered_json;

std::string forCsv(const Cell& cell) {
  return std::visit(Cases{[](std::monostate) { return std::string(); }, [](const std::string& text) { return text; },
                          [](double number) { return fmt::format("{}", number + 0.0); },
                          [](long number) { return fmt::format("{}", number); },
                          [](bool yes) { return std::string(yes ? "true" : "false"); }},
                    cell);
}

Json forJson(const Cell& cell) {
  return std::visit(
      Cases{[](std::monostate) { return Json(nullptr); }, [](const std::string& text) { return Json(text); },
            [](double number) { return std::isfinite(number) ? Json(number + 0.0) : Json(nullptr); },
            [](long number) { return Json(number); }, [](bool yes) { return Json(yes); }},
      cell);
}

/// One line of fields, each quoted where it needs it.
/// @param text_of  (item) -> the text of its field
template <class Items, class TextOf>
void printFields(const Items& items, TextOf text_of, std::ostream& out) {
  std::string line;
  bool first = true;
  for (const auto& item : items) {
    if (!first) line += ',';
    first = false;
    appendField(line, text_of(item));
  }
  out << line << '\n';
}

void printCsv(const Document& document, std::ostream& out) {
  bool first = true;
  for (const Table& table : document.tables) {
    if (table.rows.empty()) continue;
    if (!first) out << '\n';
    first = false;
    printFields(table.columns, headerOf, out);
    for (const std::vector<Cell>& row : table.rows) printFields(row, forCsv, out);
  }
}

void printJson(const Document& document, std::ostream& out) {
  Json whole = {{"facts", Json::object()}, {"tables", Json::object()}, {"remarks", document.remarks}};
  for (const Fact& fact : document.facts) {
    whole["facts"][fact.name] = {{"value", forJson(fact.value)}, {"unit", fact.unit}};
  }
  for (const Table& table : document.tables) {
    Json units = Json::object();
    for (const TableColumn& column : table.columns) {
      if (!column.unit.empty()) units[column.name] = column.unit;
    }
    Json rows = Json::array();
    for (const std::vector<Cell>& row : table.rows) {
      Json entry = Json::object();
      for (std::size_t j = 0; j < row.size(); ++j) entry[table.columns[j].name] = forJson(row[j]);
      rows.push_back(std::move(entry));
    }
    whole["tables"][table.name] = {{"units", std::move(units)}, {"rows", std::move(rows)}};
  }
  // A file name may hold bytes that are no UTF-8: they are replaced, never a reason to fail.
  out << whole.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace

void append(Document added, Document& document) {
  const auto move = [](auto& from, auto& to) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  move(added.facts, document.facts);
  move(added.tables, document.tables);
  move(added.remarks, document.remarks);
}

void print(const Document& document, Format format, std::ostream& out, std::size_t width) {
  switch (format) {
    case Format::kTable:
      printPage(document, width, out);
      break;
    case Format::kCsv:
      printCsv(document, out);
      break;
    case Format::kJson:
      printJson(document, out);
      break;
  }
}

}  // namespace vehicle::report
