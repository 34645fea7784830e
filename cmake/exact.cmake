# Sources that use CGAL (exact arithmetic) become an object library of their own: linking CGAL adds
# -frounding-math, which would slow the rest down. Only CGAL's LGPL parts may be used: with CGAL_LICENSE_ERROR
# a header of a GPL part does not compile. GMP and MPFR are named plainly, so that an installed static
# library passes them on to its users on any machine.
function(higherpair_add_exact_sources)
  find_package(CGAL 5.4 REQUIRED)
  add_library(higherpair_exact OBJECT ${ARGN})
  target_include_directories(higherpair_exact PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/include)
  target_compile_features(higherpair_exact PRIVATE cxx_std_20)
  # sign_at of CGAL 5.5 goes on with its interval when a refinement has made that a point: it finds no variation
  # of signs there, which is right, but its own checks do not allow it.
  target_compile_definitions(higherpair_exact PRIVATE CGAL_LICENSE_ERROR=1 CGAL_NDEBUG)
  target_link_libraries(higherpair_exact PRIVATE CGAL::CGAL Eigen3::Eigen tl::expected fmt::fmt)
  # It goes into the shared library where there is one; a static library stays free of the cost.
  set_target_properties(higherpair_exact PROPERTIES POSITION_INDEPENDENT_CODE ${BUILD_SHARED_LIBS})
  higherpair_set_warnings(higherpair_exact)
  higherpair_optimise_less(higherpair_exact -O1)
  # GCC 12 takes CGAL's reference counting for a use after free.
  target_compile_options(higherpair_exact PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-use-after-free>)
  target_link_libraries(higherpair PRIVATE $<BUILD_INTERFACE:higherpair_exact>)
  target_link_libraries(higherpair PRIVATE gmp mpfr)
endfunction()
