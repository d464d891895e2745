# kusabi_installed(NAME): installs the library kusabi_NAME of this folder with its headers as target
# kusabi::NAME of the CMake package. Header paths are those of the source tree: "problems/files/…".
include(GNUInstallDirs)
function(kusabi_installed name)
  set(target kusabi_${name})
  get_target_property(type ${target} TYPE)
  set(scope PUBLIC)
  if(type STREQUAL "INTERFACE_LIBRARY")
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope}
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/kusabi>)
  target_compile_features(${target} ${scope} cxx_std_20)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  add_library(kusabi::${name} ALIAS ${target})
  install(TARGETS ${target} EXPORT kusabi COMPONENT development)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  install(DIRECTORY . DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/kusabi/${folder}
    COMPONENT development FILES_MATCHING PATTERN "*.hpp")
endfunction()
