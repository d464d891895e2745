// Comparison of the friction angle with the angle between faces.
#include "problems/files/draft/facet_warning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace kusabi::problems {
namespace {

/// Faces with a smaller angle, in degrees, are coplanar.
constexpr double one_plane = 1e-3;

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

}  // namespace

void FacetWarning::take(double faces_differ, double mean_is_off) {
  ++of;
  if (faces_differ <= one_plane) return;
  ++candidates;
  between = std::max(between, faces_differ);
  off = std::max(off, mean_is_off);
}

std::vector<std::string> warning_lines(const std::vector<FacetWarning>& facets, double friction,
                                       const std::string& file) {
  std::vector<std::string> lines;
  for (const auto& group : facets) {
    const double angle = std::atan(friction * group.factor) * 180 / std::numbers::pi;
    if (group.candidates == 0 || group.between <= angle) continue;
    const auto error =
        angle + group.off < 90
            ? fmt::format("{:.2g}", tangent(angle + group.off) / group.factor - friction)
            : std::string("any amount");
    lines.emplace_back(
        support::InputError(
            file, group.position,
            fmt::format(
                "normal = \"surface\" is the mean of faces that differ by up to {:.3g} "
                "degrees at {} of {} candidates, more than the {:.3g} degrees of the "
                "friction coefficient {:.4g}; if the faces approximate a curved surface, the "
                "coefficient may be off by up to {}; expected the true surface, normal = "
                "{{ point = [...], axis = [...], half_angle = ..., body = \"inside\" }}, "
                "or elements of second order with curved sides",
                group.between, group.candidates, group.of, angle, friction, error))
            .what());
  }
  return lines;
}

}  // namespace kusabi::problems
