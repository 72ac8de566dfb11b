# Libraries that come without a target of their own, wrapped once. The build includes this file, and so does the
# installed vehicleConfig.cmake: whoever links a static room needs the same libraries again.

# HDF5 by its own name: CMake's FindHDF5 would ask every C++ project that uses vehicle to enable C as well.
if(NOT TARGET vehicle_hdf5)
  find_path(VEHICLE_HDF5_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial)
  find_library(VEHICLE_HDF5_LIBRARY hdf5 PATH_SUFFIXES hdf5/serial)
  mark_as_advanced(VEHICLE_HDF5_INCLUDE_DIR VEHICLE_HDF5_LIBRARY)
  if(VEHICLE_HDF5_INCLUDE_DIR AND VEHICLE_HDF5_LIBRARY)
    add_library(vehicle_hdf5 INTERFACE IMPORTED GLOBAL)
    target_include_directories(vehicle_hdf5 SYSTEM INTERFACE ${VEHICLE_HDF5_INCLUDE_DIR})
    target_link_libraries(vehicle_hdf5 INTERFACE ${VEHICLE_HDF5_LIBRARY})
  endif()
endif()

# hwloc (where cores and caches are) comes with a pkg-config file only.
if(NOT TARGET vehicle_hwloc)
  find_path(VEHICLE_HWLOC_INCLUDE_DIR hwloc.h)
  find_library(VEHICLE_HWLOC_LIBRARY hwloc)
  mark_as_advanced(VEHICLE_HWLOC_INCLUDE_DIR VEHICLE_HWLOC_LIBRARY)
  if(VEHICLE_HWLOC_INCLUDE_DIR AND VEHICLE_HWLOC_LIBRARY)
    add_library(vehicle_hwloc INTERFACE IMPORTED GLOBAL)
    target_include_directories(vehicle_hwloc SYSTEM INTERFACE ${VEHICLE_HWLOC_INCLUDE_DIR})
    target_link_libraries(vehicle_hwloc INTERFACE ${VEHICLE_HWLOC_LIBRARY})
  endif()
endif()

# find_package(Simbody) names its targets without a namespace and gives them no include folder.
if(NOT TARGET vehicle_simbody AND Simbody_FOUND)
  add_library(vehicle_simbody INTERFACE IMPORTED GLOBAL)
  target_include_directories(vehicle_simbody SYSTEM INTERFACE ${Simbody_INCLUDE_DIR})
  target_link_libraries(vehicle_simbody INTERFACE SimTKsimbody SimTKmath SimTKcommon)
endif()
