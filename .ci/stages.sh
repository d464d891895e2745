# Stages that .ci/run and .ci/nightly share. Sourced by both; not a command of its own.
source "$(dirname "${BASH_SOURCE[0]}")/../tools/prepare.sh"

# stage NAME COMMAND...: runs it, and notes how many seconds passed and how many the cores were busy.
shopt -s inherit_errexit
TIMEFORMAT='%0R %0U %0S'
spent=()
stage() {
  local name=$1 times
  shift
  say "$name"
  exec 3>&1 4>&2
  times=$( { time "$@" >&3 2>&4; } 2>&1 )
  exec 3>&- 4>&-
  read -r wall user system <<<"$times"
  spent+=("$(printf '%6d %6d  %s' "$wall" $((user + system)) "$name")")
}

say_what_was_spent() {
  say "seconds, and seconds of the cores together"
  printf '%s\n' "${spent[@]}"
}

install_for_ci() {
  install_missing "${build_packages[@]}" "${test_packages[@]}" clang libclang-rt-dev clang-format clang-tidy git reuse valgrind
}

format() { clang-format --dry-run -Werror "${sources[@]}"; }

# Seconds: layout of the code, tables and terms of the documentation, format.
check_layout() {
  local listed
  listed=$(git ls-files '*.cpp' '*.hpp') || give_up "git cannot list the sources; is this a clone, and yours?"
  [[ -n "$listed" ]] || give_up "git lists no sources: nothing would be checked"
  mapfile -t sources <<<"$listed"
  stage "includes between the modules" .ci/check_arrows
  stage "table of tolerances" .ci/check_tolerances
  stage "vocabulary" .ci/check_words
  stage "words of proof" .ci/check_proof_words
  stage "names that are brought in and not used" .ci/check_using "${sources[@]}"
  stage "licence of each file" reuse lint --quiet
  stage "clang-format" format
}

# Sources that were compiled in build/, where most are joined. Tests are left out, since
# GoogleTest's headers would take as long again, and what only measures.
compiled_sources() {
  sed -n "s#^ *\"file\": \"$PWD/\(.*\)\".*#\1#p" build/compile_commands.json |
    grep -vE '^(build/)?(tests|mpi_tests|bench|headers)/|cmake_pch' || give_up "build/ lists no sources to lint"
}

# lint SOURCE...: shadowed names are GCC's to report; clang also counts the constants of other joined
# sources. It does not read the precompiled headers of GCC, nor know its parameters.
lint() {
  mkdir -p build/lint
  sed 's# -Winvalid-pch -include [^ ]*cmake_pch.hxx##; s# --param=ggc[^ ]*##' build/compile_commands.json \
    >build/lint/compile_commands.json
  printf '%s\n' "$@" | xargs -P "$(nproc)" -n 1 clang-tidy -p build/lint --quiet --extra-arg=-Wno-shadow \
    --warnings-as-errors='*'
}

# build_sanitized TARGET...: with the CMake options in sanitized_options, if there are any.
sanitized_options=()
build_sanitized() {
  local ninja=()
  if [[ ! -e build-sanitize/CMakeCache.txt ]]; then ninja=(-G Ninja); fi
  cmake --preset sanitize "${ninja[@]}" "${sanitized_options[@]}" >/dev/null
  cmake --build --preset sanitize --parallel "$(nproc)" --target "$@"
}
