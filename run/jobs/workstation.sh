#!/bin/bash
# One analysis on the cores of this machine. It restarts kusabi after a rank was killed; after Ctrl-C or a restart of
# the machine the same call resumes the analysis (@reboot in a crontab calls it).
#
#     run/jobs/workstation.sh NAME patterns FILE --mu 0.65
#
# NAME.state is the state, NAME.json the result. KUSABI_RANKS is the number of ranks; default: one for each core.
set -u
if [ $# -lt 3 ]; then
  echo "usage: ${0##*/} NAME SUBCOMMAND FILE [OPTIONS]" >&2
  exit 2
fi
name=$1
shift
ranks=${KUSABI_RANKS:-$(nproc)}
most_turns=${KUSABI_MOST_TURNS:-100}
# Half of the time, in seconds, for which mpirun of Open MPI waits while its ranks save their state and write
# (docs/long-runs.md).
export OMPI_MCA_odls_base_sigkill_timeout=${OMPI_MCA_odls_base_sigkill_timeout:-10}

for ((turn = 1; turn <= most_turns; ++turn)); do
  mpirun -np "$ranks" \
    kusabi "$@" --resume "$name.state" --output "$name.json"
  code=$?
  # Exit codes of Open MPI and of MPICH for a killed rank. All others are an answer, or an error that would recur.
  [ "$code" -gt 128 ] || [ "$code" -eq 9 ] || exit "$code"
done
exit "$code"
