NAME T
ROWS
 N  Cp1Tÿÿÿÿÿÿÿÿÿÿÿÿÿÿ
 G  R1
OBJNAME
    X COSTX23  DATA
