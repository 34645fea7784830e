# The step of the build that bundles the page, in cases where that is not possible.
set(script ${SOURCES}/cmake/build_report_page.cmake)
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/web)

# expect_step(WHAT EXPECTED TEXT OPTIONS...): the step ends as expected, and its output or source contains the
# text.
function(expect_step what expected text)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -DSOURCES=${SOURCES}/web -DFOLDER=${FOLDER}/web -DOUTPUT=${FOLDER}/page.cpp -DTESTS=OFF
            ${ARGN} -P ${script}
    RESULT_VARIABLE result
    OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  set(source "")
  if(EXISTS ${FOLDER}/page.cpp)
    file(READ ${FOLDER}/page.cpp source)
  endif()
  string(FIND "${source}${output}" "${text}" at)
  if(NOT result EQUAL expected OR at EQUAL -1)
    message(SEND_ERROR "${what}: ${result}, not ${expected}, or no '${text}' in:\n${output}\n${source}")
  endif()
  file(REMOVE ${FOLDER}/page.cpp)
endfunction()

expect_step("without node there is a source without a page" 0 "node was not found" "-DMISSING=node was not found"
            -DREQUIRED=AUTO)
expect_step("where npm fails the rest builds" 0 "npm ci failed when it was built" -DMISSING= -DREQUIRED=AUTO
            -DNODE=${FOLDER}/none -DNPM=${FOLDER}/none)
expect_step("where the page is wanted a failure of npm fails the build" 1 "npm ci failed" -DMISSING= -DREQUIRED=ON
            -DNODE=${FOLDER}/none -DNPM=${FOLDER}/none)
