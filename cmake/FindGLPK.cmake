# Finds GLPK, which has no CMake package: header, library, version. Defines the target GLPK::GLPK.
find_path(GLPK_INCLUDE_DIR glpk.h PATH_SUFFIXES glpk)
find_library(GLPK_LIBRARY glpk)
if(GLPK_INCLUDE_DIR)
  file(STRINGS ${GLPK_INCLUDE_DIR}/glpk.h version_lines REGEX "define GLP_M[AI][JN]OR_VERSION")
  string(REGEX REPLACE ".*MAJOR_VERSION *([0-9]+).*" "\\1" GLPK_VERSION_MAJOR "${version_lines}")
  string(REGEX REPLACE ".*MINOR_VERSION *([0-9]+).*" "\\1" GLPK_VERSION_MINOR "${version_lines}")
  set(GLPK_VERSION ${GLPK_VERSION_MAJOR}.${GLPK_VERSION_MINOR})
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GLPK
  REQUIRED_VARS GLPK_LIBRARY GLPK_INCLUDE_DIR VERSION_VAR GLPK_VERSION
  REASON_FAILURE_MESSAGE "the GNU Linear Programming Kit is needed (Debian: libglpk-dev)")
mark_as_advanced(GLPK_INCLUDE_DIR GLPK_LIBRARY)
if(GLPK_FOUND AND NOT TARGET GLPK::GLPK)
  add_library(GLPK::GLPK UNKNOWN IMPORTED)
  set_target_properties(GLPK::GLPK PROPERTIES
    IMPORTED_LOCATION ${GLPK_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${GLPK_INCLUDE_DIR})
endif()
