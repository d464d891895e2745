# Installs the build, takes the installed copy of colouring/ out of the tree as a user would, builds
# it against the installed engine alone, and runs it in one process and on two ranks. Also calls the
# installed command. Variables: see CMakeLists.txt beside.
cmake_minimum_required(VERSION 3.22)

# The command must succeed; what it printed is in `printed`.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  message("${output}")
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
  set(printed "${output}" PARENT_SCOPE)
endfunction()

function(expect what)
  if(NOT printed MATCHES "${what}")
    message(FATAL_ERROR "expected: ${what}")
  endif()
endfunction()

file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/staged)
# What is installed must not know where: packages are moved.
file(RENAME ${work}/staged ${work}/prefix)

set(flags "-Wall -Wextra -Wpedantic -Werror -H")
if(sanitize)
  # A library built with a sanitizer links with nothing else.
  string(APPEND flags " -fsanitize=${sanitize}")
endif()
file(COPY ${work}/prefix/${documents}/tests/install/colouring DESTINATION ${work})
run(${CMAKE_COMMAND} -S ${work}/colouring -B ${work}/build -G "${generator}"
  -D MPI_C_COMPILER=${mpi_compiler}
  -D CMAKE_PREFIX_PATH=${work}/prefix -D CMAKE_CXX_COMPILER=${compiler} -D "CMAKE_CXX_FLAGS=${flags}")
run(${CMAKE_COMMAND} --build ${work}/build)

# The compiler has said which headers it read (-H).
if(printed MATCHES "${source}/engine/" OR NOT printed MATCHES "${work}/prefix/[^ \n]*/engine/search.hpp")
  message(FATAL_ERROR "compiled with other headers than the installed ones")
endif()

# The values of the Petersen graph's chromatic polynomial at 3 and 4.
run(${work}/build/colouring)
expect("120 colourings.*1 rank[^s].*dead ends: 48\n")
run(${mpiexec} ${ranks_flag} 2 ${work}/build/colouring)
expect("120 colourings.*2 ranks.*dead ends: 48\n")
run(${mpiexec} ${ranks_flag} 2 ${work}/build/colouring 4)
expect("12960 colourings.*2 ranks")

run(${work}/prefix/bin/kusabi patterns ${work}/prefix/${documents}/examples/two-bars.toml --mu 2)
expect("sign pattern")
