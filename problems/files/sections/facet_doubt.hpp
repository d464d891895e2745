// Normals that follow the facets of a mesh where the surface that is meant may be curved: they are
// means of faces, and friction that is less than what the faces differ by can't rest on them.
#pragma once

#include <string>
#include <vector>

#include "support/input_error.hpp"

namespace kusabi::problems {

/// Of one `normal = "surface"`.
struct FacetDoubt {
  support::SourcePosition position;  ///< of the normal
  double between = 0;  ///< degrees: the largest angle of two faces whose mean is taken at a node
  double off = 0;      ///< degrees: the largest angle of a mean from one of its faces
  int candidates = 0;  ///< whose faces differ
  int of = 0;
  double factor = 1;  ///< of the friction there

  void take(double faces_differ, double mean_is_off);
};

/// A line for each whose faces differ by more than the friction angle of a coefficient.
std::vector<std::string> facet_warnings(const std::vector<FacetDoubt>& doubts, double friction,
                                        const std::string& file);

}  // namespace kusabi::problems
