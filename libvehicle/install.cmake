# The library as others find it: find_package(vehicle), then vehicle::vehicle or vehicle::<room>, and
# "libvehicle/<room>/<file>.h".
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/vehicle)

get_property(rooms GLOBAL PROPERTY vehicle_rooms)
# All rooms at once.
add_library(vehicle_all INTERFACE)
add_library(vehicle::vehicle ALIAS vehicle_all)
set_target_properties(vehicle_all PROPERTIES EXPORT_NAME vehicle)
target_link_libraries(vehicle_all INTERFACE ${rooms})
install(TARGETS ${rooms} vehicle_all EXPORT vehicleTargets ARCHIVE FILE_SET HEADERS)
install(EXPORT vehicleTargets NAMESPACE vehicle:: DESTINATION ${package_dir})
configure_package_config_file(vehicleConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/vehicleConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
# Below 1.0 a new minor number may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/vehicleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES third_party.cmake ${CMAKE_CURRENT_BINARY_DIR}/vehicleConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/vehicleConfigVersion.cmake
        DESTINATION ${package_dir})
