NAME r
ROWS
 N ct
 G r0
 L r1
 E r2
 G r3
 G r4
 L r5
 L r6
 L r7
COLUMNS
    M1 ' MI ER' 'INTORG'
    x0 cost 3
    x0 r0 1D x0 1
 MI BND x2
 UP BND x2 4
ENDATA
