#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "libvehicle/report/document/text_wrap.h"

namespace vehicle::report {

enum class Format {
  kTable,
  kCsv,
  kJson
};

/// Nothing (does not apply), a text, a number, a whole number, yes or no.
using Cell = std::variant<std::monostate, std::string, double, long, bool>;

/// A cell at the end of a row, "nothing" where there is no value. It is made in its place: g++ 12 warns
/// falsely (-Wmaybe-uninitialized) of one that is moved there.
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

/// In which unit a table for people shows the numbers of a column.
enum class ColumnUnit {
  kHandy,    // that of engineering_units.h for their size
  kAsGiven,  // the unit of the column: a place beside others, a unit that was chosen for several tables
};

struct TableColumn {
  std::string name;
  std::string unit;
  ColumnUnit shown = ColumnUnit::kHandy;
};

struct Table {
  std::string name;
  std::vector<TableColumn> columns;
  std::vector<std::vector<Cell>> rows;  // each as long as `columns`
  std::size_t key_columns = 1;          // lead every part of a table that is parted for its width
};

/// What a command prints, a page shows or another program reads: facts, tables, remarks. Numbers are in SI, times of
/// single steps in ns and us.
struct Document {
  std::vector<Fact> facts;
  std::vector<Table> tables;
  std::vector<std::string> remarks;
};

/// Puts the facts, tables and remarks of one document behind those of another.
void append(Document added, Document& document);

/// table  for people: aligned columns, 5 significant digits, handy units; a table without rows is left out. Where it is
///        wider than the page, headers are broken at dots and spaces, then it is parted below its key columns, and long
///        texts are wrapped between words: nothing is cut
/// csv    the tables alone in SI, an empty line between two; every number reads back to the same bits
/// json   one object in SI: facts {name: {value, unit}}, tables {name: {units, rows}}, remarks; what is not finite is null
/// @param width  of the page in letters; of `table` only
void print(const Document& document, Format format, std::ostream& out, std::size_t width = kAnyWidth);

}  // namespace vehicle::report
