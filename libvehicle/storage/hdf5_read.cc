#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/hdf5_handle.h"
#include "libvehicle/storage/read_file.h"

namespace vehicle {

namespace {

// A file that HDF5 reads and that still is no run record.
[[noreturn]] void refuse(std::string reason) { throw Hdf5Error{std::move(reason)}; }

// A text of fixed length: up to its first zero, or to the padding at its end.
template <class Read>
std::string readFixedText(hid_t type, const Read& read) {
  std::string text(H5Tget_size(type), '\0');
  checked(read(text.data()));
  const bool padded = H5Tget_strpad(type) == H5T_STR_SPACEPAD;
  const std::size_t end = padded ? text.find_last_not_of(' ') + 1 : text.find('\0');
  if (end < text.size()) text.resize(end);
  return text;
}

// The text behind an open attribute or data set, of fixed length or of variable (as this program wrote them once);
// `read` moves it out of HDF5.
template <class Read>
std::string readText(hid_t type, hid_t space, std::string_view what, const Read& read) {
  if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1) {
    refuse(fmt::format("{} is no single text", what));
  }
  if (checked(H5Tis_variable_str(type)) == 0) return readFixedText(type, read);
  char* text = nullptr;
  checked(read(&text));
  std::string copy = text != nullptr ? text : "";
  H5free_memory(text);
  return copy;
}

std::string readTextAttribute(hid_t owner, const std::string& name, std::string_view of) {
  if (checked(H5Aexists(owner, name.c_str())) == 0) refuse(fmt::format("{} has no attribute \"{}\"", of, name));
  const Hdf5Handle attribute(H5Aopen(owner, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  return readText(type, space, fmt::format("attribute \"{}\"", name),
                  [&](void* text) { return H5Aread(attribute, type, text); });
}

// Names in the order in which they were created; an exception must not pass through HDF5's C frames, so the
// callbacks only collect.
std::vector<std::string> linkNames(hid_t group) {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  checked(H5Literate(group, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, collect, &names));
  return names;
}

std::vector<std::string> attributeNames(hid_t owner) {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  checked(H5Aiterate2(owner, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, collect, &names));
  return names;
}

Hdf5Handle openGroup(hid_t file, const char* name) {
  if (checked(H5Lexists(file, name, H5P_DEFAULT)) == 0) {
    refuse(fmt::format("has no group \"{}\": it is no run that vehicle wrote", name));
  }
  return {H5Gopen2(file, name, H5P_DEFAULT), H5Gclose};
}

std::vector<double> readColumn(hid_t set, const std::string& name) {
  const Hdf5Handle space(H5Dget_space(set), H5Sclose);
  if (checked(H5Sget_simple_extent_ndims(space)) != 1) refuse(fmt::format("column \"{}\" is no list of numbers", name));
  std::vector<double> values(static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space))));
  if (!values.empty()) checked(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) refuse(fmt::format("column \"{}\", sample {}: is no finite number", name, i));
  }
  return values;
}

TimeHistory readHistoryGroup(hid_t file) {
  const Hdf5Handle group = openGroup(file, "history");
  std::vector<Channel> channels;
  std::vector<std::vector<double>> columns;
  for (const std::string& name : linkNames(group)) {
    const Hdf5Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
    channels.push_back({name, readTextAttribute(set, "unit", fmt::format("column \"{}\"", name))});
    columns.push_back(readColumn(set, name));
    if (columns.back().size() != columns.front().size()) {
      refuse(fmt::format("column \"{}\" has {} samples, \"{}\" has {}", name, columns.back().size(),
                         channels.front().name, columns.front().size()));
    }
  }
  if (channels.empty() || channels.front() != Channel{"time", "s"}) refuse("the first column is not \"time\" in \"s\"");

  TimeHistory history(std::vector<Channel>(channels.begin() + 1, channels.end()));
  history.reserve(columns.front().size());
  for (std::size_t i = 0; i < columns.front().size(); ++i) {
    const std::span<double> row = history.append(columns.front()[i]);
    for (std::size_t j = 1; j < columns.size(); ++j) row[j] = columns[j][i];
  }
  return history;
}

std::vector<InputFile> readInputsGroup(hid_t file) {
  const Hdf5Handle group = openGroup(file, "inputs");
  std::vector<InputFile> inputs;
  for (const std::string& name : linkNames(group)) {
    const Hdf5Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Hdf5Handle type(H5Dget_type(set), H5Tclose);
    const Hdf5Handle space(H5Dget_space(set), H5Sclose);
    const std::string what = fmt::format("input file {}", name);
    std::string text =
        readText(type, space, what, [&](void* out) { return H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out); });
    inputs.push_back({readTextAttribute(set, "file", what), std::move(text)});
  }
  return inputs;
}

RunRecord parse(std::string& image) {
  const Hdf5Turn turn;
  constexpr std::size_t kGrowth = 1 << 20;
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  checked(H5Pset_fapl_core(access, kGrowth, false));
  checked(H5Pset_file_image(access, image.data(), image.size()));
  const Hdf5Handle file(H5Fopen("run record in memory", H5F_ACC_RDONLY, access), H5Fclose);
  RunRecord record;
  for (const std::string& name : attributeNames(file)) {
    record.attributes.emplace_back(name, readTextAttribute(file, name, "the file"));
  }
  record.history = readHistoryGroup(file);
  record.inputs = readInputsGroup(file);
  return record;
}

}  // namespace

Outcome<RunRecord> readHdf5(const std::filesystem::path& path) {
  Outcome<RunRecord> outcome;
  Outcome<std::string> bytes = readFile(path);
  outcome.problems = bytes.problems;
  if (!bytes.ok()) return outcome;
  try {
    if (!bytes.value->starts_with("\x89HDF\r\n\x1a\n")) refuse("is no HDF5 file");
    outcome.value = parse(*bytes.value);
  } catch (const Hdf5Error& error) {
    const Place place{path.string(), 0};
    outcome.problems.add({place, "", error.reason, ""});
  }
  return outcome;
}

}  // namespace vehicle
