# Writes the commit into a header; the file is unchanged if the commit is. Each build runs
#   cmake -D source=DIR -D output=FILE [-D commit=TEXT] -P commit.cmake
# Without git (source archive, package) the header contains TEXT, or "unknown".
cmake_minimum_required(VERSION 3.22)
if(NOT commit)
  set(commit unknown)
  find_program(git git)
  if(git AND EXISTS ${source}/.git)
    execute_process(COMMAND ${git} -C ${source} describe --always --dirty --abbrev=12 --exclude=*
      OUTPUT_VARIABLE found RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT failed AND found)
      set(commit ${found})
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${output} CONTENT "#pragma once\n#define KUSABI_COMMIT \"@commit@\"\n" @ONLY)
