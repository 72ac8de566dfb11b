# cmake -D BUILD=... -D CONSUMER=... -D PAGE=... -D WORK=... -D GENERATOR=... -D COMPILER=... -D MODELS=...
#       -P install_and_use.cmake
#
# Installs BUILD to an empty prefix under WORK; configures, builds and runs against nothing but that prefix the project
# CONSUMER, which links rooms, and that of PAGE (docs/how-to/use-the-library.md), which links all of them.
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

function(build_project source build)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${build} -G ${GENERATOR}
                          -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Debug
                  COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The text between "```language" and "```" of the page becomes a file.
function(extract language file)
  file(READ ${PAGE} page)
  string(FIND "${page}" "\n```${language}\n" begin)
  if(begin LESS 0)
    message(FATAL_ERROR "${PAGE} has no block ```${language}")
  endif()
  string(LENGTH "\n```${language}\n" head)
  math(EXPR begin "${begin} + ${head}")
  string(SUBSTRING "${page}" ${begin} -1 code)
  string(FIND "${code}" "```" end)
  string(SUBSTRING "${code}" 0 ${end} code)
  file(WRITE ${file} "${code}")
endfunction()

set(files ${MODELS}/vehicles/al-oraiqat-2017.xml ${MODELS}/scenarios/paper-20mps.xml)
build_project(${CONSUMER} ${WORK}/build)
execute_process(COMMAND ${WORK}/build/consumer ${files} ${WORK}/run.csv ${WORK}/run.json OUTPUT_VARIABLE said
                COMMAND_ERROR_IS_FATAL ANY)
if(NOT said STREQUAL "flat, exact: 2001 samples\n")
  message(FATAL_ERROR "the consumer said \"${said}\", expected \"flat, exact: 2001 samples\"")
endif()
file(READ ${WORK}/run.json page)
string(JSON speed GET "${page}" facts speed value)
if(NOT speed EQUAL 20)
  message(FATAL_ERROR "the consumer's page has the speed ${speed}, expected 20")
endif()
file(SIZE ${WORK}/run.csv size)
if(size LESS 100000)
  message(FATAL_ERROR "the consumer wrote ${size} bytes; 2001 samples of a vehicle are more")
endif()

extract(cmake ${WORK}/page/CMakeLists.txt)
extract(cpp ${WORK}/page/main.cc)
build_project(${WORK}/page ${WORK}/page_build)
execute_process(COMMAND ${WORK}/page_build/peak ${files} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
# The installed command finds the same peak; the page prints four decimals, rounded, of which these are cut.
execute_process(COMMAND ${WORK}/prefix/bin/vehicle simulate ${files} --format csv OUTPUT_VARIABLE table
                ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
if(NOT table MATCHES "carbody.az,m/s\\^2,[^,]*,[^,]*,([0-9]*)\\.([0-9][0-9][0-9][0-9])")
  message(FATAL_ERROR "no peak of carbody.az in ${table}")
endif()
set(cut 1${CMAKE_MATCH_1}${CMAKE_MATCH_2})  # the 1 keeps zeros in front
math(EXPR next "${cut} + 1")
if(NOT said MATCHES "^carbody.az: peak ([0-9]*)\\.([0-9][0-9][0-9][0-9]) m/s\\^2 at [0-9.]+ s\n$")
  message(FATAL_ERROR "the program of the page said \"${said}\"")
endif()
set(peak 1${CMAKE_MATCH_1}${CMAKE_MATCH_2})
if(NOT peak EQUAL cut AND NOT peak EQUAL next)
  message(FATAL_ERROR "the program of the page said \"${said}\", the command 1e-4 times ${cut}, without its first 1")
endif()
