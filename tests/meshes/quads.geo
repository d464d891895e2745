// A leaning plate of quadrilaterals, 4 x 3.
Point(1) = {0, 0, 0};  Point(2) = {1.8, 0, 0};  Point(3) = {2, 2, 0};  Point(4) = {0, 2, 0};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};  Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 5;  Transfinite Curve {2, 4} = 4;
Transfinite Surface {1};  Recombine Surface {1};
Physical Surface("body") = {1};
Physical Curve("left") = {4};
Physical Curve("right") = {2};
