# Warnings for our own code; what dependencies do in their headers is theirs (they are SYSTEM includes).
# With Clang -Wconversion has -Wsign-conversion in it, which GCC leaves out of it: indices may be ints.
# The sanitize preset switches -Wmaybe-uninitialized off: sanitizers make GCC see uses that are none.
# GCC 12 at -O3 sees moves of strings overrun their bounds within the standard library's own headers; with precompiled
# headers it no longer knows that these are not ours.
function(higherpair_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion
                                           $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow>
                                           $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)
  if(HIGHERPAIR_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
