// Diagram of two reference loads: the pairs of factors that can be held with the dead load, as
// convex pieces with their sign patterns (docs/theory/loads.md, "Diagram of two loads"). That of a
// peg in a hole is the jamming diagram (Whitney 1982).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/hold/hold_search.hpp"

namespace kusabi::wedged {

/// The factors of one sign pattern: the convex hull of `vertices` plus all multiples of `rays`.
struct DiagramPiece {
  LoadedPattern pattern;                    ///< of the block
  std::vector<Eigen::Vector2d> vertices{};  ///< each has a state, proved
  std::vector<Eigen::Vector2d> rays{};      ///< none: bounded
  bool endless_all = false;                 ///< every pair of factors
  bool fine = true;  ///< the hull is the whole piece, up to `diagram_width` of its size
};

struct Diagram {
  engine::Status status = engine::Status::solved;
  /// True if it is proved that no other sign pattern holds a pair of factors, except for pairs on
  /// lines; otherwise this is computed.
  bool proved = true;
  bool open = false;  ///< patterns are undecided: pieces may be missing
  std::uint32_t block = 0;
  std::vector<DiagramPiece> pieces{};
  std::vector<HoldCost> costs{};
};

/// Distance, relative to that from a point inside, up to which a vertex is known.
inline constexpr double diagram_width = 1e-7;

/// Every rank makes the same call and gets the same result. @pre the loads act on one block
/// @param loaded with two reference loads
Diagram diagram_of(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                   Precision precision = Precision::escalating);

}  // namespace kusabi::wedged
