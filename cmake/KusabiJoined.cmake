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
