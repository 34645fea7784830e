# `cmake --install`: the library, its headers, and a package for find_package(higherpair CONFIG). A room of
# tools installs its own program.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/higherpair)
install(
  TARGETS higherpair
  EXPORT higherpair-targets
  FILE_SET HEADERS)
install(
  EXPORT higherpair-targets
  NAMESPACE higherpair::
  DESTINATION ${package_dir})
configure_package_config_file(cmake/higherpair-config.cmake.in higherpair-config.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(higherpair-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/higherpair-config.cmake ${PROJECT_BINARY_DIR}/higherpair-config-version.cmake
        DESTINATION ${package_dir})
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

# An installed program finds the shared library beside it.
if(BUILD_SHARED_LIBS)
  file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set(CMAKE_INSTALL_RPATH $ORIGIN/${bin_to_lib})
endif()
