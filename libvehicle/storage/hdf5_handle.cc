#include "libvehicle/storage/hdf5_handle.h"

namespace vehicle {

namespace {

// HDF5 may be built without thread safety, and two files in memory must not be open at once under one name: a
// mutex for the whole process mirrors the library's own global state.
std::mutex& hdf5Mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

Hdf5Turn::Hdf5Turn() : lock_(hdf5Mutex()) {
  H5Eget_auto2(H5E_DEFAULT, &printer_, &printer_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Turn::~Hdf5Turn() { H5Eset_auto2(H5E_DEFAULT, printer_, printer_data_); }

std::string hdf5Reason() {
  std::string reason = "HDF5 gives no reason";
  const auto innermost = [](unsigned depth, const H5E_error2_t* error, void* text) -> herr_t {
    if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, innermost, &reason);
  return reason;
}

}  // namespace vehicle
