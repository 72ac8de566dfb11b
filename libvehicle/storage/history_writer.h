#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "libvehicle/result/history_sink.h"
#include "libvehicle/storage/run_record.h"

namespace vehicle {

/// A file that a history is written to while the run goes, under a temporary name (atomic_file.h): memory does not grow
/// with the run, and until publish() nobody sees anything of it.
class HistoryWriter : public HistorySink {
 public:
  /// After the last sample, wherever the run has ended. Leaves nothing that may fail but the renaming.
  /// @throws RunFailed, std::invalid_argument as writeHistory()
  virtual void finish(const RunDescription& description) = 0;
  /// Puts the file in its place, instead of what stood there.
  /// @throws RunFailed
  virtual void publish() = 0;

  /// A whole history that is in memory.
  void writeAll(const TimeHistory& history, const RunDescription& description);
};

/// Makes the temporary file, of the format that the extension says.
/// @throws std::invalid_argument  another extension
/// @throws RunFailed              it cannot be made
[[nodiscard]] std::unique_ptr<HistoryWriter> openHistory(const std::filesystem::path& path);

/// All files of one run, none or several.
class HistoryFiles final : public HistorySink {
 public:
  /// @throws as openHistory()
  explicit HistoryFiles(const std::vector<std::string>& paths);

  [[nodiscard]] bool empty() const { return writers_.empty(); }
  void begin(const std::vector<Channel>& columns, long samples) override;
  void add(std::span<const double> row) override;
  /// Ends and shows all of them; if one cannot be written, none is shown.
  /// @throws as HistoryWriter
  void publish(const RunDescription& description);

 private:
  std::vector<std::unique_ptr<HistoryWriter>> writers_;
};

}  // namespace vehicle
