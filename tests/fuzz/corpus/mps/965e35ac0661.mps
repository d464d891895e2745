NAME     T
ROWS
 N  CFST
 G  R1
COLUMNS
    X         COST        1.0   R1        A
