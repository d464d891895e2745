// Equation numbers are those of EN 1993-1-1:2005.
#include "problems/structure/model/buckling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace kusabi::problems {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 5> curves{
    {{"a0", 0.13}, {"a", 0.21}, {"b", 0.34}, {"c", 0.49}, {"d", 0.76}}};
// Less slender bars do not buckle: (6.49) is 1 there.
constexpr double stocky = 0.2;
// Upper bound of all rounding errors of the formula, relative to the result.
constexpr double roundings = 64 * std::numeric_limits<double>::epsilon();

}  // namespace

std::optional<double> imperfection_factor(std::string_view curve) {
  const auto* found = std::ranges::find(curves, curve, [](const auto& each) { return each.first; });
  if (found == curves.end()) return {};
  return found->second;
}

double buckling_resistance(const CompressedBar& bar) {
  const double slenderness =
      bar.length / bar.radius / (std::numbers::pi * std::sqrt(bar.modulus / bar.yield_stress));
  const double excess = std::max(slenderness - stocky, 0.0);
  const double phi = (1 + bar.imperfection * excess + slenderness * slenderness) / 2;
  // For a stocky bar the radicand may be negative; chi is then 1.
  const double root = std::sqrt(std::max(phi * phi - slenderness * slenderness, 0.0));
  const double reduction = excess > 0 ? std::min(1 / (phi + root), 1.0) : 1.0;
  return reduction * bar.area * bar.yield_stress / bar.partial * (1 - roundings);
}

}  // namespace kusabi::problems
