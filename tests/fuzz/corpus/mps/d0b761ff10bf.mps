NAME          AONST
ROWS
 N  COST
 G  R1
COLUMNS
    X      "  COST          0.0
RHS
    RHS       COST       -10.0   R1         o32  3.0
ENDATA
