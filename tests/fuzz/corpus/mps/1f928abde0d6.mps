NA~ -  R1     úA
