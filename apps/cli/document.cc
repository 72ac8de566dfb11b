#include "apps/cli/document.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

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

std::string headerOf(const TableColumn& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

/// Letters as a terminal counts them: bytes that do not continue a UTF-8 sequence.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

bool isNumber(const Cell& cell) { return std::holds_alternative<double>(cell) || std::holds_alternative<long>(cell); }

constexpr std::size_t kPageWidth = 120;
constexpr std::size_t kFoldedHeader = 15;  // narrower, a header makes too many lines

/// A header where it may be broken: "secondary_front." "deflection." "rms " "@ 80 km/h " "[mm]". Speeds and what stands
/// in brackets stay whole.
std::vector<std::string> piecesOf(const std::string& header) {
  std::vector<std::string> pieces(1);
  bool whole = false;
  for (const char letter : header) {
    if (letter == '[' && !pieces.back().empty()) pieces.emplace_back();
    pieces.back() += letter;
    if (letter == '(' || letter == '@') whole = true;
    if (letter == ')' || letter == '[') whole = false;
    if (!whole && (letter == '.' || letter == ' ')) pieces.emplace_back();
  }
  return pieces;
}

std::string trimmed(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

/// A column as it is printed: its texts, and how wide they are.
struct EyeColumn {
  std::vector<std::string> header;  // lines
  std::vector<std::string> texts;   // (rows)
  std::size_t width = 0;
  bool right = false;

  EyeColumn(const Table& table, std::size_t j) : header{headerOf(table.columns[j])} {
    for (const std::vector<Cell>& row : table.rows) {
      texts.push_back(forEyes(row[j]));
      right = right || isNumber(row[j]);
    }
    measure();
  }

  void measure() {
    width = 0;
    for (const std::vector<std::string>* lines : {&header, &texts}) {
      for (const std::string& each : *lines) width = std::max(width, widthOf(each));
    }
  }

  /// Breaks the header into few lines that are not much wider than the column's texts.
  void fold() {
    const std::vector<std::string> pieces = piecesOf(header.front());
    std::size_t most = kFoldedHeader;
    for (const std::string& each : texts) most = std::max(most, widthOf(each));
    for (const std::string& each : pieces) most = std::max(most, widthOf(trimmed(each)));
    std::vector<std::string> lines(1);
    for (const std::string& each : pieces) {
      if (!lines.back().empty() && widthOf(trimmed(lines.back() + each)) > most) lines.emplace_back();
      lines.back() += each;
    }
    header.clear();
    for (const std::string& each : lines) header.push_back(trimmed(each));
    measure();
  }
};

std::size_t widthOf(const std::vector<EyeColumn>& columns, const std::vector<std::size_t>& chosen) {
  std::size_t width = 0;
  for (const std::size_t j : chosen) width += 2 + columns[j].width;
  return width;
}

void printForEyes(const std::vector<EyeColumn>& columns, const std::vector<std::size_t>& chosen, std::ostream& out) {
  const auto print_line = [&](auto text_of) {
    std::string line;
    for (const std::size_t j : chosen) {
      const std::string text = text_of(columns[j]);
      const std::string padding(columns[j].width - widthOf(text), ' ');
      line += "  " + (columns[j].right ? padding + text : text + padding);
    }
    out << trimmed(std::move(line)) << '\n';
  };
  std::size_t lines = 0;
  for (const std::size_t j : chosen) lines = std::max(lines, columns[j].header.size());
  for (std::size_t line = 0; line < lines; ++line) {
    print_line([&](const EyeColumn& column) {
      const std::size_t above = lines - column.header.size();  // headers stand on the rows
      return line < above ? std::string() : column.header[line - above];
    });
  }
  for (std::size_t row = 0; row < columns.front().texts.size(); ++row) {
    print_line([&](const EyeColumn& column) { return column.texts[row]; });
  }
}

void printForEyes(const Table& table, std::ostream& out) {
  std::vector<EyeColumn> columns;
  std::vector<std::size_t> all;
  for (std::size_t j = 0; j < table.columns.size(); ++j) {
    columns.emplace_back(table, j);
    all.push_back(j);
  }
  if (widthOf(columns, all) > kPageWidth) {
    for (EyeColumn& each : columns) each.fold();
  }
  out << table.name << '\n';
  if (table.key_columns == 0 || widthOf(columns, all) <= kPageWidth) return printForEyes(columns, all, out);
  const auto keys = static_cast<std::ptrdiff_t>(table.key_columns);
  std::vector<std::size_t> part(all.begin(), all.begin() + keys);
  for (std::size_t j = table.key_columns; j < columns.size(); ++j) {
    part.push_back(j);
    const bool last = j + 1 == columns.size();
    if (!last && widthOf(columns, part) + 2 + columns[j + 1].width <= kPageWidth) continue;
    printForEyes(columns, part, out);
    if (!last) out << '\n';
    part.resize(table.key_columns);
  }
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
