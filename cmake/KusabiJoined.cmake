# Sources compiled together. Most of the time to compile a source goes into what it includes and what it
# instantiates of that; the sources of a group share both. Off, each source is compiled by itself,
# which is quicker when one of them has changed, and shows what it forgot to include.
option(KUSABI_JOINED "Compile related sources together: quicker from nothing, slower after a change" OFF)

# kusabi_join(TARGET PATTERN...): the target's sources that match the first pattern are one group, of
# the others those that match the second are the next, and so on; what matches none stays alone. Two
# sources of one group must not give one name to two things, in anonymous namespaces neither.
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
