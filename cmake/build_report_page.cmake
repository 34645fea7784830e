# Run by the build. Bundles the page of SOURCES in FOLDER, by NODE and NPM, and writes it as OUTPUT, a source of C++.
# MISSING: why that is not possible; empty: it is. With REQUIRED=ON a failure fails the build, else it is written down.
function(write_source page missing)
  file(
    WRITE ${OUTPUT}
    "#include \"front/report/report_page.hpp\"\n\nnamespace higherpair {\n\n"
    "std::string_view report_page() {\n  return R\"~page~(${page})~page~\";\n}\n\n"
    "std::string_view report_page_missing() {\n  return \"${missing}\";\n}\n\n}  // namespace higherpair\n")
endfunction()

# Sets failure in the caller where the command fails.
function(run what)
  execute_process(
    COMMAND ${ARGN}
    WORKING_DIRECTORY ${FOLDER}
    RESULT_VARIABLE result
    OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(${severity} "${what} failed:\n${output}")
    set(failure "${what} failed when it was built" PARENT_SCOPE)
  endif()
endfunction()

set(severity WARNING)
if(REQUIRED AND NOT REQUIRED STREQUAL "AUTO")
  set(severity FATAL_ERROR)
endif()
set(failure "${MISSING}")
if(failure STREQUAL "")
  file(REMOVE_RECURSE ${FOLDER}/src)
  file(COPY ${SOURCES}/ DESTINATION ${FOLDER} PATTERN node_modules EXCLUDE)
  # What the lock file names is fetched once.
  file(SHA256 ${SOURCES}/package-lock.json lock)
  set(fetched "")
  if(EXISTS ${FOLDER}/fetched)
    file(READ ${FOLDER}/fetched fetched)
  endif()
  if(NOT fetched STREQUAL "${lock} ${TESTS}")
    set(omit "")
    if(NOT TESTS)
      set(omit --omit=dev)
    endif()
    run("npm ci" ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error ${omit})
    if(failure STREQUAL "")
      file(WRITE ${FOLDER}/fetched "${lock} ${TESTS}")
    endif()
  endif()
endif()
set(page "")
if(failure STREQUAL "")
  run("bundling the page" ${NODE} build.mjs page.html)
  if(failure STREQUAL "")
    file(READ ${FOLDER}/page.html page)
  endif()
endif()
write_source("${page}" "${failure}")
