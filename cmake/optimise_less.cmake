# What takes long to compile and little time to run: -O1, or -Og, in place of -O3.
function(higherpair_optimise_less target level)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
endfunction()
