#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/hdf5_writer.h"

namespace vehicle {

namespace {

void requireText(std::string_view what, const std::string& text) {
  if (text.find('\0') == std::string::npos) return;
  throw std::invalid_argument(fmt::format("run record: {} holds a zero byte, must be text", what));
}

void requireNames(std::string_view what, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (name.empty() || name == "." || name.find('/') != std::string::npos || name.find('\0') != std::string::npos) {
      throw std::invalid_argument(
          fmt::format("run record: {} \"{}\" is no name in HDF5; must not be empty, \".\" or hold \"/\"", what, name));
    }
    if (!seen.insert(name).second) throw std::invalid_argument(fmt::format("run record: {} \"{}\" twice", what, name));
  }
}

// What HDF5 could not hold is the caller's mistake and refused before anything is written of it.
void requireColumns(const std::vector<Channel>& columns) {
  std::vector<std::string> names;
  for (const Channel& column : columns) {
    names.push_back(column.name);
    requireText("a unit", column.unit);
  }
  requireNames("column", names);
}

void requireDescription(const RunDescription& description) {
  std::vector<std::string> names;
  for (const auto& [name, value] : description.attributes) {
    names.push_back(name);
    requireText(fmt::format("attribute \"{}\"", name), value);
  }
  requireNames("attribute", names);
  for (const InputFile& input : description.inputs) {
    requireText("an input file's name", input.name);
    requireText(fmt::format("input file \"{}\"", input.name), input.text);
  }
}

// Fixed length with its terminating zero, so that an empty text has a byte too. Octave gives up a whole file for one data
// set of another kind: of variable length, or marked as UTF-8. So the bytes are UTF-8, and the mark is ASCII.
Hdf5Handle textType(const std::string& text) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  checked(H5Tset_size(type, text.size() + 1));
  checked(H5Tset_strpad(type, H5T_STR_NULLTERM));
  checked(H5Tset_cset(type, H5T_CSET_ASCII));
  return type;
}

void writeTextAttribute(hid_t owner, const std::string& name, const std::string& value) {
  const Hdf5Handle type = textType(value);
  const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate2(owner, name.c_str(), type, scalar, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  checked(H5Awrite(attribute, type, value.c_str()));
}

Hdf5Handle createGroup(hid_t file, const char* name) {
  const Hdf5Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  checked(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  checked(H5Pset_obj_track_times(properties, false));
  return {H5Gcreate2(file, name, H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose};
}

Hdf5Handle dataSetProperties() {
  Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  checked(H5Pset_obj_track_times(properties, false));
  return properties;
}

Hdf5Handle createText(hid_t group, const std::string& name, hid_t type) {
  const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  return {H5Dcreate2(group, name.c_str(), type, scalar, H5P_DEFAULT, dataSetProperties(), H5P_DEFAULT), H5Dclose};
}

/// A column that may shrink: a run may end early.
Hdf5Handle createColumn(hid_t group, const std::string& name, hsize_t samples, hsize_t chunk) {
  const hsize_t most = H5S_UNLIMITED;
  const Hdf5Handle space(H5Screate_simple(1, &samples, &most), H5Sclose);
  const Hdf5Handle properties = dataSetProperties();
  checked(H5Pset_chunk(properties, 1, &chunk));
  // Whole chunks are written once: a cache would only copy them.
  const Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  checked(H5Pset_chunk_cache(access, 1, 0, 1.0));
  return {H5Dcreate2(group, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, access), H5Dclose};
}

void writeInputsGroup(hid_t file, const std::vector<InputFile>& inputs) {
  const Hdf5Handle group = createGroup(file, "inputs");
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Hdf5Handle type = textType(inputs[i].text);
    const Hdf5Handle set = createText(group, std::to_string(i + 1), type);
    checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, inputs[i].text.c_str()));
    writeTextAttribute(set, "file", inputs[i].name);
  }
}

constexpr std::size_t kLongestChunk = 8192;           // samples: 64 KiB of a column
constexpr std::size_t kMostValues = 8 * 1024 * 1024;  // of all columns: 64 MiB, reached by 1024 columns

}  // namespace

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path) : shown_(path.string()), file_(path) {}

Hdf5Writer::~Hdf5Writer() { close(); }

// Handles are closed before the file, which HDF5 would else keep open.
void Hdf5Writer::close() {
  const Hdf5Turn turn;
  sets_.clear();
  hdf5_.reset();
}

template <class Work>
void Hdf5Writer::takeTurn(const Work& work) {
  try {
    const Hdf5Turn turn;
    work();
  } catch (const Hdf5Error& error) {
    target_.check();
    throw RunFailed(fmt::format("{}: cannot be composed: {}", shown_, error.reason));
  }
  target_.check();
}

void Hdf5Writer::begin(const std::vector<Channel>& columns, long samples) {
  requireColumns(columns);
  columns_ = columns;
  room_ = static_cast<hsize_t>(samples);
  chunk_ = std::clamp<std::size_t>(kMostValues / columns.size(), 1, kLongestChunk);
  chunk_ = std::clamp<std::size_t>(static_cast<std::size_t>(samples), 1, chunk_);
  values_.resize(columns.size() * chunk_);
  takeTurn([&] {
    const Hdf5Handle access = accessTo(target_);
    const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    checked(H5Pset_attr_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    checked(H5Pset_obj_track_times(creation, false));
    hdf5_.emplace(H5Fcreate("run record", H5F_ACC_TRUNC, creation, access), H5Fclose);
    const Hdf5Handle group = createGroup(*hdf5_, "history");
    for (const Channel& column : columns_) {
      sets_.push_back(createColumn(group, column.name, room_, chunk_));
      writeTextAttribute(sets_.back(), "unit", column.unit);
    }
  });
}

void Hdf5Writer::add(std::span<const double> row) {
  requireStorable(columns_, row);
  double* value = values_.data() + filled_;
  for (const double each : row) {
    *value = each + 0.0;  // -0 + 0 = 0
    value += chunk_;
  }
  if (++filled_ == chunk_) takeTurn([&] { writeChunk(); });
}

void Hdf5Writer::writeChunk() {
  const hsize_t count = filled_;
  const Hdf5Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
  for (std::size_t j = 0; j < sets_.size(); ++j) {
    const Hdf5Handle space(H5Dget_space(sets_[j]), H5Sclose);
    checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, &begun_, nullptr, &count, nullptr));
    checked(H5Dwrite(sets_[j], H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values_.data() + j * chunk_));
  }
  begun_ += filled_;
  filled_ = 0;
}

void Hdf5Writer::finish(const RunDescription& description) {
  requireDescription(description);
  takeTurn([&] {
    if (filled_ > 0) writeChunk();
    for (const Hdf5Handle& set : sets_) {
      if (begun_ < room_) checked(H5Dset_extent(set, &begun_));
    }
    for (const auto& [name, value] : description.attributes) writeTextAttribute(*hdf5_, name, value);
    writeInputsGroup(*hdf5_, description.inputs);
    checked(H5Fflush(*hdf5_, H5F_SCOPE_GLOBAL));
  });
  close();
  target_.check();
  file_.finish();
}

void writeHdf5(const RunRecord& record, const std::filesystem::path& path) {
  requireStorable(record.history);
  const RunDescription description{record.attributes, record.inputs};
  requireDescription(description);
  Hdf5Writer(path).writeAll(record.history, description);
}

}  // namespace vehicle
