#include "libvehicle/storage/hdf5_driver.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

namespace vehicle {

namespace {

/// The open file as HDF5 knows it: its own part first.
struct OpenFile {
  H5FD_t common{};
  Hdf5Target* target = nullptr;
  haddr_t allocated = 0;  // end of what HDF5 has given out
  haddr_t written = 0;    // end of what was written
};

OpenFile& ours(H5FD_t* file) { return *reinterpret_cast<OpenFile*>(file); }
const OpenFile& ours(const H5FD_t* file) { return *reinterpret_cast<const OpenFile*>(file); }

/// An exception must not pass through HDF5's C frames.
template <class Access>
void attempt(Hdf5Target& target, const Access& access) {
  if (target.failure) return;
  try {
    access();
  } catch (...) {
    target.failure = std::current_exception();
  }
}

H5FD_t* openFile(const char*, unsigned, hid_t access, haddr_t) {
  const void* info = H5Pget_driver_info(access);
  if (info == nullptr) return nullptr;
  auto* file = new OpenFile;
  file->target = *static_cast<Hdf5Target* const*>(info);
  return &file->common;
}

herr_t closeFile(H5FD_t* file) {
  delete &ours(file);
  return 0;
}

int compareFiles(const H5FD_t* a, const H5FD_t* b) { return a < b ? -1 : a > b ? 1 : 0; }

herr_t queryFile(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA;
  return 0;
}

haddr_t allocatedEnd(const H5FD_t* file, H5FD_mem_t) { return ours(file).allocated; }
haddr_t writtenEnd(const H5FD_t* file, H5FD_mem_t) { return ours(file).written; }

herr_t setAllocatedEnd(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  ours(file).allocated = end;
  return 0;
}

herr_t readFile(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t from, std::size_t size, void* bytes) {
  const std::span to(static_cast<char*>(bytes), size);
  std::ranges::fill(to, '\0');
  attempt(*ours(file).target, [&] { ours(file).target->file.readAt(from, to); });
  return 0;
}

herr_t writeFile(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t to, std::size_t size, const void* bytes) {
  OpenFile& open = ours(file);
  attempt(*open.target, [&] { open.target->file.writeAt(to, {static_cast<const char*>(bytes), size}); });
  open.written = std::max<haddr_t>(open.written, to + size);
  return 0;
}

// A reader refuses a file that ends before what HDF5 has given out.
herr_t truncateFile(H5FD_t* file, hid_t, hbool_t) {
  OpenFile& open = ours(file);
  if (open.written >= open.allocated) return 0;
  attempt(*open.target, [&] { open.target->file.writeAt(open.allocated - 1, std::string_view("\0", 1)); });
  open.written = open.allocated;
  return 0;
}

constexpr H5FD_mem_t kOneKind[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;

H5FD_class_t driver() {
  H5FD_class_t made{};
#ifdef H5FD_CLASS_VERSION
  made.version = H5FD_CLASS_VERSION;
  made.value = static_cast<H5FD_class_value_t>(512);  // of the range for drivers that are not registered anywhere
#endif
  made.name = "vehicle";
  made.maxaddr = (static_cast<haddr_t>(1) << 62) - 1;
  made.fc_degree = H5F_CLOSE_WEAK;
  made.fapl_size = sizeof(Hdf5Target*);
  made.open = openFile;
  made.close = closeFile;
  made.cmp = compareFiles;
  made.query = queryFile;
  made.get_eoa = allocatedEnd;
  made.set_eoa = setAllocatedEnd;
  made.get_eof = writtenEnd;
  made.read = readFile;
  made.write = writeFile;
  made.truncate = truncateFile;
  std::ranges::copy(kOneKind, made.fl_map);
  return made;
}

}  // namespace

Hdf5Handle accessTo(Hdf5Target& target) {
  static const H5FD_class_t kDriver = driver();
  const Hdf5Handle id(H5FDregister(&kDriver), H5FDunregister);
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  Hdf5Target* address = &target;
  checked(H5Pset_driver(access, id, &address));
  return access;
}

}  // namespace vehicle
