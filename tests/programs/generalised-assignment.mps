NAME GAP3X6
ROWS
 N cost
 E job0
 E job1
 E job2
 E job3
 E job4
 E job5
 L cap0
 L cap1
 L cap2
COLUMNS
 M1 'MARKER' 'INTORG'
 x00 cost 5
 x00 job0 1
 x00 cap0 4
 x01 cost 6
 x01 job1 1
 x01 cap0 3
 x02 cost 3
 x02 job2 1
 x02 cap0 9
 x03 cost 8
 x03 job3 1
 x03 cap0 8
 x04 cost 9
 x04 job4 1
 x04 cap0 9
 x05 cost 4
 x05 job5 1
 x05 cap0 5
 x10 cost 3
 x10 job0 1
 x10 cap1 9
 x11 cost 3
 x11 job1 1
 x11 cap1 5
 x12 cost 2
 x12 job2 1
 x12 cap1 4
 x13 cost 8
 x13 job3 1
 x13 cap1 4
 x14 cost 6
 x14 job4 1
 x14 cap1 5
 x15 cost 2
 x15 job5 1
 x15 cap1 5
 x20 cost 5
 x20 job0 1
 x20 cap2 8
 x21 cost 7
 x21 job1 1
 x21 cap2 9
 x22 cost 6
 x22 job2 1
 x22 cap2 8
 x23 cost 4
 x23 job3 1
 x23 cap2 9
 x24 cost 3
 x24 job4 1
 x24 cap2 9
 x25 cost 6
 x25 job5 1
 x25 cap2 5
 M2 'MARKER' 'INTEND'
RHS
 RHS job0 1
 RHS job1 1
 RHS job2 1
 RHS job3 1
 RHS job4 1
 RHS job5 1
 RHS cap0 13
 RHS cap1 12
 RHS cap2 14
BOUNDS
 BV BND x00
 BV BND x01
 BV BND x02
 BV BND x03
 BV BND x04
 BV BND x05
 BV BND x10
 BV BND x11
 BV BND x12
 BV BND x13
 BV BND x14
 BV BND x15
 BV BND x20
 BV BND x21
 BV BND x22
 BV BND x23
 BV BND x24
 BV BND x25
ENDATA
