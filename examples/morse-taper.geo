// A conical plug (Morse taper): half angle 1.5 degrees, 15 mm long, 10 mm in radius at the thick end,
// in ten-node tetrahedra. The side is in contact, here at its two rims.
//
//     gmsh -3 -format msh41 examples/morse-taper.geo
SetFactory("OpenCASCADE");
half_angle = 1.5 * Pi / 180;
length = 15;
radius = 10;
Cone(1) = {0, 0, 0, 0, 0, length, radius - length * Tan(half_angle), radius};
Transfinite Curve {1, 3} = 5;  // four arcs each
Transfinite Curve {2} = 2;
Mesh.MeshSizeMin = 20;
Mesh.MeshSizeMax = 20;
Mesh.ElementOrder = 2;
Physical Curve("rims") = {1, 3};
Physical Volume("plug") = {1};
