# Tests are compiled without optimisation, which takes half of the compile time, under the sanitizers
# a third. The libraries under test are optimised as in a release.
set(KUSABI_TEST_OPTIONS $<$<CONFIG:Release>:-O0>)
if(KUSABI_SANITIZE)
  set(KUSABI_TEST_OPTIONS -O0)
endif()

# GNU gold, where it is installed, links a test in a third of the time.
find_program(KUSABI_GOLD ld.gold)
mark_as_advanced(KUSABI_GOLD)
if(KUSABI_GOLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_link_options(-fuse-ld=gold)
endif()

# Precompiled headers for nearly all tests.
kusabi_precompile(kusabi_test_headers
  OPTIONS ${KUSABI_TEST_OPTIONS}
  LIBRARIES GTest::gmock Eigen3::Eigen
  HEADERS <gmock/gmock.h> <gtest/gtest.h> <Eigen/Core>)

# kusabi_test(NAME SOURCES a.cpp b.cpp LIBRARIES x y): one GoogleTest executable for a folder.
# JOINED: patterns of the sources that are compiled together, as in kusabi_join; default: all.
# PROCESSES: the tests start processes and do not get the label `fast`.
# OWN_OPTIONS: the tests have other compile options, so they use no precompiled headers.
# LONG: GoogleTest filter of tests that take a minute. They start first; sanitized builds omit them.
function(kusabi_test name)
  cmake_parse_arguments(TEST "PROCESSES;OWN_OPTIONS" "LONG" "SOURCES;LIBRARIES;JOINED" ${ARGN})
  add_executable(${name} ${TEST_SOURCES})
  if(NOT TEST_JOINED)
    set(TEST_JOINED ".")
  endif()
  kusabi_join(${name} ${TEST_JOINED})
  target_compile_options(${name} PRIVATE ${KUSABI_TEST_OPTIONS})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${name} PRIVATE ${TEST_LIBRARIES} kusabi_build GTest::gmock GTest::gtest_main)
  if(NOT TEST_OWN_OPTIONS)
    kusabi_reuse_headers(${name} kusabi_test_headers)
  endif()
  target_compile_definitions(${name} PRIVATE
    KUSABI_SOURCE_DIR="${CMAKE_CURRENT_FUNCTION_LIST_DIR}/.." ${KUSABI_TEST_DEFINITIONS})
  include(GoogleTest)
  set(label LABELS fast)
  if(TEST_PROCESSES)
    set(label COST 10)
  endif()
  if(NOT TEST_LONG)
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300 ${label})
    return()
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 TEST_FILTER "-${TEST_LONG}" TEST_LIST ${name}_short
    PROPERTIES TIMEOUT 300 ${label})
  if(NOT KUSABI_SANITIZE)
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 TEST_FILTER "${TEST_LONG}" TEST_LIST ${name}_long
      PROPERTIES TIMEOUT 300 LABELS long COST 300)
  endif()
endfunction()

# Environment of tests under mpirun. Open MPI runs as root (in CI), accepts more ranks than cores,
# does not bind ranks to cores (PRTE_... from version 5 on), and does not yield its core at every
# empty poll, which makes oversubscribed runs several times slower. Other launchers ignore these
# variables.
set(KUSABI_MPI_ENVIRONMENT
  OMPI_ALLOW_RUN_AS_ROOT=1
  OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  OMPI_MCA_rmaps_base_oversubscribe=1
  OMPI_MCA_hwloc_base_binding_policy=none
  PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
  PRTE_MCA_hwloc_default_binding_policy=none
  OMPI_MCA_mpi_yield_when_idle=0
  OMPI_MCA_btl_vader_single_copy_mechanism=none
  KUSABI_MPIRUN=${MPIEXEC_EXECUTABLE}
  # No leak detection, since Open MPI leaks memory; tests without MPI detect leaks of Kusabi.
  ASAN_OPTIONS=detect_leaks=0)
