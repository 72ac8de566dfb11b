#include "libvehicle/storage/line_diff.h"

#include <algorithm>
#include <cstdint>

#include "libvehicle/storage/csv_text.h"

namespace vehicle {

namespace {

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) lines.push_back(takeLine(text));
  return lines;
}

using Lines = std::vector<std::string_view>;

/// A block without a common line: the first lines of both sides count as replaced, the rest as gone or new.
void addBlock(const Lines& before, std::size_t a, std::size_t a_end, const Lines& now, std::size_t b, std::size_t b_end,
              std::vector<LineChange>& changes) {
  for (; a < a_end || b < b_end; ++a, b += b < b_end ? 1 : 0) {
    LineChange change;
    change.line = b + 1;
    if (a < a_end) change.was = std::string(before[a]);
    if (b < b_end) change.is = std::string(now[b]);
    changes.push_back(std::move(change));
  }
}

}  // namespace

std::vector<LineChange> lineDiff(std::string_view before_text, std::string_view now_text) {
  const Lines before = linesOf(before_text);
  const Lines now = linesOf(now_text);
  std::size_t begin = 0;
  while (begin < before.size() && begin < now.size() && before[begin] == now[begin]) ++begin;
  std::size_t a_end = before.size();
  std::size_t b_end = now.size();
  while (a_end > begin && b_end > begin && before[a_end - 1] == now[b_end - 1]) --a_end, --b_end;

  std::vector<LineChange> changes;
  const std::size_t rows = a_end - begin;
  const std::size_t columns = b_end - begin;
  constexpr std::size_t kMostCells = 1'000'000;
  if (rows * columns > kMostCells) {
    addBlock(before, begin, a_end, now, begin, b_end, changes);
    return changes;
  }
  // length[i][j]: common lines of before[begin + i ..] and now[begin + j ..]
  std::vector<std::uint32_t> length((rows + 1) * (columns + 1), 0);
  const auto at = [&](std::size_t i, std::size_t j) -> std::uint32_t& { return length[i * (columns + 1) + j]; };
  for (std::size_t i = rows; i-- > 0;) {
    for (std::size_t j = columns; j-- > 0;) {
      at(i, j) = before[begin + i] == now[begin + j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
    }
  }
  std::size_t i = 0;
  std::size_t j = 0;
  std::size_t i_open = 0;
  std::size_t j_open = 0;
  const auto close = [&] { addBlock(before, begin + i_open, begin + i, now, begin + j_open, begin + j, changes); };
  while (i < rows && j < columns) {
    if (before[begin + i] == now[begin + j]) {
      close();
      i_open = ++i;
      j_open = ++j;
    } else if (at(i + 1, j) >= at(i, j + 1)) {
      ++i;
    } else {
      ++j;
    }
  }
  i = rows;
  j = columns;
  close();
  return changes;
}

}  // namespace vehicle
