// How many maximal cones there are at every friction coefficient, and which: a staircase.
//
// A cone is the pair (S, G) of the candidates that have a reaction and of those that have a gap in
// its relative interior; it lies within another if, and only if, both sets do. As friction grows,
// more and more pairs have configurations. So a pair is among the maximal ones from its own
// critical coefficient on up to that of the first greater pair, by which it is absorbed; solid
// cones, which have no candidate at rest, never are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/outcome.hpp"
#include "nodes/wedged/friction/friction_grid.hpp"
#include "nodes/wedged/sweep/sweep_tree.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "support/exact_count.hpp"

namespace kusabi::wedged {

/// Two friction coefficients between which something changes; both are decided.
struct FrictionBracket {
  double lower = 0, upper = 0;

  [[nodiscard]] bool has_within(double friction) const {
    return lower < friction && friction < upper;
  }
};

/// A cone, and the range of friction in which it is maximal.
struct ConeLife {
  std::uint32_t block = 0;
  SignPattern pattern;                      ///< of the whole problem's candidates
  FrictionBracket begins;                   ///< dead at the lower end, alive at the upper one
  std::optional<FrictionBracket> absorbed;  ///< maximal at the lower end, not at the upper one

  [[nodiscard]] bool solid() const { return pattern.at_rest.empty(); }
};

/// A leaf of which it cannot be told whether it lives, or what it is, above `lower`.
struct OpenLeaf {
  std::uint32_t block = 0;
  SignPattern pattern;
  double lower = 0;
};

/// How many maximal cones there are at one coefficient.
struct ConeCount {
  double friction = 0;
  support::ExactCount known;  ///< cones of the whole that are maximal here
  std::size_t open = 0;       ///< brackets and open leaves in which the coefficient lies

  [[nodiscard]] bool exact() const { return open == 0; }
};

/// A range in which the count does not change.
struct Tread {
  double from = 0, to = 0;
  support::ExactCount known;
  std::size_t open = 0;  ///< open leaves
};

struct SweepFindings {
  engine::Status status = engine::Status::solved;
  bool enumerated = false;  ///< whether the tree at the largest coefficient was done
  double most = 0;          ///< the largest coefficient
  std::size_t blocks = 1;
  std::vector<ConeLife> cones;  ///< in the order in which they begin
  std::vector<OpenLeaf> open;
  /// What it has cost: the tree at the largest coefficient, then the histories of its leaves.
  std::vector<engine::RankReport<SignPatternTree>> tree_ranks;
  std::vector<engine::RankReport<SweepTree>> history_ranks;

  /// @pre enumerated
  [[nodiscard]] ConeCount count_at(double friction) const;

  /// From zero to `most`; between two treads something changes. @pre enumerated
  [[nodiscard]] std::vector<Tread> staircase() const;

  [[nodiscard]] bool answered() const { return status == engine::Status::solved && open.empty(); }
};

/// A leaf of the tree at the largest coefficient.
struct LeafOfSweep {
  std::uint32_t block = 0;
  SignPattern pattern;                 ///< of the whole problem's candidates
  std::optional<LeafHistory> history;  ///< nothing: the search was stopped before
};

/// Takes the cones and the open leaves from the histories.
/// @param candidates of each block
void take_histories(SweepFindings& findings, const std::vector<LeafOfSweep>& leaves,
                    const std::vector<support::IndexSet>& candidates, const FrictionGrid& grid);

}  // namespace kusabi::wedged
