// Comparison of the friction angle with the angle between faces.
#include "problems/files/draft/facet_doubt.hpp"

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

void FacetDoubt::take(double faces_differ, double mean_is_off) {
  ++of;
  if (faces_differ <= one_plane) return;
  ++candidates;
  between = std::max(between, faces_differ);
  off = std::max(off, mean_is_off);
}

std::vector<std::string> facet_warnings(const std::vector<FacetDoubt>& doubts, double friction,
                                        const std::string& file) {
  std::vector<std::string> lines;
  for (const auto& doubt : doubts) {
    const double angle = std::atan(friction * doubt.factor) * 180 / std::numbers::pi;
    if (doubt.candidates == 0 || doubt.between <= angle) continue;
    const auto error =
        angle + doubt.off < 90
            ? fmt::format("{:.2g}", tangent(angle + doubt.off) / doubt.factor - friction)
            : std::string("any amount");
    lines.emplace_back(
        support::InputError(
            file, doubt.position,
            fmt::format(
                "normal = \"surface\" is the mean of faces that differ by up to {:.3g} "
                "degrees at {} of {} candidates, more than the {:.3g} degrees of the "
                "friction coefficient {:.4g}; if the faces approximate a curved surface, the "
                "coefficient may be off by up to {}; expected the true surface, normal = "
                "{{ point = [...], axis = [...], half_angle = ..., body = \"inside\" }}, "
                "or elements of second order with curved sides",
                doubt.between, doubt.candidates, doubt.of, angle, friction, error))
            .what());
  }
  return lines;
}

}  // namespace kusabi::problems
