#include "apps/cli/document.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace vehicle::cli {
namespace {

using Json = nlohmann::ordered_json;

template <class... F>
struct Cases : F... {
  using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

std::string forEyes(const Cell& cell) {
  return std::visit(Cases{[](std::monostate) { return std::string("-"); }, [](const std::string& text) { return text; },
                          // + 0.0 turns -0 into 0
                          [](double number) { return fmt::format("{:.5g}", number + 0.0); },
                          [](long number) { return fmt::format("{}", number); },
                          [](bool yes) { return std::string(yes ? "yes" : "no"); }},
                    cell);
}

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
            [](double number) { return fmt::format("{}", number); },
            [](long number) { return fmt::format("{}", number); },
            [](bool yes) { return std::string(yes ? "true" : "false"); }},
      cell);
}

Json forJson(const Cell& cell) {
  return std::visit(
      Cases{[](std::monostate) { return Json(nullptr); }, [](const std::string& text) { return Json(text); },
            [](double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); },
            [](long number) { return Json(number); }, [](bool yes) { return Json(yes); }},
      cell);
}

std::string headerOf(const TableColumn& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

/// Letters as a terminal counts them: bytes that do not continue a UTF-8 sequence.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

bool isNumber(const Cell& cell) { return std::holds_alternative<double>(cell) || std::holds_alternative<long>(cell); }

void printForEyes(const Table& table, std::ostream& out) {
  const std::size_t columns = table.columns.size();
  std::vector<std::size_t> width(columns);
  std::vector<bool> right(columns);
  for (std::size_t j = 0; j < columns; ++j) {
    width[j] = widthOf(headerOf(table.columns[j]));
    for (const std::vector<Cell>& row : table.rows) {
      width[j] = std::max(width[j], widthOf(forEyes(row[j])));
      right[j] = right[j] || isNumber(row[j]);
    }
  }
  const auto print_line = [&](auto text_of) {
    std::string line;
    for (std::size_t j = 0; j < columns; ++j) {
      const std::string text = text_of(j);
      const std::string padding(width[j] - widthOf(text), ' ');
      line += "  " + (right[j] ? padding + text : text + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  };
  out << table.name << '\n';
  print_line([&](std::size_t j) { return headerOf(table.columns[j]); });
  for (const std::vector<Cell>& row : table.rows) print_line([&](std::size_t j) { return forEyes(row[j]); });
}

void printForEyes(const Document& document, std::ostream& out) {
  std::size_t width = 0;
  for (const Fact& fact : document.facts) width = std::max(width, widthOf(fact.name));
  for (const Fact& fact : document.facts) {
    out << fact.name << std::string(width - widthOf(fact.name) + 2, ' ') << forEyes(fact.value)
        << (fact.unit.empty() ? "" : " ") << fact.unit << '\n';
  }
  bool first = document.facts.empty();
  for (const Table& table : document.tables) {
    if (table.rows.empty()) continue;
    if (!first) out << '\n';
    first = false;
    printForEyes(table, out);
  }
  if (!document.remarks.empty() && !first) out << '\n';
  for (const std::string& remark : document.remarks) out << remark << '\n';
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

void print(const Document& document, Format format, std::ostream& out) {
  switch (format) {
    case Format::kTable:
      printForEyes(document, out);
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
