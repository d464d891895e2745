# Test of the installation: builds the installed copy of examples/engine against the installed engine,
# and two programs of docs/library.md against the other libraries, outside of the source tree, and
# runs them alone and on two ranks. Also calls the installed command. Variables: see CMakeLists.txt.
cmake_minimum_required(VERSION 3.22)

# Runs a command that must succeed; its output is in `printed`.
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
# Installed files contain no absolute paths, since packages are moved.
file(RENAME ${work}/staged ${work}/prefix)

set(flags "-Wall -Wextra -Wpedantic -Werror -H")
if(sanitize)
  # A library with a sanitizer requires the same sanitizer in the program.
  string(APPEND flags " -fsanitize=${sanitize}")
endif()
file(COPY ${work}/prefix/${documents}/examples/engine DESTINATION ${work})
run(${CMAKE_COMMAND} -S ${work}/engine -B ${work}/build -G "${generator}"
  -D MPI_C_COMPILER=${mpi_compiler}
  -D CMAKE_PREFIX_PATH=${work}/prefix -D CMAKE_CXX_COMPILER=${compiler} -D "CMAKE_CXX_FLAGS=${flags}")
run(${CMAKE_COMMAND} --build ${work}/build)
set(read "${printed}")

file(COPY ${work}/prefix/${documents}/examples/library DESTINATION ${work})
run(${CMAKE_COMMAND} -S ${work}/library -B ${work}/library/build -G "${generator}"
  -D MPI_C_COMPILER=${mpi_compiler}
  -D CMAKE_PREFIX_PATH=${work}/prefix -D CMAKE_CXX_COMPILER=${compiler} -D "CMAKE_CXX_FLAGS=${flags}")
run(${CMAKE_COMMAND} --build ${work}/library/build --target critical limit)
string(APPEND read "${printed}")

# With -H the compiler lists the headers of each of seven programs.
string(REGEX MATCHALL "\n\\.+ ${work}/prefix/[^ \n]*/engine/search.hpp" installed "${read}")
list(LENGTH installed count)
if(NOT count EQUAL 7 OR read MATCHES "${source}/(support|engine|solvers|problems|nodes|verify)/")
  message(FATAL_ERROR "compiled ${count} times, expected 7, with the installed headers alone")
endif()

# The eight queens have 92 placements; the graph is a triangle with a tail.
run(${work}/build/queens 8)
expect("92 placements.*1 rank,")
run(${mpiexec} ${ranks_flag} 2 ${work}/build/queens 8)
expect("92 placements")  # mpirun forwards both outputs in any order
expect("2 ranks,")
file(WRITE ${work}/graph "e 1 2\ne 2 3\ne 1 3\ne 3 4\n")
run(${mpiexec} ${ranks_flag} 2 ${work}/build/clique ${work}/graph --order best)
expect("clique of 3: 3 2 1\n")
foreach(call IN ITEMS "knapsack 24" "salesman 8" "cover 40")
  separate_arguments(call)
  list(POP_FRONT call program)
  run(${work}/build/${program} ${call} --quiet)
  set(alone "${printed}")
  run(${mpiexec} ${ranks_flag} 2 ${work}/build/${program} ${call} --quiet --order hybrid)
  if(NOT printed STREQUAL alone)
    message(FATAL_ERROR "expected: ${alone}")
  endif()
endforeach()

set(examples ${work}/prefix/${documents}/examples)
run(${work}/library/build/critical ${examples}/two-bars.toml)  # by hand: 2
expect("below 1\\.99999999.*, proved\nsomething does at 2\\.0000000.*, proved\n")
run(${work}/library/build/limit ${examples}/paper/limit-3x3.toml 40)  # tests/reference/limit.json
expect("worst case 37\\.012004.*, proved\n")

run(${work}/prefix/bin/kusabi patterns ${work}/prefix/${documents}/examples/two-bars.toml --mu 2)
expect("sign pattern")

# The same from Python; the coefficient is known by hand.
find_program(python3 python3)
if(python3)
  set(ENV{PYTHONPATH} ${work}/prefix/${python_folder})
  set(ENV{KUSABI} ${work}/prefix/bin/kusabi)
  run(${python3} -c "print(__import__('kusabi').run('critical', '${examples}/two-bars.toml').answer['critical_friction'])")
  expect("'lower': 1\\.99999999, 'upper': 2\\.00000001,")
endif()
file(READ ${work}/prefix/${documents}/docs/result.schema.json printed)
expect("json-schema\\.org")
