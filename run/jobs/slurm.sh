#!/bin/bash
# One question on many ranks, in as many turns as it takes. Slurm gives each turn its time; shortly before it is over
# kusabi keeps its state and ends, and the job is put into the queue again. A node that fails, a job that is preempted
# or killed: the next turn goes on from the last state.
#
#     sbatch run/jobs/slurm.sh patterns FILE --mu 0.65
#
# RESULT.json and STATE lie in the folder that the job was sent from, under its name: sbatch --job-name NAME.
#SBATCH --job-name=kusabi
#SBATCH --ntasks=8
#SBATCH --time=04:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
most_turns=${KUSABI_MOST_TURNS:-100}

result=$SLURM_JOB_NAME.json
state=$SLURM_JOB_NAME.state
# What kills its ranks kills mpirun, too: what the last turn has written says nothing of this one.
rm -f "$result" "$state.status"
# shellcheck disable=SC2086  # the launcher may have options: KUSABI_LAUNCHER="srun --mpi=pmix"
${KUSABI_LAUNCHER:-mpirun} kusabi "$@" --resume "$state" --time-limit slurm --output "$result"
code=$?

# The status is written before the results, so it is there even if kusabi is killed while it writes these. It says
# whether more time helps. Exit code 3 does not: something may have been left open for good; and
# MPICH's mpirun may lose the code when it passed a signal on.
if grep -Eqsx 'time-limit|interrupted' "$state.status" &&
  [ "${SLURM_RESTART_COUNT:-0}" -lt "$most_turns" ]; then
  scontrol requeue "$SLURM_JOB_ID"
  exit
fi
exit "$code"
