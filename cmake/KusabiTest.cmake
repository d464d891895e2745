# One GoogleTest executable a folder of tests:  kusabi_test(NAME SOURCES a.cpp b.cpp LIBRARIES x y)
function(kusabi_test name)
  cmake_parse_arguments(TEST "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${TEST_SOURCES})
  # What is tested is optimised as users have it; the tests themselves take half as long to compile.
  # (GCC 12 warns of Eigen's own code then.)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1;-Wno-maybe-uninitialized>)
  target_link_libraries(${name} PRIVATE ${TEST_LIBRARIES} kusabi_build GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE
    KUSABI_SOURCE_DIR="${CMAKE_CURRENT_FUNCTION_LIST_DIR}/..")
  include(GoogleTest)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
endfunction()

# Open MPI is told by environment variables, which other launchers ignore, to run as root (CI does),
# to put more ranks than cores on a machine, not to pin ranks to cores that others use as well, and
# not to hand its core over at every empty poll (which makes crowded runs several times slower).
set(KUSABI_MPI_ENVIRONMENT
  OMPI_ALLOW_RUN_AS_ROOT=1
  OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  OMPI_MCA_rmaps_base_oversubscribe=1
  OMPI_MCA_hwloc_base_binding_policy=none
  OMPI_MCA_mpi_yield_when_idle=0
  OMPI_MCA_btl_vader_single_copy_mechanism=none
  # Open MPI itself never returns some of what it allocates; our own leaks show without it.
  ASAN_OPTIONS=detect_leaks=0)
