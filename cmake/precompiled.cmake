# Headers of others that most sources include, parsed once a target. They only save time: every source includes what
# it uses, which tools/check proves by compiling without them (CMAKE_DISABLE_PRECOMPILE_HEADERS).
set(HIGHERPAIR_PRECOMPILED
    <algorithm> <array> <cassert> <charconv> <cmath> <cstddef> <cstdint> <functional> <limits> <map> <memory> <numeric>
    <optional> <set> <span> <string> <string_view> <utility> <variant> <vector>
    <Eigen/Core> <Eigen/LU> <Eigen/QR> <fmt/core.h> <tl/expected.hpp>)

# For a target of its own, with the headers named after it as well.
function(higherpair_precompile target)
  target_precompile_headers(${target} PRIVATE ${HIGHERPAIR_PRECOMPILED} ${ARGN})
endfunction()

# Those of a part of the library that is compiled alike. GCC asks for the same definitions, and so for the same
# libraries; the code of a shared library differs from a program's.
function(higherpair_precompile_like target part)
  if(BUILD_SHARED_LIBS)
    higherpair_precompile(${target})
  else()
    target_link_libraries(${target} PRIVATE $<TARGET_PROPERTY:${part},LINK_LIBRARIES>)
    target_precompile_headers(${target} REUSE_FROM ${part})
  endif()
endfunction()
