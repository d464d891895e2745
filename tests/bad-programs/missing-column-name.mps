* expect: missing-column-name.mps:6: a column of another form; expected its name, and one or two rows each with a number
NAME X
ROWS
 N COST
COLUMNS
 A
ENDATA
