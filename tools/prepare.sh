# Installation of missing packages, and the build: functions that run/quickstart, run/test and other scripts source.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { printf '\n== %s\n' "$*"; }
give_up() { printf 'kusabi: %s\n' "$*" >&2; exit 1; }

# Packages that the program requires, by their names in Debian 12.
build_packages=(g++ cmake make ninja-build libopenmpi-dev openmpi-bin libboost-serialization-dev libeigen3-dev
  libfmt-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libgmp-dev libmpfr-dev libglpk-dev
  libqd-dev zlib1g-dev libsuitesparse-dev libopenblas-serial-dev)
# Further packages that the tests require.
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev python3 python3-jsonschema python3-numpy mkdocs)

# install_missing PACKAGE...: installs those that are not there yet.
install_missing() {
  local missing=() package
  if ! command -v dpkg-query >/dev/null; then
    say "dpkg-query is missing, so no package is installed; required are the contents of these Debian packages: $*"
    return
  fi
  for package in "$@"; do
    [[ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" == installed ]] ||
      missing+=("$package")
  done
  if [[ ${#missing[@]} -eq 0 ]]; then
    say "all required packages are installed"
    return
  fi
  say "installing with apt-get: ${missing[*]}"
  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    local ask="ask an administrator for: apt-get install ${missing[*]}"
    command -v sudo >/dev/null || give_up "sudo is missing, so an ordinary user cannot install packages; $ask"
    sudo true || give_up "sudo was refused; $ask"
    as_root=(sudo)
  fi
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get)
  # A fresh machine has no package lists, an old one has stale ones.
  "${apt[@]}" -q update || give_up "apt-get update failed; are the package sources reachable?"
  "${apt[@]}" -qy --no-install-recommends install "${missing[@]}" ||
    give_up "apt-get could not install: ${missing[*]}"
}

# build TARGET CMAKE_OPTION...: configures build/ and builds one target there. An existing build/ keeps its settings.
# A new one is configured for a single complete build: with joined sources, and with Ninja, which compiles a library
# before those that it links are complete.
build() {
  local target=$1
  shift
  say "building (Release, into build/)"
  mkdir -p build && [[ -w build ]] || give_up "build/ cannot be written to; was it made by another user?"
  local new=()
  if [[ ! -e build/CMakeCache.txt ]]; then
    new=(-DKUSABI_JOINED=ON)
    if command -v ninja >/dev/null; then new+=(-G Ninja); fi
  fi
  local log
  log=$(cmake -S . -B build "${new[@]}" -DCMAKE_BUILD_TYPE=Release "$@" 2>&1) ||
    { printf '%s\n' "$log" >&2; give_up "cmake could not configure the build"; }
  local begin=$SECONDS
  cmake --build build --target "$target" --parallel "$(nproc)" ||
    give_up "the build failed; the first error is above"
  say "built in $((SECONDS - begin)) s"
}

# Settings of Open MPI, which other launchers ignore: permission to run as root and with more ranks than cores; ranks
# are neither bound to cores nor yield them at every poll, since either costs time on a machine with other processes;
# no rank reads the memory of another, which containers forbid. From version 5 on, the names of the settings for
# placement and binding begin with PRTE_.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none
export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
export PRTE_MCA_hwloc_default_binding_policy=none
export OMPI_MCA_mpi_yield_when_idle=0
export OMPI_MCA_btl_vader_single_copy_mechanism=none
# No defaults of options from files of the user.
export KUSABI_CONFIG=
