// Two plates that hang together; the right one has a quarter of a circle cut out of it. Groups with
// and without a name, one of two curves, one of a point; the middle of the circle is of no element.
h = 0.5;
Point(1) = {0, 0, 0, h};  Point(2) = {1, 0, 0, h};  Point(3) = {1, 1, 0, h};  Point(4) = {0, 1, 0, h};
Point(5) = {2, 0, 0, h};  Point(6) = {2, 0.5, 0, h};  Point(7) = {1.5, 1, 0, h};  Point(8) = {2, 1, 0, h};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};
Line(5) = {2, 5};  Line(6) = {5, 6};  Circle(7) = {6, 8, 7};  Line(8) = {7, 3};
Curve Loop(1) = {1, 2, 3, 4};  Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, 8, -2};  Plane Surface(2) = {2};
Physical Surface("all") = {1, 2};
Physical Surface("right plate") = {2};
Physical Curve("left") = {4};
Physical Curve("bottom") = {1, 5};
Physical Curve("notch") = {7};
Physical Curve(9) = {6};
Physical Point("corner") = {1};
