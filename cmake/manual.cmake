# Manual pages and completion scripts, as printed by the command.
#   cmake -D kusabi=COMMAND -D output=DIR -P manual.cmake
cmake_minimum_required(VERSION 3.22)

# print_to(FILE ARGUMENT...): writes the output of a call
function(print_to file)
  execute_process(COMMAND ${kusabi} ${ARGN} OUTPUT_VARIABLE text RESULT_VARIABLE failed)
  if(failed)
    list(JOIN ARGN " " call)
    message(FATAL_ERROR "kusabi ${call} failed (${failed})")
  endif()
  file(WRITE ${output}/${file} "${text}")
  set(text "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${output}/man)
print_to(kusabi.bash --completion bash)
print_to(_kusabi --completion zsh)
print_to(kusabi.fish --completion fish)
print_to(man/kusabi.1 --manual)
# Sections of that page are the subcommands.
string(REGEX MATCHALL "\n\\.SS kusabi [^\n]*" sections "${text}")
foreach(section IN LISTS sections)
  string(REGEX REPLACE ".*\\.SS kusabi " "" name "${section}")
  string(REPLACE "\\-" "-" name "${name}")
  string(REPLACE " " "-" page "${name}")
  separate_arguments(words UNIX_COMMAND "${name}")
  print_to(man/kusabi-${page}.1 --manual ${words})
endforeach()
