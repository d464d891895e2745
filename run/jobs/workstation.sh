#!/bin/bash
# One question on the cores of this machine, until it is done, whatever ends it in between: a machine that is switched
# off and on (call it from cron's @reboot), a process that is killed, Ctrl-C and the same call again.
#
#     run/jobs/workstation.sh NAME patterns FILE --mu 0.65
#
# NAME.state and NAME.json are where the state and the result go. The ranks are KUSABI_RANKS, or one a core.
set -u
if [ $# -lt 3 ]; then
  echo "usage: ${0##*/} NAME SUBCOMMAND FILE [OPTIONS]" >&2
  exit 2
fi
name=$1
shift
ranks=${KUSABI_RANKS:-$(nproc)}
most_turns=${KUSABI_MOST_TURNS:-100}
# Half the time, in seconds, that Open MPI's mpirun gives its ranks to keep their state and to write: see
# docs/long-runs.md.
export OMPI_MCA_odls_base_sigkill_timeout=${OMPI_MCA_odls_base_sigkill_timeout:-10}

for ((turn = 1; turn <= most_turns; ++turn)); do
  mpirun -np "$ranks" \
    kusabi "$@" --resume "$name.state" --output "$name.json"
  code=$?
  # A rank that was killed, as Open MPI and as MPICH tell it; anything else is an answer, or an error that would come
  # again.
  [ "$code" -gt 128 ] || [ "$code" -eq 9 ] || exit "$code"
done
exit "$code"
