#pragma once

#include <exception>

#include "libvehicle/storage/atomic_file.h"
#include "libvehicle/storage/hdf5_handle.h"

namespace vehicle {

/// An atomic file as HDF5 writes it. HDF5 must not meet a full disk: it cannot close a file that it could not write. So the
/// first failure is kept here, and HDF5 hears that all is well; who calls HDF5 looks for it afterwards.
struct Hdf5Target {
  AtomicFile& file;
  std::exception_ptr failure = nullptr;

  /// @throws RunFailed, the first failure
  void check() const {
    if (failure) std::rethrow_exception(failure);
  }
};

/// File access for H5Fcreate() that leads to the target, which must outlive the file. Its name is then only a label.
/// @throws Hdf5Error
[[nodiscard]] Hdf5Handle accessTo(Hdf5Target& target);

}  // namespace vehicle
