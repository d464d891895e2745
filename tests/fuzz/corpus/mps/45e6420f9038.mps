NAME     T
ROWS
 N  COST
 G  R1
COLUMNS
    X         COST         1.0   R1                  3.0
END  3.0
ENDATA
