# Runs a command in working_directory; its output is in `output`. Where it fails, so does the test, which shows both.
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${working_directory} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "${command}\nfailed (${result}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()
