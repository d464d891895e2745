NAME STEINER9
ROWS
 N cost
 G l0
 G l1
 G l2
 G l3
 G l4
 G l5
 G l6
 G l7
 G l8
 G l9
 G l10
 G l11
COLUMNS
 M1 'MARKER' 'INTORG'
 p0 cost 1
 p0 l0 1
 p0 l3 1
 p0 l6 1
 p0 l9 1
 p1 cost 1
 p1 l0 1
 p1 l4 1
 p1 l7 1
 p1 l10 1
 p2 cost 1
 p2 l0 1
 p2 l5 1
 p2 l8 1
 p2 l11 1
 p3 cost 1
 p3 l1 1
 p3 l3 1
 p3 l8 1
 p3 l10 1
 p4 cost 1
 p4 l1 1
 p4 l4 1
 p4 l6 1
 p4 l11 1
 p5 cost 1
 p5 l1 1
 p5 l5 1
 p5 l7 1
 p5 l9 1
 p6 cost 1
 p6 l2 1
 p6 l3 1
 p6 l7 1
 p6 l11 1
 p7 cost 1
 p7 l2 1
 p7 l4 1
 p7 l8 1
 p7 l9 1
 p8 cost 1
 p8 l2 1
 p8 l5 1
 p8 l6 1
 p8 l10 1
 M2 'MARKER' 'INTEND'
RHS
 RHS l0 1
 RHS l1 1
 RHS l2 1
 RHS l3 1
 RHS l4 1
 RHS l5 1
 RHS l6 1
 RHS l7 1
 RHS l8 1
 RHS l9 1
 RHS l10 1
 RHS l11 1
BOUNDS
 BV BND p0
 BV BND p1
 BV BND p2
 BV BND p3
 BV BND p4
 BV BND p5
 BV BND p6
 BV BND p7
 BV BND p8
ENDATA
