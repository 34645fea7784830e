# Warnings for our own code; what dependencies do in their headers is theirs (they are SYSTEM includes).
function(higherpair_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion)
  if(HIGHERPAIR_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
