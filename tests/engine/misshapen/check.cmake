# Compiles every program in this folder. Its first line states the expected result: "// compiles",
# or "// error: " and a sentence that the first error must contain. Variables: see CMakeLists.txt
# above.
cmake_minimum_required(VERSION 3.22)

set(folder ${source}/tests/engine/misshapen)
set(call ${compiler} -std=c++20 -w -I${work} -I${source})

# Precompiled header of all programs. (A compiler that cannot use it reads the header again.)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work}/tests/engine/misshapen)
execute_process(COMMAND ${call} -x c++-header ${folder}/right.hpp
    -o ${work}/tests/engine/misshapen/right.hpp.gch
  COMMAND_ERROR_IS_FATAL ANY)

file(GLOB programs ${folder}/*.cpp)
set(wrong "")
foreach(program IN LISTS programs)
  file(STRINGS ${program} expected LIMIT_COUNT 1)
  execute_process(COMMAND ${call} -fsyntax-only ${program}
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
  string(REGEX MATCH "[^\n]*error: [^\n]*" first_error "${said}")
  get_filename_component(name ${program} NAME)
  if(expected STREQUAL "// compiles")
    if(NOT result EQUAL 0)
      string(APPEND wrong "${name} must compile: ${first_error}\n")
    endif()
  else()
    string(REGEX REPLACE "^// error: " "" sentence "${expected}")
    string(FIND "${first_error}" "${sentence}" found)
    if(found EQUAL -1)
      string(APPEND wrong "${name}: expected: ${sentence}\n  first error: ${first_error}\n")
    endif()
  endif()
endforeach()
list(LENGTH programs count)
if(count LESS 20)
  string(APPEND wrong "${folder}: ${count} programs; expected more\n")
endif()
if(wrong)
  message(FATAL_ERROR "${wrong}")
endif()
message("${count} programs, each with its error")
