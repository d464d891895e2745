# Writes what the command says of itself: its manual pages, and what completes its calls.
#   cmake -D kusabi=COMMAND -D output=DIR -P told.cmake
cmake_minimum_required(VERSION 3.22)

# told(FILE ARGUMENT...): what the command prints
function(told file)
  execute_process(COMMAND ${kusabi} ${ARGN} OUTPUT_VARIABLE text RESULT_VARIABLE failed)
  if(failed)
    list(JOIN ARGN " " call)
    message(FATAL_ERROR "kusabi ${call} failed (${failed})")
  endif()
  file(WRITE ${output}/${file} "${text}")
  set(text "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${output}/man)
told(kusabi.bash --completion bash)
told(_kusabi --completion zsh)
told(kusabi.fish --completion fish)
told(man/kusabi.1 --manual)
# The sections of that page are the subcommands.
string(REGEX MATCHALL "\n\\.SS kusabi [^\n]*" sections "${text}")
foreach(section IN LISTS sections)
  string(REGEX REPLACE ".*\\.SS kusabi " "" name "${section}")
  string(REPLACE "\\-" "-" name "${name}")
  string(REPLACE " " "-" page "${name}")
  separate_arguments(words UNIX_COMMAND "${name}")
  told(man/kusabi-${page}.1 --manual ${words})
endforeach()
