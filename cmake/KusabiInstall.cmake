# What `cmake --install` adds to the targets: the CMake package `kusabi`, what a user reads, and a
# project to start one's own from.
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/kusabi)
install(EXPORT kusabi NAMESPACE kusabi:: FILE kusabiTargets.cmake DESTINATION ${package})
configure_package_config_file(cmake/kusabiConfig.cmake.in ${PROJECT_BINARY_DIR}/kusabiConfig.cmake
  INSTALL_DESTINATION ${package})
# Before 1.0 any minor version may change what a user's project is written against.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kusabiConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/kusabiConfig.cmake ${PROJECT_BINARY_DIR}/kusabiConfigVersion.cmake
  cmake/FindGLPK.cmake cmake/FindQD.cmake
  DESTINATION ${package})

# Laid out as in the source tree, so that the links of one page to another hold.
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY tests/install/colouring DESTINATION ${CMAKE_INSTALL_DOCDIR}/tests/install)

# For PYTHONPATH, or to be copied beside a script: it is one file.
install(FILES run/python/kusabi.py DESTINATION ${CMAKE_INSTALL_DATADIR}/kusabi/python)
