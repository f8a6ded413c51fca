# Three components, so that a prefix can hold the shared library, the static one, or both:
# development (headers, CMake package, pkg-config file), shared, static.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/legacy_gl)

install(
  DIRECTORY legacy_gl/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/legacy_gl
  COMPONENT development
  FILES_MATCHING
  PATTERN "*.h"
  PATTERN "*.hpp")

foreach(kind IN ITEMS shared static)
  install(
    TARGETS legacy_gl_${kind}
    EXPORT legacy_gl_${kind}_targets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${kind}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${kind})
  install(
    EXPORT legacy_gl_${kind}_targets
    NAMESPACE legacy_gl::
    DESTINATION ${package_dir}
    COMPONENT ${kind})
endforeach()

configure_package_config_file(
  cmake/legacy_glConfig.cmake.in ${PROJECT_BINARY_DIR}/legacy_glConfig.cmake
  INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/legacy_glConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
file(RELATIVE_PATH pkgconfig_to_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(cmake/legacy_gl.pc.in ${PROJECT_BINARY_DIR}/legacy_gl.pc @ONLY)

install(
  FILES ${PROJECT_BINARY_DIR}/legacy_glConfig.cmake
        ${PROJECT_BINARY_DIR}/legacy_glConfigVersion.cmake
  DESTINATION ${package_dir}
  COMPONENT development)
install(
  FILES ${PROJECT_BINARY_DIR}/legacy_gl.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)
