#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "libvehicle/storage/study_record.h"

namespace vehicle {

/// The designs of a study and what came out of each, in one SQLite file that any SQLite tool can open.
///
/// Tables: `study` (format, program, designs), `input_files` (position, name, content), `columns` (what each column of
/// `designs` is: role, name, unit) and `designs`, one row a design: id, status ("done" or "failed"), message, then a
/// REAL column for every parameter and metric, named as in the study, and warnings ("WHEEL_LOAD LARGE_MOTION", NULL
/// where the design has none). Numbers are 8-byte SI values that read back to
/// the same bits, but -0 becomes 0. A design that is done may lack values: they are NULL, and its message says why; a
/// failed design has no value at all and a message.
/// SQLite holds 2000 columns, so parameters and metrics together may be 1996; a study of more is refused.
///
/// A batch is one transaction in a write-ahead log: killed at any moment, the file reopens with whole batches only, and
/// what append() has returned from survives the process. After a power cut the last batches may be missing, nothing
/// else. One process writes at a time (file_lock.h); others may read meanwhile. An object is for one thread.
class StudyDatabase {
 public:
  /// A new file, there at once and whole; one that is there already may be empty.
  /// @throws RunFailed     the file exists already, or cannot be written; names the path and the system's reason
  /// @throws InvalidInput  the study has too many columns
  /// @throws std::invalid_argument  two columns of the same name
  [[nodiscard]] static StudyDatabase create(const std::filesystem::path& path, const StudyRecord& record);

  /// The same in the place of an old study, whatever that holds.
  /// @throws RunFailed     as create(), or another process is writing it
  [[nodiscard]] static StudyDatabase replace(const std::filesystem::path& path, const StudyRecord& record);

  /// Opens a file to go on with the same study.
  /// @throws InvalidInput  no file, no study in it, or damaged; the study is another one (study_changes.h)
  /// @throws RunFailed     it is being written by another process, or not writable
  [[nodiscard]] static StudyDatabase resume(const std::filesystem::path& path, const StudyRecord& now);

  /// Opens a file to look at it; works in folders that may not be written. Where they may, what a killed program has
  /// left in the log is moved into the file.
  /// @throws InvalidInput  no file, no study in it, or damaged
  [[nodiscard]] static StudyDatabase read(const std::filesystem::path& path);

  StudyDatabase(StudyDatabase&&) noexcept;
  StudyDatabase& operator=(StudyDatabase&&) = delete;
  ~StudyDatabase();

  [[nodiscard]] const StudyRecord& record() const;

  /// Number of designs stored.
  [[nodiscard]] std::uint64_t stored() const;
  /// What is still to be evaluated, in rising order.
  /// @throws InvalidInput  a design is stored that the study does not have: the file is damaged
  [[nodiscard]] std::vector<DesignRange> missing() const;

  /// Stores all designs of the batch, or none of them. Batches of about 10 000 designs cost least.
  /// @throws RunFailed              the disk is full, ...; what was stored before is safe, and the call may be repeated
  /// @throws std::invalid_argument  a parameter that is not finite, a metric that is infinite, an id beyond the study
  ///                                or stored already
  void append(const DesignBatch& batch);

  /// Calls `visit` with every design in the order of ids, in constant memory, until it returns false.
  void forEach(const std::function<bool(const StoredDesign&)>& visit) const;

  /// The whole table as comma-separated text, one line a design in the order of ids, written atomically; every number
  /// is the shortest text that reads back to the same bits; a value that is missing is empty, and the message says why.
  ///
  ///     id,design,status,carbody.mass [kg],carbody.az.rms @ 80 km/h [m/s^2],warnings,message
  ///
  /// @param nameOf  what to call a design by its id; without it there is no column of names
  /// @throws RunFailed
  void writeCsv(const std::filesystem::path& path,
                const std::function<std::string(std::uint64_t)>& nameOf = nullptr) const;

 private:
  struct Open;
  explicit StudyDatabase(std::unique_ptr<Open> open);
  static StudyDatabase forWriting(const std::filesystem::path& path, const std::string& shown,
                                  std::unique_ptr<class FileLock> lock);
  std::unique_ptr<Open> open_;
};

}  // namespace vehicle
