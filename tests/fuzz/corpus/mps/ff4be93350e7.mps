E STEINER9
ORG'
    x0 cost 3
    x0 r0 1
    x0 r5 -10000
    x0 r6 -10000
    x0 r7 -10000
    M2 'MARKE r2 3
    x3 r4 -9
    x3 r7 1
 p8
ENDjob1