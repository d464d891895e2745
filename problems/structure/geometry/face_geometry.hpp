// Geometry of one face of an element: straight or curved, an edge in the plane or a triangle or
// quadrilateral in space, of first or second order.
#pragma once

#include <Eigen/Core>

namespace kusabi::problems {

/// The coordinates of a face's nodes, d x k, in the order of `element_faces`: 2 or 3 in the plane;
/// 3, 4, 6 or 8 in space.
using FaceCoordinates = Eigen::MatrixXd;

/// The outward unit normal, d, of the curved face at one of its nodes. It differs from the mean
/// over the face: faces of second order are curved between their nodes.
/// @param node its index in the face
Eigen::VectorXd face_normal(const FaceCoordinates& places, int node);

/// Length of an edge or area of a face, of its curved geometry, by Gauss integration.
double face_size(const FaceCoordinates& places);

/// The mean of the vertices; d.
Eigen::VectorXd face_centre(const FaceCoordinates& places);

}  // namespace kusabi::problems
