# What both README commands share: find out what is missing, say so, install it, build.
# Sourced by run/quickstart and run/test; not a command of its own.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { printf '\n== %s\n' "$*"; }
give_up() { printf 'kusabi: %s\n' "$*" >&2; exit 1; }

# What the program itself needs, by the names of Debian 12.
build_packages=(g++ cmake make ninja-build libopenmpi-dev openmpi-bin libboost-serialization-dev libeigen3-dev
  libfmt-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libgmp-dev libmpfr-dev libglpk-dev
  libqd-dev zlib1g-dev)
# What the tests need besides.
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev python3 python3-jsonschema python3-numpy mkdocs)

# install_missing PACKAGE...: installs those that are not there yet.
install_missing() {
  local missing=() package
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian system: nothing is installed; what these Debian packages hold must be there: $*"
    return
  fi
  for package in "$@"; do
    [[ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" == installed ]] ||
      missing+=("$package")
  done
  if [[ ${#missing[@]} -eq 0 ]]; then
    say "everything needed is installed"
    return
  fi
  say "installing with apt-get: ${missing[*]}"
  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    local ask="ask an administrator for: apt-get install ${missing[*]}"
    command -v sudo >/dev/null || give_up "an ordinary user cannot install without sudo; $ask"
    sudo true || give_up "sudo was refused; $ask"
    as_root=(sudo)
  fi
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get)
  # A fresh machine has no package lists, an old one has stale ones.
  "${apt[@]}" -q update || give_up "apt-get update failed; are the package sources reachable?"
  "${apt[@]}" -qy --no-install-recommends install "${missing[@]}" ||
    give_up "apt-get could not install: ${missing[*]}"
}

# build TARGET CMAKE_OPTION...: configures build/ and builds one target there. A build/ that is there
# already stays of the kind it is; a new one is made for building everything once: sources joined, and
# with Ninja, which does not wait for one library to be whole before it compiles the next.
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

# Open MPI refuses to run as root, or more ranks than cores, unless told; and what pays on a cluster
# (ranks pinned to cores, which hand their core over when they poll in vain) does not on a machine
# that others use as well. In a container one process may not read the memory of another, which the
# last setting does without. From version 5 on what places and pins ranks is called PRTE_... Other
# launchers ignore these.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none
export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
export PRTE_MCA_hwloc_default_binding_policy=none
export OMPI_MCA_mpi_yield_when_idle=0
export OMPI_MCA_btl_vader_single_copy_mechanism=none
# Defaults that somebody keeps for calls of his own are none of ours.
export KUSABI_CONFIG=
