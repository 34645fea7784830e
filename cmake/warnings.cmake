# Warnings for our own code; what dependencies do in their headers is theirs (they are SYSTEM includes).
# The sanitize preset switches -Wmaybe-uninitialized off: sanitizers make GCC see uses that are none.
# GCC 12 at -O3 sees moves of strings overrun their bounds within the standard library's own headers; with precompiled
# headers it no longer knows that these are not ours.
function(higherpair_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion
                                           $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow>)
  if(HIGHERPAIR_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
