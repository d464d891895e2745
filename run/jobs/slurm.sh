#!/bin/bash
# Job of Slurm for one analysis on many ranks. Shortly before the time limit of the job kusabi saves its state and ends,
# and the job is requeued until the analysis is complete. After the failure of a node, a preemption or a kill the job
# resumes from the last saved state.
#
#     sbatch run/jobs/slurm.sh patterns FILE --mu 0.65
#
# NAME.json and NAME.state are in the folder in which the job was submitted; sbatch --job-name NAME sets NAME.
#SBATCH --job-name=kusabi
#SBATCH --ntasks=8
#SBATCH --time=04:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
most_turns=${KUSABI_MOST_TURNS:-100}

result=$SLURM_JOB_NAME.json
state=$SLURM_JOB_NAME.state
# Files of the previous run are removed: if this run is killed, they would be taken for its own.
rm -f "$result" "$state.status"
# shellcheck disable=SC2086  # the launcher may have options: KUSABI_LAUNCHER="srun --mpi=pmix"
${KUSABI_LAUNCHER:-mpirun} kusabi "$@" --resume "$state" --time-limit slurm --output "$result"
code=$?

# The status decides whether the job is requeued. It is written before the results, so it exists even if kusabi is
# killed while it writes them. Exit code 3 is not sufficient: a part may be numerically undecided, for which more time
# does not help, and mpirun of MPICH may lose the code after it has forwarded a signal.
if grep -Eqsx 'time-limit|interrupted' "$state.status" &&
  [ "${SLURM_RESTART_COUNT:-0}" -lt "$most_turns" ]; then
  scontrol requeue "$SLURM_JOB_ID"
  exit
fi
exit "$code"
