# higherpair-sweep-mpi where MPI is installed (libopenmpi-dev or another): a program beside `higherpair`, which
# does not need it. It is made of the objects of that one but for its main function.
function(higherpair_add_mpi_sweep target)
  set(MPI_CXX_SKIP_MPICXX ON)
  find_package(MPI QUIET COMPONENTS CXX)
  if(NOT MPI_CXX_FOUND)
    message(STATUS "No libopenmpi-dev: no higherpair-sweep-mpi")
    return()
  endif()
  find_package(Threads REQUIRED)
  add_executable(
    higherpair-sweep-mpi
    mpi/block_threads.cpp
    mpi/dispatcher.cpp
    mpi/main.cpp
    mpi/messages.cpp
    mpi/worker.cpp
    $<FILTER:$<TARGET_OBJECTS:${target}>,EXCLUDE,/main\\.cpp\\.o$>)
  target_include_directories(higherpair-sweep-mpi PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  # The list, not an expression for it: it contains one itself (precompiled.cmake), and CMake evaluates no nested ones.
  get_target_property(libraries ${target} LINK_LIBRARIES)
  target_link_libraries(higherpair-sweep-mpi PRIVATE ${libraries} MPI::MPI_CXX Threads::Threads)
  higherpair_find_modules(higherpair-sweep-mpi)
  higherpair_set_warnings(higherpair-sweep-mpi)
  higherpair_optimise_less(higherpair-sweep-mpi -Og)
  install(TARGETS higherpair-sweep-mpi)
endfunction()
