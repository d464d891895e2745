* expect: missing-column-name.mps:6: ...; expected a program in MPS format
NAME X
ROWS
 N COST
COLUMNS
 A
ENDATA
