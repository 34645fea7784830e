# Runs a program of docs/library.md and compares what it prints.
#   cmake -D PROGRAM=… -D EXPECTED=FILE -D ROOT=… -P check.cmake
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${PROGRAM} WORKING_DIRECTORY ${ROOT} RESULT_VARIABLE result OUTPUT_VARIABLE output
                ERROR_VARIABLE errors)
file(READ ${EXPECTED} expected)
if(NOT result EQUAL 0 OR NOT output STREQUAL expected)
  message(FATAL_ERROR "${PROGRAM} (${result}) printed:\n${output}${errors}\nand docs/library.md shows:\n${expected}")
endif()
