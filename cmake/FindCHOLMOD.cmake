# Finds CHOLMOD of SuiteSparse, which has no CMake package before its version 7, and the BLAS:
# header, libraries, version. Defines the target CHOLMOD::CHOLMOD. CHOLMOD is under the GNU LGPL
# 2.1 or later, its supernodal factorisation, which is used here, under the GNU GPL 2 or later.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
find_library(CHOLMOD_BLAS_LIBRARY NAMES blas openblas)
if(CHOLMOD_INCLUDE_DIR)
  file(GLOB headers ${CHOLMOD_INCLUDE_DIR}/cholmod.h ${CHOLMOD_INCLUDE_DIR}/cholmod_core.h)
  set(CHOLMOD_VERSION "")
  foreach(header IN LISTS headers)
    file(STRINGS ${header} lines REGEX "define CHOLMOD_(MAIN|SUB|SUBSUB)_VERSION +[0-9]")
    foreach(part MAIN SUB SUBSUB)
      if("${lines}" MATCHES "CHOLMOD_${part}_VERSION +([0-9]+)")
        list(APPEND CHOLMOD_VERSION ${CMAKE_MATCH_1})
      endif()
    endforeach()
  endforeach()
  list(JOIN CHOLMOD_VERSION "." CHOLMOD_VERSION)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD
  REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_INCLUDE_DIR CHOLMOD_BLAS_LIBRARY VERSION_VAR CHOLMOD_VERSION
  REASON_FAILURE_MESSAGE
  "CHOLMOD of SuiteSparse and a BLAS are needed (Debian: libsuitesparse-dev, libopenblas-serial-dev)")
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY CHOLMOD_BLAS_LIBRARY)
if(CHOLMOD_FOUND AND NOT TARGET CHOLMOD::CHOLMOD)
  add_library(CHOLMOD::CHOLMOD UNKNOWN IMPORTED)
  set_target_properties(CHOLMOD::CHOLMOD PROPERTIES
    IMPORTED_LOCATION ${CHOLMOD_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${CHOLMOD_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES ${CHOLMOD_BLAS_LIBRARY})
endif()
