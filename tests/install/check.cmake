# Installs the built library, moves the installation, then configures, builds and runs the second project
# against it.
#   cmake -D BUILD_DIR=… -D SOURCE_DIR=… -D CONFIG=… -D GENERATOR=… -D COMPILER=… -D FLAGS=… -P check.cmake
cmake_minimum_required(VERSION 3.25)

set(work ${BUILD_DIR}/install_test)
file(REMOVE_RECURSE ${work})

set(working_directory ${BUILD_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${work}/installed --config ${CONFIG})
file(RENAME ${work}/installed ${work}/moved)

# The package must not contain paths of the machine that built it.
file(GLOB_RECURSE package_files ${work}/moved/*.cmake)
if(NOT package_files)
  message(FATAL_ERROR "no package files are installed")
endif()
cmake_path(GET SOURCE_DIR PARENT_PATH tests_dir)
cmake_path(GET tests_dir PARENT_PATH higherpair_dir)
foreach(file IN LISTS package_files)
  file(READ ${file} text)
  foreach(path ${BUILD_DIR} ${higherpair_dir} ${work})
    string(FIND "${text}" "${path}" place)
    if(NOT place EQUAL -1)
      message(FATAL_ERROR "${file} names ${path}")
    endif()
  endforeach()
endforeach()

run(${CMAKE_COMMAND}
    -S ${SOURCE_DIR}
    -B ${work}/build
    -G ${GENERATOR}
    -D CMAKE_BUILD_TYPE=${CONFIG}
    -D CMAKE_CXX_COMPILER=${COMPILER}
    "-DCMAKE_CXX_FLAGS=${FLAGS}"
    -D CMAKE_PREFIX_PATH=${work}/moved
    -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(${CMAKE_COMMAND} --build ${work}/build --config ${CONFIG})
set(working_directory ${higherpair_dir})
run(${work}/build/second_project)
if(NOT output MATCHES "^361 rows, the whole path is good\nhighest at driver = ")
  message(FATAL_ERROR "the second project printed: ${output}")
endif()

# If the program was built, it runs from its installed place, and finds its modules there.
if(EXISTS ${work}/moved/bin/higherpair)
  run(${work}/moved/bin/higherpair --version)
  set(profile ${higherpair_dir}/profiles/four_bar.toml)
  file(GLOB_RECURSE modules RELATIVE ${work}/moved ${work}/moved/*.so)
  if(modules MATCHES "higherpair-pictures.so")
    run(${work}/moved/bin/higherpair draw ${profile} -o ${work}/four_bar.pdf)
  endif()
  if(modules MATCHES "higherpair-hdf5.so")
    run(${work}/moved/bin/higherpair analyze ${profile} --hdf5 ${work}/four_bar.h5)
  endif()
endif()
