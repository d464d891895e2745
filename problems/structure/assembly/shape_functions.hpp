// Gradients of the shape functions in natural coordinates and the integration points of each shape,
// in any precision.
//
// Full integration: 1 and 3 points for triangles, 2 x 2 and 3 x 3 for quadrilaterals, 1 and 4 for
// tetrahedra, 2 x 2 x 2 and 3 x 3 x 3 for hexahedra, 3 x 3 for prisms of 15 nodes, as in Abaqus and
// CalculiX for the elements without R in their name. Prisms of 6 nodes have 3 x 2 points, exact for
// those with parallel edges; there they have 1 x 2. Pyramids have 2 x 2 x 2, exact if the base is a
// parallelogram; Abaqus has 1.
#pragma once

#include <vector>

#include "problems/structure/model/element_shape.hpp"
#include "support/numbers/running_error.hpp"

namespace kusabi::problems {

/// Gradients along xi, eta, zeta, one for each shape function.
template <class Scalar>
using NaturalSlopes = std::vector<NaturalPoint<Scalar>>;

template <class Scalar>
NaturalSlopes<Scalar> natural_slopes(ElementShape shape, const NaturalPoint<Scalar>& at);

/// An integration point with the gradients of the shape functions.
template <class Scalar>
struct IntegrationPoint {
  NaturalPoint<Scalar> at;
  Scalar weight;
  NaturalSlopes<Scalar> slopes;
};

/// The integration points, computed once. The weights sum to the volume of the shape in natural
/// coordinates.
template <class Scalar>
const std::vector<IntegrationPoint<Scalar>>& integration_points(ElementShape shape);

extern template NaturalSlopes<double> natural_slopes(ElementShape, const NaturalPoint<double>&);
extern template const std::vector<IntegrationPoint<double>>& integration_points<double>(
    ElementShape);
extern template NaturalSlopes<numbers::Precise> natural_slopes(
    ElementShape, const NaturalPoint<numbers::Precise>&);
extern template const std::vector<IntegrationPoint<numbers::Precise>>&
    integration_points<numbers::Precise>(ElementShape);
extern template NaturalSlopes<numbers::RunningError> natural_slopes(
    ElementShape, const NaturalPoint<numbers::RunningError>&);
extern template const std::vector<IntegrationPoint<numbers::RunningError>>&
    integration_points<numbers::RunningError>(ElementShape);

}  // namespace kusabi::problems
