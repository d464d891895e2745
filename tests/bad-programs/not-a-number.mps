* expect: not-a-number.mps:7: ...; expected a program in MPS format
NAME X
ROWS
 N COST
 L R1
COLUMNS
 A R1 one
ENDATA
