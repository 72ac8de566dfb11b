#pragma once

#include "libvehicle/storage/atomic_file.h"
#include "libvehicle/storage/history_writer.h"

namespace vehicle {

/// Writes what csv.h shows, a megabyte at a time.
class CsvWriter final : public HistoryWriter {
 public:
  explicit CsvWriter(const std::filesystem::path& path) : file_(path) {}

  void begin(const std::vector<Channel>& columns, long samples) override;
  void add(std::span<const double> row) override;
  void finish(const RunDescription& description) override;
  void publish() override { file_.publish(); }

 private:
  AtomicFile file_;
  std::vector<Channel> columns_;
  std::string text_;  // not yet written
};

}  // namespace vehicle
