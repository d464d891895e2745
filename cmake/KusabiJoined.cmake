# Joined (unity) builds. Included headers and their template instantiations take most of the compile
# time of a source; the sources of a group share them. With the option off each source is compiled
# alone: a build after a change is faster, and missing includes are errors.
option(KUSABI_JOINED "Compile related sources together: a full build is faster, a build after a change slower" OFF)

# kusabi_join(TARGET PATTERN...): sources that match the first pattern form the first group, those
# of the others that match the second pattern form the second, and so on; sources that match no
# pattern are compiled alone. Names must be unique within a group, also in anonymous namespaces.
function(kusabi_join target)
  if(NOT KUSABI_JOINED)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS sources)
    set(number 0)
    foreach(pattern IN LISTS ARGN)
      math(EXPR number "${number} + 1")
      if(source MATCHES "${pattern}")
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${number})
        break()
      endif()
    endforeach()
  endforeach()
endfunction()

# kusabi_precompile(OWNER OPTIONS ... LIBRARIES ... HEADERS ...): compiles headers once for the targets
# that kusabi_reuse_headers(TARGET OWNER) names later, which have equal compile options and at least
# these libraries. Joined builds only: ccache does not reuse objects that were compiled with
# precompiled headers, and a build without them finds missing includes.
function(kusabi_precompile owner)
  cmake_parse_arguments(ONCE "" "" "OPTIONS;LIBRARIES;HEADERS" ${ARGN})
  if(NOT KUSABI_JOINED)
    return()
  endif()
  set(source ${PROJECT_BINARY_DIR}/headers/${owner}.cpp)
  file(WRITE ${source}.new "// Empty: this source exists for the headers included before it.\n")
  configure_file(${source}.new ${source} COPYONLY)
  add_library(${owner} OBJECT EXCLUDE_FROM_ALL ${source})
  target_compile_options(${owner} PRIVATE ${ONCE_OPTIONS})
  target_link_libraries(${owner} PRIVATE kusabi_build ${ONCE_LIBRARIES})
  target_precompile_headers(${owner} PRIVATE ${ONCE_HEADERS})
endfunction()

function(kusabi_reuse_headers target owner)
  if(NOT KUSABI_JOINED)
    return()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
  # GCC 12 warns about system headers that are precompiled, such as that of std::string.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow>)
endfunction()

# Library headers that most sources of the program include.
set(KUSABI_COMMON_HEADERS
  LIBRARIES fmt::fmt Eigen3::Eigen Boost::serialization
  HEADERS
    <algorithm> <array> <charconv> <cmath> <filesystem> <functional> <map> <memory> <numeric> <optional>
    <set> <span> <sstream> <string> <string_view> <tuple> <utility> <variant> <vector>
    <fmt/format.h> <fmt/ranges.h> <Eigen/Core> <Eigen/SparseCore>
    <boost/archive/binary_iarchive.hpp> <boost/archive/binary_oarchive.hpp> <boost/serialization/vector.hpp>)
kusabi_precompile(kusabi_headers ${KUSABI_COMMON_HEADERS})
