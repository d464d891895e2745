* expect: not-a-number.mps:7: "one" is not a number; expected a number like -1.5e3
NAME X
ROWS
 N COST
 L R1
COLUMNS
 A R1 one
ENDATA
