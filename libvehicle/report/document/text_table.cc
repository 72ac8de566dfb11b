#include "libvehicle/report/document/text_table.h"

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/report/document/cell_text.h"
#include "libvehicle/report/document/text_wrap.h"

namespace vehicle::report {
namespace {

constexpr std::size_t kGap = 2;             // before each column
constexpr std::size_t kFoldedHeader = 15;   // narrower, a header makes too many lines
constexpr std::size_t kNarrowestName = 16;  // narrower, names are hard to read
constexpr std::size_t kNarrowestText = 20;  // the same of sentences

bool isNumber(const Cell& cell) { return std::holds_alternative<double>(cell) || std::holds_alternative<long>(cell); }

using Lines = std::vector<std::string>;

/// A column as it is printed: the lines of its header and of its cells, and how wide they are.
struct TextColumn {
  Lines header;
  std::vector<Lines> cells;  // (rows)
  std::size_t width = 0;
  bool right = false;

  TextColumn(const Table& table, std::size_t j) : header{headerOf(table.columns[j])} {
    for (const std::vector<Cell>& row : table.rows) {
      cells.push_back({formatted(row[j])});
      right = right || isNumber(row[j]);
    }
    measure();
  }

  void measure() {
    width = widthOf(header);
    for (const Lines& each : cells) width = std::max(width, widthOf(each));
  }

  static std::size_t widthOf(const Lines& lines) {
    std::size_t width = 0;
    for (const std::string& each : lines) width = std::max(width, lettersOf(each));
    return width;
  }

  /// Breaks the header into few lines that are not much wider than the column's texts.
  void foldHeader() {
    const Lines parts = partsOfName(header.front());
    std::size_t most = kFoldedHeader;
    for (const Lines& each : cells) most = std::max(most, widthOf(each));
    for (const std::string& each : parts) most = std::max(most, lettersOf(trimmed(each)));
    header = linesOf(parts, most);
    measure();
  }

  /// Breaks the cells: names at their dots too, sentences between words only.
  template <class Parts>
  void wrapCells(std::size_t most, Parts parts_of) {
    for (Lines& each : cells) each = linesOf(parts_of(each.front()), most);
    measure();
  }
};

using Chosen = std::vector<std::size_t>;  // columns by their numbers

std::size_t widthOf(const std::vector<TextColumn>& columns, const Chosen& chosen) {
  std::size_t width = 0;
  for (const std::size_t j : chosen) width += kGap + columns[j].width;
  return width;
}

/// Prints one line of header or row: as many lines as the tallest of its cells has.
/// @param lines_of  (column) -> Lines    @param above  whether blank lines stand above a cell that is not as tall
template <class LinesOf>
void printRow(const std::vector<TextColumn>& columns, const Chosen& chosen, std::ostream& out, LinesOf lines_of,
              bool above) {
  std::size_t tallest = 0;
  for (const std::size_t j : chosen) tallest = std::max(tallest, lines_of(columns[j]).size());
  for (std::size_t line = 0; line < tallest; ++line) {
    std::string text;
    for (const std::size_t j : chosen) {
      const Lines& lines = lines_of(columns[j]);
      const std::size_t blank = above ? tallest - lines.size() : 0;
      const std::string part = line >= blank && line - blank < lines.size() ? lines[line - blank] : std::string();
      const std::string padding(columns[j].width - lettersOf(part), ' ');
      text += std::string(kGap, ' ') + (columns[j].right ? padding + part : part + padding);
    }
    out << trimmed(std::move(text)) << '\n';
  }
}

void printBlock(const std::vector<TextColumn>& columns, const Chosen& chosen, std::ostream& out) {
  printRow(
      columns, chosen, out, [](const TextColumn& column) -> const Lines& { return column.header; }, true);
  for (std::size_t row = 0; row < columns.front().cells.size(); ++row) {
    printRow(
        columns, chosen, out, [&](const TextColumn& column) -> const Lines& { return column.cells[row]; }, false);
  }
}

/// Makes the widest keys narrower until they take half of the page, or cannot be.
void narrowKeys(std::vector<TextColumn>& columns, Chosen keys, std::size_t width) {
  std::stable_sort(keys.begin(), keys.end(),
                   [&](std::size_t a, std::size_t b) { return columns[a].width > columns[b].width; });
  for (const std::size_t j : keys) {
    const std::size_t all = widthOf(columns, keys);
    const std::size_t excess = all > width / 2 ? all - width / 2 : 0;
    if (excess == 0 || columns[j].right) continue;
    const std::size_t least = std::max(excess, columns[j].width) - excess;
    columns[j].wrapCells(std::max(kNarrowestName, least), partsOfName);
  }
}

/// The words of a text; a name that is wider than the room is broken at its dots.
Lines wordsThatFit(const std::string& text, std::size_t room) {
  Lines pieces;
  for (const std::string& word : wordsOf(text)) {
    const Lines parts = lettersOf(trimmed(word)) > room ? partsOfName(word) : Lines{word};
    pieces.insert(pieces.end(), parts.begin(), parts.end());
  }
  return pieces;
}

/// Wraps texts that do not fit beside the keys.
void narrowTexts(std::vector<TextColumn>& columns, const Chosen& keys, std::size_t width) {
  const std::size_t taken = widthOf(columns, keys) + kGap;
  const std::size_t room = std::max(kNarrowestText, width > taken ? width - taken : 0);
  for (std::size_t j = keys.size(); j < columns.size(); ++j) {
    if (columns[j].width > room && !columns[j].right) {
      columns[j].wrapCells(room, [room](const std::string& text) { return wordsThatFit(text, room); });
    }
  }
}

}  // namespace

void printTable(const Table& table, std::size_t width, std::ostream& out) {
  std::vector<TextColumn> columns;
  Chosen all;
  for (std::size_t j = 0; j < table.columns.size(); ++j) {
    columns.emplace_back(table, j);
    all.push_back(j);
  }
  out << wrapped(table.name, width) << '\n';
  if (widthOf(columns, all) > width) {
    for (TextColumn& each : columns) each.foldHeader();
  }
  if (widthOf(columns, all) <= width) return printBlock(columns, all, out);

  const std::size_t key_columns = std::min(table.key_columns, columns.size() - 1);
  const Chosen keys(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(key_columns));
  narrowKeys(columns, keys, width);
  narrowTexts(columns, keys, width);
  Chosen block = keys;
  for (std::size_t j = key_columns; j < columns.size(); ++j) {
    block.push_back(j);
    const bool last = j + 1 == columns.size();
    if (!last && widthOf(columns, block) + kGap + columns[j + 1].width <= width) continue;
    printBlock(columns, block, out);
    if (!last) out << '\n';
    block = keys;
  }
}

}  // namespace vehicle::report
