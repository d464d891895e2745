* expect: unknown-row.mps:7: ...; expected a program in MPS format
NAME X
ROWS
 N COST
 L R1
COLUMNS
 A R2 1
ENDATA
