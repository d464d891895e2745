// Random trusses whose uncertain loads act in any direction on several nodes at once.
#pragma once

#include <cstdint>

#include "problems/structure/model/structure.hpp"

namespace kusabi::limit::test {

/// A truss and the half-width of its parameters.
struct CorrelatedTruss {
  problems::Structure truss;
  double alpha = 0;
};

/// In the plane for an even seed, in space for an odd one. Two to six parameters: single
/// components, loads on several nodes, loads along components with reference load, multiples and
/// sums of others, two on one component. May be a mechanism.
CorrelatedTruss correlated_truss(std::uint32_t seed);

}  // namespace kusabi::limit::test
