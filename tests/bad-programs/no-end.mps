* expect: no-end.mps:8: ...; expected a program in MPS format
NAME X
ROWS
 N COST
 L R1
COLUMNS
 A R1 1
