#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libvehicle/diagnostics/warning_set.h"
#include "libvehicle/storage/run_record.h"
#include "libvehicle/units/channel.h"

namespace vehicle {

/// What a study is, apart from its designs: enough to repeat it.
struct StudyRecord {
  std::string program;              // name and version
  std::vector<InputFile> inputs;    // the study file first, then vehicle, scenarios, lists: exactly as they were read
  std::vector<Channel> parameters;  // names and SI units
  std::vector<Channel> metrics;     // "carbody.az.rms @ 80 km/h", "m/s^2"
  std::uint64_t designs = 0;        // ids are 0 .. designs - 1
  bool operator==(const StudyRecord&) const = default;
};

/// Most parameters and metrics of a study together: SQLite's 2000 columns less id, status, message
/// and warnings.
inline constexpr std::size_t kMostStudyValues = 1996;
/// @throws InvalidInput  unless a row of the database holds all of them
void requireRoom(const StudyRecord& record);

enum class DesignStatus {
  kDone,   // may lack values, each with its reason in the message
  kFailed  // has no value at all
};

/// Evaluated designs on their way into the database.
class DesignBatch {
 public:
  DesignBatch(std::size_t parameters, std::size_t metrics) : parameters_(parameters), metrics_(metrics) {}

  /// @param parameters  [SI], finite
  /// @param metrics     [SI], finite; NaN: there is no value
  /// @param message     why values are missing; not empty where one is
  /// @param warnings    where the results left what the model can say
  /// @throws std::invalid_argument if there are not as many as the study has, or a value is missing without a message
  void add(std::uint64_t id, std::span<const double> parameters, std::span<const double> metrics,
           std::string message = {}, WarningSet warnings = {});
  /// A design without metrics. @param message  why, not empty
  void addFailed(std::uint64_t id, std::span<const double> parameters, std::string message);

  void clear();
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] std::size_t parameters() const { return parameters_; }
  [[nodiscard]] std::size_t metrics() const { return metrics_; }

  struct Row {
    std::uint64_t id = 0;
    DesignStatus status = DesignStatus::kDone;
    std::optional<std::size_t> message;  // in messages()
    WarningSet warnings;
  };
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  /// Shape (parameters + metrics); NaN where there is no value, as in all metrics of a failed design.
  [[nodiscard]] std::span<const double> values(std::size_t row) const;
  [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }

 private:
  void addRow(std::uint64_t id, DesignStatus status, std::span<const double> parameters);
  void setMessage(std::string message);

  std::size_t parameters_;
  std::size_t metrics_;
  std::vector<Row> rows_;
  std::vector<double> values_;  // (rows x (parameters + metrics))
  std::vector<std::string> messages_;
};

/// A design as it is read back; valid until the next one.
struct StoredDesign {
  std::uint64_t id = 0;
  DesignStatus status = DesignStatus::kDone;
  std::string_view message;            // why it failed, or why values are missing; else empty
  std::span<const double> parameters;  // [SI]
  std::span<const double> metrics;     // [SI], NaN where there is no value; empty for a failed one
  WarningSet warnings;                 // where its results left what the model can say
};

/// Designs first .. last, both included.
struct DesignRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  bool operator==(const DesignRange&) const = default;
};

}  // namespace vehicle
