#!/bin/bash
# Job array of Slurm for one analysis at many points, each with its own state: in the call below, the patterns at ten
# friction coefficients. Each task is requeued until it is complete, as in slurm.sh.
#
#     sbatch --array=1-10 run/jobs/slurm-array.sh patterns FILE --mu 'n * 0.1'
#
# n is the number of the task in each argument of the form 'n * NUMBER'.
#SBATCH --job-name=kusabi
#SBATCH --ntasks=1
#SBATCH --time=04:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
most_turns=${KUSABI_MOST_TURNS:-100}
number=$SLURM_ARRAY_TASK_ID

words=()
for word in "$@"; do
  case $word in
    'n * '*) word=$(awk -v n="$number" -v step="${word#n \* }" 'BEGIN { printf "%.10g", n * step }') ;;
  esac
  words+=("$word")
done

result=$SLURM_JOB_NAME.$number.json
state=$SLURM_JOB_NAME.$number.state
rm -f "$result" "$state.status"
# shellcheck disable=SC2086  # the launcher may have options
${KUSABI_LAUNCHER:-mpirun} kusabi "${words[@]}" --resume "$state" --time-limit slurm \
  --output "$result"
code=$?

if grep -Eqsx 'time-limit|interrupted' "$state.status" &&
  [ "${SLURM_RESTART_COUNT:-0}" -lt "$most_turns" ]; then
  scontrol requeue "$SLURM_JOB_ID"
  exit
fi
exit "$code"
