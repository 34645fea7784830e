# Warnings for our own code; what dependencies do in their headers is theirs (they are SYSTEM includes).
# The sanitize preset switches -Wmaybe-uninitialized off: sanitizers make GCC see uses that are none.
function(higherpair_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion)
  if(HIGHERPAIR_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
