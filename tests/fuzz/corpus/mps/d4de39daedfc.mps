NAME     T
ROWS
 N  COST
 G OBJNAME«²±¬ßßßàTWORS

 N  COST
 G  R1
COLUMNS
    X,         COST       !  1.00
ENDATA
