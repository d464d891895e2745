// Projections in double precision, with residuals in exact arithmetic.
#include "verify/limit/corrected_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "verify/limit/gram.hpp"

namespace kusabi::verify {
namespace {

/// A member is rigid in the intended motion if its elongation is below this share of the largest
/// displacement.
constexpr double is_still = 1e-9;

/// The elongation of a rigid member is made exactly zero if rounding of the motion may change the
/// dissipation by more than this share. Not all can be zero: directions of bars are rounded, so a
/// redundant body has no exact rigid motion.
constexpr double significant_cost = 1e-14;
constexpr double rounding = 0x1p-53;

/// Each step reduces the elongations by about ten digits, by fewer for trusses close to mechanisms.
constexpr int steps = 12;
constexpr double shift = 1e-10;

// Changes a motion so that the elongations of some columns are zero up to rounding far below that
// of doubles, by projections with rows scaled to one.
std::vector<Dyadic> without_elongations(std::vector<Dyadic> motion,
                                        const std::vector<const TrussColumn*>& still) {
  std::vector<Sparse> roughly;
  std::vector<bool> touched(motion.size());
  std::vector<double> weight;  // scales each row to one
  for (const auto* column : still) {
    auto& rough = roughly.emplace_back();
    double square = 0;
    for (const auto& [e, entry] : *column) {
      rough.emplace_back(e, entry.value.nearest());
      square += rough.back().second * rough.back().second;
      touched[e] = true;
    }
    weight.push_back(1 / square);
  }
  std::vector<std::size_t> displacements;
  for (std::size_t e = 0; e < touched.size(); ++e) {
    if (touched[e]) displacements.push_back(e);
  }
  std::vector<std::size_t> all(still.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Gram gram(roughly, all, weight, displacements, motion.size(), shift);
  if (!gram.definite()) return motion;
  std::vector<double> change(displacements.size());
  for (int step = 0; step < steps; ++step) {
    // Relative to the largest, so that nothing underflows.
    std::vector<Dyadic> stretches;
    std::optional<long> scale;
    for (const auto* column : still) {
      stretches.push_back(elongation_of(*column, motion));
      if (stretches.back().sign() == 0) continue;
      scale = std::max(scale.value_or(stretches.back().magnitude()), stretches.back().magnitude());
    }
    if (!scale) break;
    std::ranges::fill(change, 0.0);
    for (std::size_t k = 0; k < still.size(); ++k) {
      const double stretch = weight[k] * stretches[k].scaled(-*scale).nearest();
      for (const auto& [e, entry] : roughly[k]) change[gram.place(e)] += stretch * entry;
    }
    gram.solve(change);
    for (const auto e : displacements) {
      const double each = change[gram.place(e)];
      if (!std::isfinite(each)) return motion;
      motion[e] = motion[e] - Dyadic(each).scaled(*scale);
    }
  }
  return motion;
}

}  // namespace

std::vector<Dyadic> corrected_motion(const CollapseMotion& collapse, const LimitTruss& truss,
                                     bool without_work) {
  const auto [tension, compression] = truss.remaining(collapse.lost);
  std::vector<Dyadic> motion;
  double largest = 0;
  for (const double u : collapse.motion) {
    motion.emplace_back(u);
    largest = std::max(largest, std::abs(u));
  }
  std::vector<std::size_t> rigid;
  double dissipated = 0;
  for (std::size_t i = 0; i < truss.members(); ++i) {
    const double stretch = elongation_of(truss.columns[i], motion).nearest();
    if (std::abs(stretch) <= is_still * largest) {
      rigid.push_back(i);
    } else {
      dissipated += stretch * (stretch < 0 ? -compression[i] : tension[i]);
    }
  }
  std::vector<const TrussColumn*> still;
  for (const auto i : rigid) {
    // Upper bound of the cost, since the sign of a rounding error is unknown.
    const double cost = rounding * largest * std::max(tension[i], compression[i]);
    if (cost > significant_cost * dissipated) still.push_back(&truss.columns[i]);
  }
  TrussColumn reference;
  if (without_work) {
    for (std::size_t e = 0; e < truss.reference.size(); ++e) {
      if (truss.reference[e].sign() != 0)
        reference.emplace_back(e, Approximate{truss.reference[e], {}});
    }
    still.push_back(&reference);
  }
  return still.empty() ? motion : without_elongations(std::move(motion), still);
}

}  // namespace kusabi::verify
