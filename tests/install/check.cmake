# Test of the installation: builds programs of the installed copies of examples/engine and
# examples/library against the installed libraries, outside of the source tree, and runs them alone
# and on two ranks. Also calls the installed command. Variables: see CMakeLists.txt.
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
# Two projects of users in one build, not optimised. Every night all of their programs that the build
# of Kusabi does not contain, as they are shipped.
set(programs queens clique critical)
set(kind -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG=-O0)
if(thorough)
  list(APPEND programs knapsack salesman cover limit)
  set(kind)
endif()
file(COPY ${work}/prefix/${documents}/examples/engine ${work}/prefix/${documents}/examples/library DESTINATION ${work})
file(WRITE ${work}/CMakeLists.txt "cmake_minimum_required(VERSION 3.22)
project(users LANGUAGES C CXX)
add_subdirectory(engine)
add_subdirectory(library)
")
run(${CMAKE_COMMAND} -S ${work} -B ${work}/build -G "${generator}" -D MPI_C_COMPILER=${mpi_compiler} ${kind}
  -D CMAKE_PREFIX_PATH=${work}/prefix -D CMAKE_CXX_COMPILER=${compiler} -D "CMAKE_CXX_FLAGS=${flags}")
run(${CMAKE_COMMAND} --build ${work}/build --parallel 2 --target ${programs})

# With -H the compiler lists the headers of each program.
string(REGEX MATCHALL "\n\\.+ ${work}/prefix/[^ \n]*/engine/search.hpp" installed "${printed}")
list(LENGTH installed count)
list(LENGTH programs wanted)
if(NOT count EQUAL wanted OR printed MATCHES "${source}/(support|engine|solvers|problems|nodes|verify)/")
  message(FATAL_ERROR "compiled ${count} times, expected ${wanted}, with the installed headers alone")
endif()

# The eight queens have 92 placements; the graph is a triangle with a tail.
run(${work}/build/engine/queens 8)
expect("92 placements.*1 rank,")
run(${mpiexec} ${ranks_flag} 2 ${work}/build/engine/queens 8)
expect("92 placements")  # mpirun forwards both outputs in any order
expect("2 ranks,")
file(WRITE ${work}/graph "e 1 2\ne 2 3\ne 1 3\ne 3 4\n")
run(${mpiexec} ${ranks_flag} 2 ${work}/build/engine/clique ${work}/graph --order best)
expect("clique of 3: 3 2 1\n")
set(calls "knapsack 24" "salesman 8" "cover 40")
if(NOT thorough)
  set(calls)
endif()
foreach(call IN LISTS calls)
  separate_arguments(call)
  list(POP_FRONT call program)
  run(${work}/build/engine/${program} ${call} --quiet)
  set(alone "${printed}")
  run(${mpiexec} ${ranks_flag} 2 ${work}/build/engine/${program} ${call} --quiet --order hybrid)
  if(NOT printed STREQUAL alone)
    message(FATAL_ERROR "expected: ${alone}")
  endif()
endforeach()

set(examples ${work}/prefix/${documents}/examples)
run(${work}/build/library/critical ${examples}/two-bars.toml)  # by hand: 2
expect("below 1\\.99999999.*, proved\nsomething does at 2\\.0000000.*, proved\n")
if(thorough)
  run(${work}/build/library/limit ${examples}/paper/limit-3x3.toml 40)  # tests/reference/limit.json
  expect("worst case 37\\.012004.*, proved\n")
endif()

run(${work}/prefix/bin/kusabi patterns ${work}/prefix/${documents}/examples/two-bars.toml --mu 2)
expect("sign pattern")

# The same from Python; the coefficient is known by hand.
find_program(python3 python3)
if(python3)
  set(ENV{PYTHONPATH} ${work}/prefix/${python_folder})
  set(ENV{KUSABI} ${work}/prefix/bin/kusabi)
  run(${python3} -c "print(__import__('kusabi').run('critical', '${examples}/two-bars.toml').answer['critical_friction'])")
  expect("'lower': {'value': 1\\.99999999, 'standing': 'proved'}, 'upper': {'value': 2\\.00000001,")
endif()
file(READ ${work}/prefix/${documents}/docs/result.schema.json printed)
expect("json-schema\\.org")
