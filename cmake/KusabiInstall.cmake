# Installed files besides the targets: the CMake package `kusabi`, pages, examples and a sample
# project.
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/kusabi)
install(EXPORT kusabi NAMESPACE kusabi:: FILE kusabiTargets.cmake DESTINATION ${package} COMPONENT development)
configure_package_config_file(cmake/kusabiConfig.cmake.in ${PROJECT_BINARY_DIR}/kusabiConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kusabiConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/kusabiConfig.cmake ${PROJECT_BINARY_DIR}/kusabiConfigVersion.cmake
  cmake/FindCHOLMOD.cmake cmake/FindGLPK.cmake cmake/FindQD.cmake
  DESTINATION ${package} COMPONENT development)

# pkg-config files: kusabi for all libraries, kusabi-engine for the engine alone. The prefix is
# relative to the file, so an installation may be moved.
file(RELATIVE_PATH KUSABI_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
list(TRANSFORM MPI_C_INCLUDE_DIRS PREPEND -I OUTPUT_VARIABLE KUSABI_PC_MPI_FLAGS)
list(JOIN KUSABI_PC_MPI_FLAGS " " KUSABI_PC_MPI_FLAGS)
list(JOIN MPI_C_LIBRARIES " " KUSABI_PC_MPI_LIBRARIES)
foreach(name kusabi kusabi-engine)
  configure_file(cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endforeach()

# The layout is that of the source tree, so that links between pages are valid.
install(FILES README.md NEWS.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)

# A single file, for PYTHONPATH or for the folder of a script.
install(FILES run/python/kusabi.py run/python/mesh_file.py DESTINATION ${CMAKE_INSTALL_DATADIR}/kusabi/python COMPONENT command)
install(FILES verify/second_checker.py verify/second_checker_loads.py DESTINATION ${CMAKE_INSTALL_DATADIR}/kusabi/verify COMPONENT command)

include(cmake/KusabiPackages.cmake)
