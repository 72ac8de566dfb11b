#include "libvehicle/storage/history_file.h"

#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/storage/csv.h"
#include "libvehicle/storage/csv_writer.h"
#include "libvehicle/storage/file_identity.h"
#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/hdf5_writer.h"
#include "libvehicle/storage/history_writer.h"

namespace vehicle {

HistoryFormat historyFormatOf(const std::filesystem::path& path) {
  const std::string ending = endingOf(path);
  if (ending == ".csv") return HistoryFormat::kCsv;
  if (ending == ".h5") return HistoryFormat::kHdf5;
  throw std::invalid_argument(fmt::format("{}: extension \"{}\" is unknown; name it .csv (text) or .h5 (HDF5)",
                                          path.string(), path.extension().string()));
}

void writeHistory(const std::filesystem::path& path, const RunRecord& record) {
  switch (historyFormatOf(path)) {
    case HistoryFormat::kCsv:
      return writeCsv(record.history, path);
    case HistoryFormat::kHdf5:
      return writeHdf5(record, path);
  }
}

std::unique_ptr<HistoryWriter> openHistory(const std::filesystem::path& path) {
  if (historyFormatOf(path) == HistoryFormat::kCsv) return std::make_unique<CsvWriter>(path);
  return std::make_unique<Hdf5Writer>(path);
}

void HistoryWriter::writeAll(const TimeHistory& history, const RunDescription& description) {
  begin(history.columns(), static_cast<long>(history.samples()));
  for (std::size_t i = 0; i < history.samples(); ++i) add(history.row(i));
  finish(description);
  publish();
}

HistoryFiles::HistoryFiles(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) writers_.push_back(openHistory(path));
}

void HistoryFiles::begin(const std::vector<Channel>& columns, long samples) {
  for (const auto& writer : writers_) writer->begin(columns, samples);
}

void HistoryFiles::add(std::span<const double> row) {
  for (const auto& writer : writers_) writer->add(row);
}

void HistoryFiles::publish(const RunDescription& description) {
  for (const auto& writer : writers_) writer->finish(description);
  for (const auto& writer : writers_) writer->publish();
}

}  // namespace vehicle
