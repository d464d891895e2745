// Warnings of normals of a faceted mesh of a possibly curved surface: they are means over faces,
// and results for friction angles below the angle between the faces are not reliable.
#pragma once

#include <string>
#include <vector>

#include "support/input_error.hpp"

namespace kusabi::problems {

/// Data of one `normal = "surface"`.
struct FacetWarning {
  support::SourcePosition position;  ///< of the normal
  double between = 0;                ///< degrees: the largest angle between two faces at one node
  double off = 0;      ///< degrees: the largest angle between a mean normal and one of its faces
  int candidates = 0;  ///< number of candidates with different faces
  int of = 0;
  double factor = 1;  ///< of friction at these candidates

  void take(double faces_differ, double mean_is_off);
};

/// One line for each group whose faces differ by more than the friction angle of a coefficient.
std::vector<std::string> warning_lines(const std::vector<FacetWarning>& facets, double friction,
                                       const std::string& file);

}  // namespace kusabi::problems
