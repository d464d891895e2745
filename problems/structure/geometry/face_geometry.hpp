// The geometry of one face of an element: straight or curved, an edge in the plane or a triangle or
// quadrilateral in space, of first or second order.
#pragma once

#include <Eigen/Core>

namespace kusabi::problems {

/// The places of a face's nodes, d x k, in the order of `element_faces`: 2 or 3 of them in the
/// plane; 3, 4, 6 or 8 in space.
using FacePlaces = Eigen::MatrixXd;

/// The unit normal of the face's own curved geometry at one of its nodes, out of the body; d. Not
/// the mean over the face: the faces of second order are curved between their nodes.
/// @param node its place in the order of the face
Eigen::VectorXd face_normal(const FacePlaces& places, int node);

/// Length of an edge, area of a face: of its curved geometry, integrated at Gauss points.
double face_size(const FacePlaces& places);

/// The mean of the corners; d.
Eigen::VectorXd face_centre(const FacePlaces& places);

}  // namespace kusabi::problems
