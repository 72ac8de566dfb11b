#include "apps/cli/document.h"

#include <cmath>
#include <ostream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/cli/cell_text.h"
#include "apps/cli/text_page.h"

namespace vehicle::cli {
namespace {

using Json = nlohmann::ordered_json;

/// RFC 4180: quoted where a comma, quote or line break stands inside.
std::string forCsv(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"') quoted += '"';
    quoted += letter;
  }
  return quoted + '"';
}

std::string forCsv(const Cell& cell) {
  return std::visit(
      Cases{[](std::monostate) { return std::string(); }, [](const std::string& text) { return forCsv(text); },
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

void printCsv(const Document& document, std::ostream& out) {
  bool first = true;
  for (const Table& table : document.tables) {
    if (table.rows.empty()) continue;
    if (!first) out << '\n';
    first = false;
    for (std::size_t j = 0; j < table.columns.size(); ++j)
      out << (j == 0 ? "" : ",") << forCsv(headerOf(table.columns[j]));
    out << '\n';
    for (const std::vector<Cell>& row : table.rows) {
      for (std::size_t j = 0; j < row.size(); ++j) out << (j == 0 ? "" : ",") << forCsv(row[j]);
      out << '\n';
    }
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

}  // namespace vehicle::cli
