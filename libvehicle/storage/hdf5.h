#pragma once

#include <filesystem>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/run_record.h"

namespace vehicle {

/// Writes a run as HDF5, to be opened by h5py, MATLAB, Octave or HDFView:
///
///     /                        attributes: version, form, method, step, ...  (text)
///     /history/time            data set (samples), attribute unit = "s"
///     /history/carbody.z       data set (samples), attribute unit = "m"; columns keep their order (creation order)
///     /inputs/1, 2, ...        data set (text of the file), attribute file = its name
///
/// Texts are of fixed length, ended by a zero; their bytes are UTF-8, marked as ASCII, the only kind that Octave reads.
/// Zeros have no sign.
/// The same record gives the same bytes: no time stamps. Columns are chunked, up to 8192 samples and 64 MiB of all columns at
/// a time. Written atomically (atomic_file.h); while a run goes, by history_writer.h.
/// May be called from several threads; they take turns.
/// @throws RunFailed             the file cannot be written; names the path and the system's or HDF5's reason
/// @throws std::invalid_argument the history has no columns or a value that is not finite; a column or attribute
///                               whose name HDF5 cannot hold (empty, ".", with "/"), or two of the same name; a
///                               text with a zero byte
void writeHdf5(const RunRecord& record, const std::filesystem::path& path);

/// Reads what writeHdf5 writes, bit for bit, and files whose texts have variable length, as it wrote them once. Problems:
/// no HDF5 file, a group or unit that is missing, columns of different lengths, values that are not finite.
[[nodiscard]] Outcome<RunRecord> readHdf5(const std::filesystem::path& path);

/// Whether a file has the groups that writeHdf5 writes; columns are not read.
[[nodiscard]] bool isHdf5Run(const std::filesystem::path& path);

}  // namespace vehicle
