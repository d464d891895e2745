#!/bin/bash
# Job of LSF for one analysis on many ranks. A job that ends with code 75 is requeued (-Q), as is one whose host fails
# (-r), until the analysis is complete.
#
#     bsub < run/jobs/lsf.sh              # the call is below, since bsub reads the script from its standard input
#
# --time-limit is a few minutes less than -W, for writing the results, since LSF does not announce the end of a job.
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
