// Maximal cones as a piecewise constant function of the friction coefficient.
//
// A cone is the pair (S, G) of the candidates with a reaction and of those with a gap in its
// relative interior; it lies within another if, and only if, both sets do. As friction grows, more
// pairs have configurations. A pair is maximal from its own critical coefficient up to that of the
// first larger pair, which absorbs it; solid cones, which have no inactive candidate, are never
// absorbed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/outcome.hpp"
#include "nodes/wedged/friction/friction_grid.hpp"
#include "nodes/wedged/sweep/sweep_tree.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "support/exact_count.hpp"

namespace kusabi::wedged {

/// Two decided friction coefficients with a change between them.
struct FrictionBracket {
  double lower = 0, upper = 0;

  [[nodiscard]] bool contains(double friction) const {
    return lower < friction && friction < upper;
  }
};

/// A cone, and the range of friction in which it is maximal.
struct ConeRange {
  std::uint32_t block = 0;
  SignPattern pattern;     ///< of the whole problem's candidates
  FrictionBracket begins;  ///< infeasible at the lower bound, feasible at the upper one
  std::optional<FrictionBracket> absorbed;  ///< maximal at the lower bound, not at the upper one

  [[nodiscard]] bool solid() const { return pattern.inactive.empty(); }
};

/// A leaf whose state is numerically undecided above `lower`.
struct OpenLeaf {
  std::uint32_t block = 0;
  SignPattern pattern;
  double lower = 0;
};

/// The number of maximal cones at one coefficient.
struct ConeCount {
  double friction = 0;
  support::ExactCount known;   ///< cones of the whole that are maximal here
  std::size_t unresolved = 0;  ///< brackets and undecided leaves that contain the coefficient

  [[nodiscard]] bool exact() const { return unresolved == 0; }
};

/// A range with constant count.
struct CountRange {
  double from = 0, to = 0;
  support::ExactCount known;
  std::size_t unresolved = 0;  ///< undecided leaves
};

struct SweepFindings {
  engine::Status status = engine::Status::solved;
  bool enumerated = false;  ///< true if the tree at the largest coefficient is complete
  double maximum = 0;       ///< the largest coefficient
  std::size_t blocks = 1;
  std::vector<ConeRange> cones;  ///< in the order of their critical coefficients
  std::vector<OpenLeaf> unresolved;
  /// Costs: the tree at the largest coefficient, then the histories of its leaves.
  std::vector<engine::RankReport<SignPatternTree>> tree_ranks;
  std::vector<engine::RankReport<SweepTree>> history_ranks;

  /// @pre enumerated
  [[nodiscard]] ConeCount count_at(double friction) const;

  /// From zero to `maximum`; between two ranges there is a change. @pre enumerated
  [[nodiscard]] std::vector<CountRange> staircase() const;

  [[nodiscard]] bool answered() const {
    return status == engine::Status::solved && unresolved.empty();
  }
};

/// A leaf of the tree at the largest coefficient.
struct SweptLeaf {
  std::uint32_t block = 0;
  SignPattern pattern;                 ///< of the whole problem's candidates
  std::optional<LeafHistory> history;  ///< nothing: the search was stopped before
};

/// Adds the cones and the undecided leaves of the histories.
/// @param candidates of each block
void add_histories(SweepFindings& findings, const std::vector<SweptLeaf>& leaves,
                   const std::vector<support::IndexSet>& candidates, const FrictionGrid& grid);

}  // namespace kusabi::wedged
