// Results on the load factor of a truss and its worst case as numbers, in the units of the problem.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "engine/outcome.hpp"
#include "nodes/limit/model/load_curve.hpp"
#include "nodes/limit/root/worst_case.hpp"
#include "support/bracket.hpp"

namespace kusabi::limit {

/// A collapse.
struct LimitCollapse {
  double factor = 0;
  /// The least factor of the same load; nothing: the simplex method failed.
  std::optional<double> minimum;
  Eigen::VectorXd forces;  ///< q, n^m
  Eigen::VectorXd motion;  ///< u, n^d, f_R^T u = 1
};

/// Proved bounds of the factors that carry the nominal dead load.
struct NominalFactors {
  support::Bracket minimum;
  support::Bracket largest;
  double gap = 0;  ///< width up to which a bracket is an answer

  [[nodiscard]] bool proved() const {
    return minimum.proved_within(gap) && largest.proved_within(gap);
  }
};

/// Result of the 0-1 program (29) by itself, in the unit of the load factor. It is computed in
/// floating point and depends on M: not proved.
struct LimitZeroOne {
  std::optional<double> big_m;  ///< given M; nothing: derived from static cuts
  double lower = -std::numeric_limits<double>::infinity();  ///< minus infinity: none is known
  double upper = std::numeric_limits<double>::infinity();   ///< v^U; infinity: no point was found
  std::optional<double> start;  ///< initial v^U of the best sample (remark 4.5)
  double first_bound = -std::numeric_limits<double>::infinity();  ///< (38)
  double last_bound = -std::numeric_limits<double>::infinity();   ///< (38) after all cuts
  std::uint64_t cut_rounds = 0;                                   ///< values of k in Algorithm 5.1
  std::uint64_t cut_programs = 0;                                 ///< (51)
  std::uint64_t cuts = 0;                                         ///< disjunctive ones kept
  std::uint64_t root_programs = 0;  ///< other linear programs before the tree
  std::uint64_t nodes = 0;          ///< of Algorithm 4.2; depends on the number of ranks
  std::uint64_t programs = 0;  ///< linear programs of Algorithm 4.2; depends on the number of ranks
};

/// Result on the worst case.
struct LimitWorstCase {
  /// closed: the bounds meet, those of the simplex method where they are not proved.
  RootStatus status = RootStatus::failed;
  support::Bracket ends;  ///< open on both sides if some load has no factor
  /// Proved if both bounds are, and are close to each other; or that some load has no factor.
  support::Standing standing{};
  /// If (29) was requested.
  std::optional<LimitZeroOne> zero_one;
  /// The bounds are those of (29) only: M was given without evidence requested, or the run was
  /// stopped.
  bool as_printed = false;
  bool no_safe_m = false;  ///< (29) was requested but not solved: no safe M was found
  Eigen::VectorXd zeta;    ///< m, relative to the half-widths; empty: no critical load is known
  std::optional<LimitCollapse> collapse;
  Eigen::VectorXd overpowering_motion;  ///< of not_carried: its proof, n^d; may be empty
  std::uint64_t cuts = 0;               ///< static ones
  std::uint64_t nodes = 1;              ///< of the tree of signs; depends on the number of ranks
  std::uint64_t corners = 0;            ///< loads of this tree solved one by one
  /// Linear programs of the tree of signs; depends on the number of ranks.
  std::uint64_t tree_programs = 0;
  WorstCaseCounts counts;
  engine::Status search = engine::Status::solved;  ///< reason of an early end

  [[nodiscard]] bool proved() const { return is_proved(standing); }
};

struct LimitAnswer {
  LoadStatus status = LoadStatus::undetermined;  ///< `not_carried` only if that is proved
  std::optional<LimitCollapse> nominal;          ///< of `collapses`
  NominalFactors nominal_factors;                ///< of `collapses`
  std::optional<LimitWorstCase> worst;
  /// The same with the opposite reference load: its factors are minus the least factors of loads.
  /// Nothing: some load has no factor, the worst case is that of (29) as printed, or the run was
  /// stopped.
  std::optional<LimitWorstCase> reversed;
  std::vector<double> samples;  ///< factors; minus infinity: no factor
  // Requested curves over beta; nothing: the run was stopped, or there is no worst case.
  std::optional<LoadCurve> curve;        ///< lambda*(f_D + beta T zeta), zeta the critical one
  std::optional<LoadCurve> worst_curve;  ///< lambda_min(beta alpha), proved
  std::optional<LoadCurve> load_curve;   ///< lambda*(f_D + beta g), g the load of --curve-load
  /// Reason of an early end of the other results (nominal factor, samples, curves).
  engine::Status rest = engine::Status::solved;

  /// Reason of the first early end of a search; solved: none.
  [[nodiscard]] engine::Status ended() const;

  /// True if the results are complete and proved: the worst case, and the factors carried under
  /// every admissible load.
  [[nodiscard]] bool whole() const;
};

}  // namespace kusabi::limit
