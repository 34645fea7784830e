# The page of `report`: its sources in web/ are bundled by esbuild, which npm fetches as the lock file says, into
# one file of HTML that becomes a source of the library. Without node and npm, or where npm cannot fetch, the rest
# builds all the same, and `report` says what is missing.
set(HIGHERPAIR_REPORT AUTO CACHE STRING "The page of `report`, by node and npm: ON, OFF, or AUTO (where they are)")
set_property(CACHE HIGHERPAIR_REPORT PROPERTY STRINGS AUTO ON OFF)

set(report_folder ${PROJECT_BINARY_DIR}/web)
set(report_source ${PROJECT_BINARY_DIR}/report_page.cpp)
set(report_missing "")
if(NOT HIGHERPAIR_REPORT)
  set(report_missing "it was built with HIGHERPAIR_REPORT=OFF")
else()
  find_program(HIGHERPAIR_NODE node)
  find_program(HIGHERPAIR_NPM npm)
  mark_as_advanced(HIGHERPAIR_NODE HIGHERPAIR_NPM)
  if(NOT HIGHERPAIR_NODE OR NOT HIGHERPAIR_NPM)
    set(report_missing "node or npm was not found when it was built")
    if(NOT HIGHERPAIR_REPORT STREQUAL "AUTO")
      message(FATAL_ERROR "HIGHERPAIR_REPORT=ON needs node and npm (tools/setup installs them)")
    endif()
  endif()
endif()

file(GLOB report_inputs CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/*.json ${PROJECT_SOURCE_DIR}/web/*.mjs
     ${PROJECT_SOURCE_DIR}/web/src/*)
add_custom_command(
  OUTPUT ${report_source}
  COMMAND
    ${CMAKE_COMMAND} "-DNODE=${HIGHERPAIR_NODE}" "-DNPM=${HIGHERPAIR_NPM}" "-DMISSING=${report_missing}"
    -DREQUIRED=${HIGHERPAIR_REPORT} -DTESTS=${HIGHERPAIR_BUILD_TESTS} -DSOURCES=${PROJECT_SOURCE_DIR}/web
    -DFOLDER=${report_folder} -DOUTPUT=${report_source} -P ${CMAKE_CURRENT_LIST_DIR}/build_report_page.cmake
  DEPENDS ${CMAKE_CURRENT_LIST_DIR}/build_report_page.cmake ${report_inputs}
  COMMENT "Bundling the page of reports"
  VERBATIM)
add_custom_target(report_page DEPENDS ${report_source})
target_sources(higherpair PRIVATE ${report_source})
add_dependencies(higherpair report_page)
