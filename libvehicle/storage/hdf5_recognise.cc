#include "libvehicle/storage/hdf5.h"
#include "libvehicle/storage/hdf5_handle.h"

namespace vehicle {

bool isHdf5Run(const std::filesystem::path& path) {
  const Hdf5Turn turn;
  try {
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    // In this order: a path whose group is missing is an error to HDF5.
    for (const char* name : {"/history", "/history/time", "/inputs"}) {
      if (checked(H5Lexists(file, name, H5P_DEFAULT)) == 0) return false;
    }
    return true;
  } catch (const Hdf5Error&) {
    return false;
  }
}

}  // namespace vehicle
