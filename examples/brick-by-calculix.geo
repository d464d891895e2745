// A brick of 3 x 2 x 1 in as many hexahedra:
//     gmsh brick-by-calculix.geo -3 -format msh41 -o brick-by-calculix.msh
Point(1) = {0, 0, 0, 1};  Point(2) = {3, 0, 0, 1};  Point(3) = {3, 2, 0, 1};  Point(4) = {0, 2, 0, 1};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};  Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 4;  Transfinite Curve {2, 4} = 3;
Transfinite Surface {1};  Recombine Surface {1};
out[] = Extrude {0, 0, 1} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("body") = {out[1]};
Physical Surface("clamped") = {out[5]};
Physical Surface("right") = {out[3]};
