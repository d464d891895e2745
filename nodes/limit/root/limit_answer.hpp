// What has been found out of the load factor of a truss and of its worst case: numbers alone, in
// the units of the problem.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "engine/outcome.hpp"
#include "nodes/limit/model/load_curve.hpp"
#include "nodes/limit/root/worst_case.hpp"

namespace kusabi::limit {

/// A collapse.
struct LimitCollapse {
  double factor = 0;
  /// The least factor at which the same load is carried; nothing: the simplex method failed.
  std::optional<double> least;
  Eigen::VectorXd forces;  ///< q, n^m
  Eigen::VectorXd motion;  ///< u, n^d, f_R^T u = 1
};

/// Between what the worst case is known to be, and whether exact arithmetic shows it.
struct LimitEnds {
  /// Minus infinity: none is known.
  double lower = -std::numeric_limits<double>::infinity();
  /// Minus infinity: a load is carried at no factor.
  double upper = -std::numeric_limits<double>::infinity();
  bool lower_proved = false;
  bool upper_proved = false;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& lower& upper& lower_proved& upper_proved;
  }
};

/// What the 0-1 program (29) has come to by itself, in the unit of the load factor. Floating point,
/// and an M that is large enough or not: not proved.
struct LimitZeroOne {
  std::optional<double> big_m;  ///< M as asked for; nothing: derived from static cuts
  double lower = -std::numeric_limits<double>::infinity();  ///< minus infinity: none is known
  double upper = std::numeric_limits<double>::infinity();   ///< v^U; infinity: no point was found
  std::optional<double> start;  ///< v^U at the beginning, of the best sample (remark 4.5)
  double first_bound = -std::numeric_limits<double>::infinity();  ///< (38)
  double last_bound = -std::numeric_limits<double>::infinity();   ///< (38) as the tree gets it
  std::uint64_t cut_rounds = 0;                                   ///< values of k in Algorithm 5.1
  std::uint64_t cut_programs = 0;                                 ///< (51)
  std::uint64_t cuts = 0;                                         ///< disjunctive ones kept
  std::uint64_t root_programs = 0;  ///< other linear programs before the tree
  std::uint64_t nodes = 0;          ///< of Algorithm 4.2: they depend on the number of ranks, as do
  std::uint64_t programs = 0;       ///< its linear programs
};

/// What is known of the worst case.
struct LimitWorstCase {
  RootStatus status = RootStatus::failed;
  LimitEnds ends;
  bool proved = false;  ///< whether both ends are, and are near to each other
  /// If (29) was asked for.
  std::optional<LimitZeroOne> zero_one;
  /// The ends are those of (29), and nothing else was looked at: its M was given, and no evidence
  /// was asked for, or it was stopped before.
  bool as_printed = false;
  bool no_safe_m = false;  ///< (29) was asked for, but not tried: no safe M was found
  Eigen::VectorXd zeta;    ///< m, relative to the half-widths; empty: no critical load is known
  std::optional<LimitCollapse> collapse;
  Eigen::VectorXd overpowering_motion;  ///< of not_carried: what shows it, n^d; may be empty
  std::uint64_t cuts = 0;               ///< static ones
  std::uint64_t nodes = 1;              ///< of the tree of signs, and
  std::uint64_t tree_programs = 0;      ///< its linear programs: they depend on the number of ranks
  WorstCaseCounts counts;
  engine::Status search = engine::Status::solved;  ///< why it ended before it was done
};

struct LimitAnswer {
  LoadStatus status = LoadStatus::undetermined;
  std::optional<LimitCollapse> nominal;  ///< of `collapses`
  bool no_factor_proved = false;         ///< whether exact arithmetic shows `not_carried`
  std::optional<LimitWorstCase> worst;
  /// The same with the reference load reversed: its factors are minus the least ones at which loads
  /// are carried. Nothing: the worst case is carried at no factor, is that of (29) as printed, or
  /// there was no time.
  std::optional<LimitWorstCase> reversed;
  std::vector<double> samples;  ///< factors; minus infinity: not carried
  // Curves over beta, those that were asked for; nothing: there was no time or no worst case.
  std::optional<LoadCurve> curve;        ///< lambda*(f_D + beta T zeta), zeta the critical one
  std::optional<LoadCurve> worst_curve;  ///< lambda_min(beta alpha), proved
  std::optional<LoadCurve> load_curve;   ///< lambda*(f_D + beta g), g a load of one's own
  /// Why what else was asked for (the nominal factor, samples, curves) was not done to the end.
  engine::Status rest = engine::Status::solved;

  /// Why the first of its searches that was not done ended; solved: all were.
  [[nodiscard]] engine::Status ended() const;

  /// Whether the question is answered, and the answer proved: the worst case, and which factors are
  /// carried under every admissible load.
  [[nodiscard]] bool whole() const;
};

}  // namespace kusabi::limit
