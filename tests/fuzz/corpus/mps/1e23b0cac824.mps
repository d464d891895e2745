NAME          AONST
ROWS
 N  COST
 G  R1
COLUMNS
    X         COST         1.0   R1           0.0
RHS
    RHS       COST       -10.0   R1           3.0
ENDATA
