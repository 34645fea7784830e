# Configures the release build as on a machine with MPI and has the build tool read it: the other tests only see the
# build that this machine's packages give.
#   cmake -D WORK_DIR=… -D SOURCE_DIR=… -D GENERATOR=… -D COMPILER=… -P check.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${WORK_DIR})
set(working_directory ${SOURCE_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

run(${CMAKE_COMMAND}
    -S ${SOURCE_DIR}
    -B ${WORK_DIR}
    -G ${GENERATOR}
    -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_UNITY_BUILD=ON
    -D CMAKE_MODULE_PATH=${CMAKE_CURRENT_LIST_DIR}
    -D HIGHERPAIR_BUILD_TESTS=OFF)
run(${CMAKE_COMMAND} --build ${WORK_DIR} --target help)
if(NOT output MATCHES "higherpair-sweep-mpi")
  message(FATAL_ERROR "the build has no higherpair-sweep-mpi:\n${output}")
endif()
