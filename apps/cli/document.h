#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vehicle::cli {

enum class Format {
  kTable,
  kCsv,
  kJson
};

/// Nothing (does not apply), a text, a number, a whole number, yes or no.
using Cell = std::variant<std::monostate, std::string, double, long, bool>;

/// A cell at the end of a row, "nothing" where there is no value. It is made in its place: g++ 12 takes one that is
/// moved there for one half made.
template <class T>
void addCell(std::vector<Cell>& row, const std::optional<T>& value) {
  if (value) {
    row.emplace_back(*value);
  } else {
    row.emplace_back();
  }
}

struct Fact {
  std::string name;
  Cell value;
  std::string unit;
};

struct TableColumn {
  std::string name;
  std::string unit;
};

struct Table {
  std::string name;
  std::vector<TableColumn> columns;
  std::vector<std::vector<Cell>> rows;  // each as long as `columns`
  std::size_t key_columns = 0;          // lead every part of a table that is parted for its width; 0: it never is
};

/// What a command has to say on stdout: facts, tables, remarks.
struct Document {
  std::vector<Fact> facts;
  std::vector<Table> tables;
  std::vector<std::string> remarks;
};

/// table  for eyes: aligned columns, 5 significant digits; a table without rows is left out. Where it is wider than 120
///        letters, headers are broken at dots and spaces; where it still is, a table with key columns is parted
/// csv    the tables alone, an empty line between two; every number reads back to the same bits
/// json   one object: facts {name: {value, unit}}, tables {name: {units, rows}}, remarks; what is not finite is null
void print(const Document& document, Format format, std::ostream& out);

}  // namespace vehicle::cli
