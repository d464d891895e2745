NAME PMEDIAN4
ROWS
 N cost
 E s0
 E s1
 E s2
 E s3
 E open
 L o00
 L o01
 L o02
 L o03
 L o10
 L o11
 L o12
 L o13
 L o20
 L o21
 L o22
 L o23
 L o30
 L o31
 L o32
 L o33
COLUMNS
 M1 'MARKER' 'INTORG'
 y0 cost 0
 y0 open 1
 y0 o00 -1
 y0 o10 -1
 y0 o20 -1
 y0 o30 -1
 y1 cost 0
 y1 open 1
 y1 o01 -1
 y1 o11 -1
 y1 o21 -1
 y1 o31 -1
 y2 cost 0
 y2 open 1
 y2 o02 -1
 y2 o12 -1
 y2 o22 -1
 y2 o32 -1
 y3 cost 0
 y3 open 1
 y3 o03 -1
 y3 o13 -1
 y3 o23 -1
 y3 o33 -1
 x00 cost 0
 x00 s0 1
 x00 o00 1
 x01 cost 10
 x01 s0 1
 x01 o01 1
 x02 cost 12
 x02 s0 1
 x02 o02 1
 x03 cost 24
 x03 s0 1
 x03 o03 1
 x10 cost 5
 x10 s1 1
 x10 o10 1
 x11 cost 0
 x11 s1 1
 x11 o11 1
 x12 cost 7
 x12 s1 1
 x12 o12 1
 x13 cost 7
 x13 s1 1
 x13 o13 1
 x20 cost 18
 x20 s2 1
 x20 o20 1
 x21 cost 21
 x21 s2 1
 x21 o21 1
 x22 cost 0
 x22 s2 1
 x22 o22 1
 x23 cost 18
 x23 s2 1
 x23 o23 1
 x30 cost 12
 x30 s3 1
 x30 o30 1
 x31 cost 7
 x31 s3 1
 x31 o31 1
 x32 cost 6
 x32 s3 1
 x32 o32 1
 x33 cost 0
 x33 s3 1
 x33 o33 1
 M2 'MARKER' 'INTEND'
RHS
 RHS s0 1
 RHS s1 1
 RHS s2 1
 RHS s3 1
 RHS open 2
BOUNDS
 BV BND y0
 BV BND y1
 BV BND y2
 BV BND y3
 BV BND x00
 BV BND x01
 BV BND x02
 BV BND x03
 BV BND x10
 BV BND x11
 BV BND x12
 BV BND x13
 BV BND x20
 BV BND x21
 BV BND x22
 BV BND x23
 BV BND x30
 BV BND x31
 BV BND x32
 BV BND x33
ENDATA
