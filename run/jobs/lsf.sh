#!/bin/bash
# One question on many ranks, in as many turns as it takes, for LSF: a job that ends with code 75 goes back into the
# queue (-Q), and so does one whose host fails (-r).
#
#     bsub < run/jobs/lsf.sh              # the call is below, since bsub reads the script from its standard input
#
# LSF does not tell a job when it ends: the time limit is that of -W, with room to write.
#BSUB -J kusabi
#BSUB -n 8
#BSUB -W 4:00
#BSUB -r
#BSUB -Q "75"
#BSUB -o kusabi.%J.out
set -u
call=(patterns FILE --mu 0.65)
again=75

result=$LSB_JOBNAME.json
state=$LSB_JOBNAME.state
rm -f "$result" "$state.status"
mpirun kusabi "${call[@]}" --resume "$state" --time-limit 3h55m --output "$result"
code=$?

if grep -Eqsx 'time-limit|interrupted' "$state.status"; then
  exit "$again"
fi
exit "$code"
