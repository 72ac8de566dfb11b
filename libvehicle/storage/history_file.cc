#include "libvehicle/storage/history_file.h"

#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/storage/csv.h"
#include "libvehicle/storage/file_identity.h"
#include "libvehicle/storage/hdf5.h"

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

}  // namespace vehicle
