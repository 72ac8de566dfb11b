# cmake -D BUILD=... -D CONSUMER=... -D WORK=... -D GENERATOR=... -D COMPILER=... -D MODELS=... -P install_and_use.cmake
#
# Installs BUILD to an empty prefix under WORK, configures and builds CONSUMER with nothing but that prefix, runs it.
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G ${GENERATOR}
                        -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Debug
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/consumer ${MODELS}/vehicles/al-oraiqat-2017.xml
                        ${MODELS}/scenarios/paper-20mps.xml ${WORK}/run.csv
                OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
if(NOT said STREQUAL "flat, exact: 2001 samples\n")
  message(FATAL_ERROR "the consumer said \"${said}\", expected \"flat, exact: 2001 samples\"")
endif()
file(SIZE ${WORK}/run.csv size)
if(size LESS 100000)
  message(FATAL_ERROR "the consumer wrote ${size} bytes; 2001 samples of a vehicle are more")
endif()
