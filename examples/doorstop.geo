// A doorstop: a wedge of rubber, 120 mm long, with 8 degrees between its sole and its back, in six-node triangles.
// The edges that touch the floor and the door are physical groups.
//
//     gmsh -2 -format msh41 examples/doorstop.geo
angle = 8 * Pi / 180;
length = 120;
tip = 6;  // its height at the thin end
Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Point(3) = {length, tip + length * Tan(angle), 0};
Point(4) = {0, tip, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 4;  // three edges each
Transfinite Curve {2, 4} = 2;
Mesh.ElementOrder = 2;
Physical Curve("sole") = {1};
Physical Curve("back") = {3};
Physical Surface("rubber") = {1};
