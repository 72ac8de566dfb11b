#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/storage/atomic_file.h"
#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/hdf5_handle.h"

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

// What HDF5 could not hold is the caller's mistake and told before anything is composed.
void requireStorable(const RunRecord& record) {
  requireStorable(record.history);
  std::vector<std::string> columns;
  for (const Channel& column : record.history.columns()) {
    columns.push_back(column.name);
    requireText("a unit", column.unit);
  }
  requireNames("column", columns);
  std::vector<std::string> attributes;
  for (const auto& [name, value] : record.attributes) {
    attributes.push_back(name);
    requireText(fmt::format("attribute \"{}\"", name), value);
  }
  requireNames("attribute", attributes);
  for (const InputFile& input : record.inputs) {
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

Hdf5Handle createDataSet(hid_t group, const std::string& name, hid_t type, hid_t space) {
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  checked(H5Pset_obj_track_times(properties, false));
  return {H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose};
}

void writeHistoryGroup(hid_t file, const TimeHistory& history) {
  const Hdf5Handle group = createGroup(file, "history");
  const hsize_t samples = history.samples();
  const Hdf5Handle space(H5Screate_simple(1, &samples, nullptr), H5Sclose);
  for (std::size_t j = 0; j < history.columns().size(); ++j) {
    const Channel& column = history.columns()[j];
    const Hdf5Handle set = createDataSet(group, column.name, H5T_IEEE_F64LE, space);
    std::vector<double> values = history.column(j);
    for (double& each : values) each += 0.0;  // -0 + 0 = 0
    if (samples > 0) checked(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    writeTextAttribute(set, "unit", column.unit);
  }
}

void writeInputsGroup(hid_t file, const std::vector<InputFile>& inputs) {
  const Hdf5Handle group = createGroup(file, "inputs");
  const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Hdf5Handle type = textType(inputs[i].text);
    const Hdf5Handle set = createDataSet(group, std::to_string(i + 1), type, scalar);
    checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, inputs[i].text.c_str()));
    writeTextAttribute(set, "file", inputs[i].name);
  }
}

// The bytes of the whole file. The name is only a label: the core driver without backing store touches no disk.
std::string compose(const RunRecord& record) {
  const Hdf5Turn turn;
  constexpr std::size_t kGrowth = 1 << 20;
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  checked(H5Pset_fapl_core(access, kGrowth, false));
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  checked(H5Pset_attr_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  checked(H5Pset_obj_track_times(creation, false));
  const Hdf5Handle file(H5Fcreate("run record in memory", H5F_ACC_TRUNC, creation, access), H5Fclose);
  for (const auto& [name, value] : record.attributes) writeTextAttribute(file, name, value);
  writeHistoryGroup(file, record.history);
  writeInputsGroup(file, record.inputs);
  checked(H5Fflush(file, H5F_SCOPE_GLOBAL));

  std::string image(static_cast<std::size_t>(checked(H5Fget_file_image(file, nullptr, 0))), '\0');
  checked(H5Fget_file_image(file, image.data(), image.size()));
  return image;
}

}  // namespace

void writeHdf5(const RunRecord& record, const std::filesystem::path& path) {
  requireStorable(record);
  AtomicFile file(path);
  try {
    file.write(compose(record));
  } catch (const Hdf5Error& error) {
    throw RunFailed(fmt::format("{}: cannot be composed: {}", path.string(), error.reason));
  }
  file.publish();
}

}  // namespace vehicle
