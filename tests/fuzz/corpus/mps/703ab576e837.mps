NAME PMEDIAN4
ROWS
 N cost
 E s0
 E s
 E s3
 E open
 L o00
 L o01
 L o01
 L o03
 L NAME PMEDIAN4
ROWS
 N cost
 E s0
 Eo1﻿0
x3 0
 x33 s3 1
 x 