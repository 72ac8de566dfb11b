# vehicle_room(NAME USES rooms... PUBLIC libraries... PRIVATE libraries...)
#
# One room = one folder = one static library vehicle_NAME (alias vehicle::NAME). Its folder's CMakeLists.txt
# calls vehicle_files(). A call along an arrow that USES does not name does not link where a test links the
# room alone; the test `layering` reads the includes as well.

add_library(vehicle_warnings INTERFACE)
# clang counts signs among the conversions; g++ does so in C only, and an index of Eigen has one.
target_compile_options(vehicle_warnings INTERFACE -Wall -Wextra -Wconversion -Wshadow
                                                  $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)

function(vehicle_room name)
  cmake_parse_arguments(room "" "" "USES;PUBLIC;PRIVATE" ${ARGN})
  if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/CMakeLists.txt)
    message(FATAL_ERROR "room ${name}: ${name}/CMakeLists.txt is missing")
  endif()
  set(target vehicle_${name})
  add_library(${target} STATIC)
  add_library(vehicle::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON LINKER_LANGUAGE CXX)
  target_compile_features(${target} PUBLIC cxx_std_20)
  list(TRANSFORM room_USES PREPEND vehicle_)
  target_link_libraries(${target} PUBLIC ${room_USES} ${room_PUBLIC}
                        PRIVATE ${room_PRIVATE} $<BUILD_INTERFACE:vehicle_warnings>)
  set_property(GLOBAL APPEND PROPERTY vehicle_rooms ${target})
  add_subdirectory(${name})
  vehicle_unity(${target})
endfunction()

# vehicle_files(HEADERS ... SOURCES ...): the files of the room whose folder calls it.
function(vehicle_files)
  cmake_parse_arguments(files "" "" "HEADERS;SOURCES" ${ARGN})
  get_filename_component(name ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  target_sources(vehicle_${name} PRIVATE ${files_SOURCES})
  target_sources(vehicle_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${files_HEADERS})
endfunction()
