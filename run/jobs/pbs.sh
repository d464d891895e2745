#!/bin/bash
# Job of PBS Professional, OpenPBS or Torque for one analysis on many ranks, resubmitted until it is complete.
#
#     qsub -v CALL="patterns FILE --mu 0.65" run/jobs/pbs.sh
#
# TIME is a few minutes less than the walltime below, for writing the results, since PBS does not announce the end of a
# job.
#PBS -N kusabi
#PBS -l select=1:ncpus=8:mpiprocs=8
#PBS -l walltime=04:00:00
#PBS -r y
set -u
cd "$PBS_O_WORKDIR" || exit 2
: "${CALL:?expected qsub -v CALL=\"patterns FILE --mu 0.65\"}"
script=${SCRIPT:-run/jobs/pbs.sh}
turn=${TURN:-1}
most_turns=${KUSABI_MOST_TURNS:-100}

result=$PBS_JOBNAME.json
state=$PBS_JOBNAME.state
rm -f "$result" "$state.status"
# shellcheck disable=SC2086  # CALL is words
mpirun kusabi $CALL --resume "$state" --time-limit "${TIME:-3h55m}" --output "$result"
code=$?

if grep -Eqsx 'time-limit|interrupted' "$state.status" && [ "$turn" -lt "$most_turns" ]; then
  # Values from the environment, since they may contain commas.
  export CALL TIME="${TIME:-3h55m}" SCRIPT="$script" TURN=$((turn + 1))
  qsub -N "$PBS_JOBNAME" -v CALL,TIME,SCRIPT,TURN "$script"
  exit
fi
exit "$code"
