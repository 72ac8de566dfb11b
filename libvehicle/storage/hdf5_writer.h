#pragma once

#include <optional>

#include "libvehicle/storage/hdf5_driver.h"
#include "libvehicle/storage/history_writer.h"

namespace vehicle {

/// Writes what hdf5.h shows, some megabytes at a time: a chunk of every column when it is full. HDF5 keeps its state in
/// globals, so every call into it takes a turn.
class Hdf5Writer final : public HistoryWriter {
 public:
  explicit Hdf5Writer(const std::filesystem::path& path);
  ~Hdf5Writer() override;

  void begin(const std::vector<Channel>& columns, long samples) override;
  void add(std::span<const double> row) override;
  void finish(const RunDescription& description) override;
  void publish() override { file_.publish(); }

 private:
  template <class Work>
  void takeTurn(const Work& work);
  void writeChunk();
  void close();

  std::string shown_;  // the path as the caller gave it, for messages
  AtomicFile file_;
  Hdf5Target target_{file_};
  std::vector<Channel> columns_;
  std::size_t chunk_ = 0;       // samples of a full one
  std::vector<double> values_;  // (columns x chunk_) of the chunk at hand
  std::size_t filled_ = 0;      // samples of it
  hsize_t begun_ = 0;           // number of its first sample
  hsize_t room_ = 0;            // samples that the data sets were made for
  std::optional<Hdf5Handle> hdf5_;
  std::vector<Hdf5Handle> sets_;  // (columns)
};

}  // namespace vehicle
