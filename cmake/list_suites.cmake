# Run after a test program is built: writes to OUTPUT one ctest entry for each suite of PROGRAM, named ROOM.suite.
# One for each test would start the program 1,900 times, which takes longer than most of the tests. The suites in LONG
# are started before the others.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)
# Suites begin a line, as `Instance/Suite.` or `Suite.  # TypeParam = …`; their tests are indented.
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${listing}")
if(NOT suites)
  message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()
set(entries "")
foreach(suite IN LISTS suites)
  string(REGEX MATCH "[A-Za-z0-9_/]+" suite "${suite}")
  string(APPEND entries "add_test([==[${ROOM}.${suite}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}.*]==]"
                        " --gtest_brief=1)\n")
  if(suite IN_LIST LONG)
    string(APPEND entries "set_tests_properties([==[${ROOM}.${suite}]==] PROPERTIES COST 10)\n")
    list(REMOVE_ITEM LONG ${suite})
  endif()
endforeach()
if(LONG)
  message(FATAL_ERROR "${PROGRAM} has no such suites: ${LONG}")
endif()
file(WRITE ${OUTPUT} "${entries}")
