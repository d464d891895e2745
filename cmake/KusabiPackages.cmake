# Debian packages, made by tools/package (cpack -G DEB): kusabi (command, manual pages, completion),
# libkusabi-dev (libraries, headers) and kusabi-doc (pages, examples).
set(KUSABI_MAINTAINER "Kusabi's maintainers <maintainers@kusabi.invalid>" CACHE STRING
  "Maintainer of the Debian packages")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kusabi)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "${KUSABI_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL command development documents)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Copyright, changelog, compression and permissions of each package as Debian requires.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/finish.cmake)
set(CPACK_KUSABI_SOURCE ${PROJECT_SOURCE_DIR})

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME kusabi)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS "openmpi-bin, libopenblas0-serial")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "kusabi-doc, libkusabi-dev, python3, graphviz, paraview")
set(CPACK_DEBIAN_COMMAND_DESCRIPTION
"wedged configurations and worst-case limit loads
Kusabi finds all wedged configurations of an elastic structure in contact with
a rigid obstacle under Coulomb friction, the smallest friction coefficient at
which one exists, and the worst-case limit load factor of a truss with
uncertain loads. Each answer comes with a proof; the tree search runs in
parallel under MPI.

This package contains the command, its manual pages and shell completion.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libkusabi-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libopenmpi-dev, libboost-serialization-dev, libeigen3-dev, libfmt-dev, libglpk-dev, libgmp-dev, libmpfr-dev, libopenblas-serial-dev | libblas-dev, libqd-dev, libsuitesparse-dev, libtomlplusplus-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "kusabi-doc, cmake, pkgconf")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"parallel tree search and its uses in mechanics (C++ libraries)
Libraries of the command kusabi for C++20: a generic parallel tree search on
MPI, and analyses of wedged configurations and worst-case limit loads.

This package contains static libraries, headers, a CMake package and files for
pkg-config.")

set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_NAME kusabi-doc)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOCUMENTS_DESCRIPTION
"wedged configurations and worst-case limit loads (documentation)
Manual of the command kusabi and its libraries: theory, verification, file
formats, example problem files and example programs.")
include(CPack)
