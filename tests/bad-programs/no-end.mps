* expect: no-end.mps:7: the file ends without ENDATA; expected the whole file
NAME X
ROWS
 N COST
 L R1
COLUMNS
 A R1 1
