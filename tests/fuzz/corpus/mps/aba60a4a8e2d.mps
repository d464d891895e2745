NAME          AONST
ROWS
 N  COST
 G  R1
COLUMNS
    X      "  COST          0.0
RHS
    RHS       COST       R1
COLUMN1           3.0
ENDATA
