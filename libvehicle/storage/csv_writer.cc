#include "libvehicle/storage/csv_writer.h"

#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/storage/csv_text.h"

namespace vehicle {

void CsvWriter::begin(const std::vector<Channel>& columns, long) {
  columns_ = columns;
  for (const Channel& column : columns) {
    if (!text_.empty()) text_ += ',';
    appendField(text_, fmt::format("{} [{}]", column.name, column.unit));
  }
  text_ += '\n';
}

void CsvWriter::add(std::span<const double> row) {
  requireStorable(columns_, row);
  for (const double value : row) {
    appendNumber(text_, value);
    text_ += ',';
  }
  text_.back() = '\n';
  constexpr std::size_t kBlock = 1 << 20;
  if (text_.size() < kBlock) return;
  file_.write(text_);
  text_.clear();
}

void CsvWriter::finish(const RunDescription&) {
  file_.write(text_);
  file_.finish();
}

}  // namespace vehicle
