* Three people, three tasks, costs 4 1 3 / 2 0 5 / 3 2 2. Of the six ways 1 + 2 + 2 is the cheapest: 5.
NAME          ASSIGNMENT
ROWS
 N  COST
 E  P1
 E  P2
 E  P3
 E  T1
 E  T2
 E  T3
COLUMNS
    MARK      'MARKER'                 'INTORG'
    X11       COST         4.0   P1           1.0
    X11       T1           1.0
    X12       COST         1.0   P1           1.0
    X12       T2           1.0
    X13       COST         3.0   P1           1.0
    X13       T3           1.0
    X21       COST         2.0   P2           1.0
    X21       T1           1.0
    X22       P2           1.0   T2           1.0
    X23       COST         5.0   P2           1.0
    X23       T3           1.0
    X31       COST         3.0   P3           1.0
    X31       T1           1.0
    X32       COST         2.0   P3           1.0
    X32       T2           1.0
    X33       COST         2.0   P3           1.0
    X33       T3           1.0
    MARK      'MARKER'                 'INTEND'
RHS
    RHS       P1           1.0   P2           1.0
    RHS       P3           1.0   T1           1.0
    RHS       T2           1.0   T3           1.0
BOUNDS
 UP BND       X11          1.0
 UP BND       X12          1.0
 UP BND       X13          1.0
 UP BND       X21          1.0
 UP BND       X22          1.0
 UP BND       X23          1.0
 UP BND       X31          1.0
 UP BND       X32          1.0
 UP BND       X33          1.0
ENDATA
