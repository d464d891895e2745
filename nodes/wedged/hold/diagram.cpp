// One tree for each quadrant about a point lists the patterns.
#include "nodes/wedged/hold/diagram.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// The point about which the quadrants are, in units of the loads: of no particular pattern.
const Eigen::Vector2d off_the_axes(0.0137, -0.0239);
/// Angle of quadrants about the origin: their axes are of no particular pattern either, as those of
/// a load at a candidate are.
constexpr double off_the_loads = 0.2718;

// Units of both loads: their ratio to the dead load in terms of displacements.
Eigen::Vector2d units_of(const LoadedProblem& block) {
  const double dead = scale_of(block, {1, 0, 0});
  Eigen::Vector2d units;
  for (int k = 0; k < 2; ++k) {
    const double own = scale_of(block, k == 0 ? LoadShare{0, 1, 0} : LoadShare{0, 0, 1});
    units[k] = dead > 0 && std::isfinite(dead / own) ? dead / own : 1;
  }
  return units;
}

/// A pattern and a point that it holds.
struct Begin {
  LoadedPattern pattern;
  Eigen::Vector2d point;
};

// Signs of a load in the quadrants; zero, once, for a load that does not act on the block.
std::vector<double> signs_of(const LoadedProblem& block, Eigen::Index load) {
  if (!acts(block, (block.has_dead ? 1 : 0) + load)) return {0};
  return {1, -1};
}

// Without a dead part the states can be multiplied, and the quadrants are about the origin.
// @param unit of both factors
std::vector<Begin> patterns_of(engine::Analysis& analysis, const LoadedProblem& block, double mu,
                               Precision precision, const Eigen::Vector2d& unit, Diagram& found) {
  std::vector<Begin> all;
  const bool dead = is_under_dead(block);
  const auto first_signs = signs_of(block, 0), second_signs = signs_of(block, 1);
  const bool both = first_signs.front() * second_signs.front() != 0;
  const Eigen::Matrix2d axes = Eigen::Rotation2Dd(both && !dead ? off_the_loads : 0).matrix();
  for (const double first : first_signs) {
    for (const double second : second_signs) {
      const auto share = [&](double own, const Eigen::Vector2d& at) {
        return LoadShare{own, at.x() * unit.x(), at.y() * unit.y()};
      };
      std::vector<LoadShare> shares;
      if (dead) shares.push_back(share(1, off_the_axes));
      if (first != 0) shares.push_back(share(0, first * axes.col(0)));
      if (second != 0) shares.push_back(share(0, second * axes.col(1)));
      HoldTree tree(block, shares, mu, precision);
      const auto outcome = all_leaves(analysis, tree);
      found.costs.push_back({mu, 0, 0, outcome.opened, outcome.tally.iterations});
      if (outcome.status != engine::Status::solved) {
        found.status = outcome.status;
        return all;
      }
      const bool at_limit = std::ranges::any_of(outcome.tally.limits, [&](const auto& leaf) {
        return resists_all(block.problem, leaf.pattern.contact, mu);
      });
      found.unresolved = found.unresolved || outcome.tally.undecided > 0 || at_limit;
      if (outcome.tally.undecided + outcome.tally.computed != 0 || !outcome.tally.limits.empty())
        found.outside = support::Standing::computed;
      for (const auto& leaf : outcome.leaves) {
        const bool known = std::ranges::any_of(
            all, [&](const Begin& each) { return each.pattern == leaf.pattern; });
        if (known) continue;
        Eigen::Vector2d beside(0, 0);
        if (first != 0) beside += first * leaf.amounts[dead ? 1 : 0] * axes.col(0);
        if (second != 0) beside += second * leaf.amounts.back() * axes.col(1);
        all.push_back({leaf.pattern, dead ? Eigen::Vector2d(off_the_axes + beside / leaf.amounts[0])
                                          : beside.normalized()});
      }
    }
  }
  return all;
}

// A piece of one list and one of the other, wherever they have a common part.
std::vector<DiagramPiece> common_pieces(const std::vector<DiagramPiece>& one,
                                        const std::vector<DiagramPiece>& other) {
  std::vector<DiagramPiece> result;
  for (const auto& a : one) {
    for (const auto& b : other) {
      DiagramPiece both = a.is_whole_plane ? b : a;
      both.pattern = {a.pattern.contact | b.pattern.contact,
                      a.pattern.separated | b.pattern.separated};
      both.fine = a.fine && b.fine;
      if (!a.is_whole_plane && !b.is_whole_plane) {
        auto part = common_part(a.hull, b.hull);
        if (!part) continue;
        both.hull = std::move(*part);
      }
      result.push_back(std::move(both));
    }
  }
  return result;
}

}  // namespace

Diagram diagram_of(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                   Precision precision) {
  Diagram found{.outside = support::Standing::proved};
  found.pieces.push_back({.pattern = {}, .is_whole_plane = true});
  const auto unit = units_of(loaded);
  for (const auto& candidates : problems::blocks_of(loaded.problem)) {
    const LoadedProblem block = loaded_block(loaded, candidates);
    if (!is_loaded(block)) continue;
    const auto begins = patterns_of(analysis, block, mu, precision, unit, found);
    std::vector<DiagramPiece> own;
    for (const auto& [pattern, point] : begins) {
      if (found.status == engine::Status::solved && analysis.ended()) {
        found.status = analysis.stop_reason();
      }
      if (found.status != engine::Status::solved) break;
      own.push_back(piece_around(block, mu, precision, pattern, unit, point));
      own.back().pattern = in_whole(pattern, candidates);
    }
    if (found.status != engine::Status::solved) {
      found.pieces.clear();
      return found;
    }
    found.pieces = common_pieces(found.pieces, own);
  }
  const auto in_factors = [&](Eigen::Vector2d& point) { point = point.cwiseProduct(unit); };
  for (auto& piece : found.pieces) {
    std::ranges::for_each(piece.hull.vertices, in_factors);
    std::ranges::for_each(piece.hull.rays, in_factors);
  }
  return found;
}

}  // namespace kusabi::wedged
