# Modules of the command-line program: libraries that it loads when it needs them (tools/cli/module.hpp). In the build
# they lie beside the program, where it is installed in lib/higherpair; it looks for them in both places.
function(higherpair_add_module name source)
  add_library(${name} MODULE ${source})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_link_libraries(${name} PRIVATE Eigen3::Eigen tl::expected fmt::fmt ${ARGN})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/include ${CMAKE_CURRENT_SOURCE_DIR})
  set_target_properties(${name} PROPERTIES PREFIX "" UNITY_BUILD OFF)
  higherpair_set_warnings(${name})
  install(TARGETS ${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/higherpair)
endfunction()

function(higherpair_find_modules program)
  file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(${program} PROPERTIES BUILD_RPATH "$ORIGIN" INSTALL_RPATH
                                              "${CMAKE_INSTALL_RPATH};$ORIGIN/${bin_to_lib}/higherpair")
  target_link_libraries(${program} PRIVATE ${CMAKE_DL_LIBS})
  foreach(module higherpair-pictures higherpair-hdf5)
    if(TARGET ${module})
      add_dependencies(${program} ${module})
    endif()
  endforeach()
endfunction()
