* expect: unknown-row.mps:7: "R2" is not a row; expected a name of section ROWS
NAME X
ROWS
 N COST
 L R1
COLUMNS
 A R2 1
ENDATA
