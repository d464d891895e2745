// A snap hook: a beam of 30 x 1, and on its end a head whose undercut face leans by 20 degrees.
//     gmsh snap-hook.geo -2 -order 2 -format msh41 -o snap-hook.msh
alpha = 20 * Pi / 180;
length = 30;
coarse = 1;  fine = 0.5;
Point(1) = {0, 0, 0, coarse};
Point(2) = {length + 2, 0, 0, coarse};
Point(3) = {length + 2, 1, 0, coarse};
Point(4) = {length + 1, 2, 0, coarse};
Point(5) = {length + Tan(alpha), 2, 0, fine};
Point(6) = {length, 1, 0, fine};
Point(7) = {0, 1, 0, coarse};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 5};
Line(5) = {5, 6};  Line(6) = {6, 7};  Line(7) = {7, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7};
Plane Surface(1) = {1};
Physical Surface("body") = {1};
Physical Curve("clamp") = {7};
Physical Curve("undercut") = {5};
