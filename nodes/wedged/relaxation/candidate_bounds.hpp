// Bounds of reactions and gaps of each candidate in wedged configurations, computed before the
// search, and the cuts that follow (docs/theory/wedged.md, "Bounds and cuts").
//
// Let s = sum_k r_nk. If u_ni <= gap_i s wherever r_i = 0, and r_ni <= reaction_i s wherever u_ni =
// 0, then, since one of both is zero,
//
//   u_ni / gap_i + r_ni / reaction_i <= s
//
// in every wedged configuration. The relaxation of a node with undecided i does not imply it, and
// is weak without it. For an unconstrained body gap_i may be infinite, if it can move away from i
// and towards no other candidate; then r_ni <= reaction_i s remains. Each bound is proved by a cone
// program with the cuts found so far, so repeated sweeps over all candidates improve all of them.
//
// Under loads (docs/theory/loads.md, "Bounds and cuts") s also has the amount of each load.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "nodes/wedged/relaxation/mean_motion.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "solvers/conic/cut.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// State of a candidate in a configuration.
enum class Side {
  contact,    ///< u_n = 0
  separated,  ///< r = 0
};

/// Bounds of a candidate for sum_k r_nk = 1, in scaled units (see ContactSolver). A negative bound
/// means that there is no configuration on this side.
struct CandidateBounds {
  /// Of u_n, separated.
  double gap = std::numeric_limits<double>::infinity();
  double reaction = 1;  ///< of r_n, in contact

  /// True if there may be configurations on each side.
  [[nodiscard]] bool can_separate() const { return gap > 0; }
  [[nodiscard]] bool can_touch() const { return reaction > 0; }
  [[nodiscard]] bool is_free() const { return can_separate() && can_touch(); }
};

/// A bound with its evidence, in units of the problem (docs/certificates.md).
struct ProvedBound {
  std::uint32_t theorem = 0;  ///< of the certificate; for wedged configurations the block
  int candidate = 0;          ///< of the block; of the whole problem in a certificate
  Side side = Side::contact;
  double maximum = 0;  ///< of r_n or u_n, for s = 1; negative: none on this side
  /// Multipliers of the normal displacements, m; for an unconstrained body the mean motion of w, p;
  /// with an equation its multiplier; those of the cuts of all candidates, m, and of the bound itself
  /// unless `maximum` is negative.
  std::vector<double> numbers;

  [[nodiscard]] bool excludes_side() const { return maximum < 0; }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& theorem& candidate& side& maximum& numbers;
  }
};

/// True if the bounds exclude the side of one of these candidates.
bool excludes_all(std::span<const CandidateBounds> bounds, const support::IndexSet& contact,
                  const support::IndexSet& separated);

/// The first of these candidates that has configurations on one side only.
std::optional<int> one_sided(const support::IndexSet& free,
                             std::span<const CandidateBounds> bounds);

/// The cuts of the given candidates with bounds. A common factor makes the largest coefficient one.
std::vector<conic::Cut> cuts_of(const support::IndexSet& candidates,
                                std::span<const CandidateBounds> bounds);

/// Loads, which are the last candidates of a problem, and an equation, the last column of its modes
/// (nodes/wedged/hold/load_program.hpp).
struct LoadPart {
  int loads = 0;
  conic::SideEquation equation = conic::SideEquation::none;
  double equation_unit = 1;  ///< factor of the equation in units of the problem

  [[nodiscard]] bool has_equation() const { return equation != conic::SideEquation::none; }
};

/// Evidence of multipliers without cuts, in units of the problem: those of the normal displacements, m,
/// the mean motion of w, p, and with an equation its multiplier.
/// @param multipliers as ContactSolver::multipliers()  @param motions columns of the problem's modes
/// @param mean_motion of the problem without loads
std::vector<double> node_evidence(const Eigen::VectorXd& multipliers, Eigen::Index motions,
                                  double unit, const MeanMotion& mean_motion, const LoadPart& part);

/// Evidence of a solution with cuts, in units of the problem: its multipliers of the normal
/// displacements, m, the mean motion of w, p, with an equation its multiplier, and by candidate those
/// of s >= u_n / gap + r_n / reaction, m.
/// @param mean_motion of the problem without loads
std::vector<double> cut_evidence(const ContactSolver& solver, const MeanMotion& mean_motion,
                                 std::span<const conic::Cut> cuts, const LoadPart& part = {});

/// Finds the bounds of one block's candidates, one program after another.
class CandidateBounding {
 public:
  /// Initial bounds that need no program; an unconstrained body has none.
  /// @param problem of the block  @param friction of its candidates, and of the loads
  CandidateBounding(const problems::WedgedProblem& problem, std::span<const double> friction,
                    conic::Tolerances tolerances)
      : CandidateBounding(problem, friction, tolerances, {}, MeanMotion(problem)) {}
  /// The same under loads. @param mean_motion of the block without loads
  CandidateBounding(const problems::WedgedProblem& problem, std::span<const double> friction,
                    conic::Tolerances tolerances, const LoadPart& part, MeanMotion mean_motion);

  /// A bound by one program, which depends on the added bounds only. Nothing if it is hardly better
  /// than the present one.
  [[nodiscard]] std::optional<ProvedBound> improved(int candidate, Side side);

  void add_bound(ProvedBound bound);

  /// Makes improved() throw support::Stopped soon after the run is to stop.
  void end_when(const support::Stop& stop) { solver_.end_when(stop); }

  /// m.
  [[nodiscard]] int candidates() const { return static_cast<int>(bounds_.size()); }
  [[nodiscard]] const std::vector<CandidateBounds>& bounds() const { return bounds_; }
  /// All added bounds, in this order; each is proved with those before.
  [[nodiscard]] const std::vector<ProvedBound>& proved() const { return proved_; }

 private:
  [[nodiscard]] double& known(int candidate, Side side);
  [[nodiscard]] double in_units(double scaled, Side side) const;
  [[nodiscard]] std::vector<double> evidence(std::span<const conic::Cut> cuts, Side side) const;

  ContactSolver solver_;
  MeanMotion mean_motion_;
  LoadPart part_;
  std::vector<CandidateBounds> bounds_, minimum_;
  std::vector<ProvedBound> proved_;
};

/// Bounds of a block's candidates before its tree is searched.
struct RootBounds {
  std::vector<CandidateBounds> bounds;  ///< empty: not computed
  std::vector<ProvedBound> proved;      ///< candidates as the whole problem numbers them
  std::uint64_t programs = 0;
};

/// Sweeps over the candidates of a block until the bounds hardly improve, or the budget is used.
/// The programs are distributed over the ranks; the result does not depend on their number. Every
/// rank makes the same call.
/// @return the number of programs
std::uint64_t improve_bounds(engine::Analysis& analysis, CandidateBounding& bounding);

/// The bounds of a block by improve_bounds().
RootBounds bound_candidates(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                            std::span<const double> friction, std::uint32_t block,
                            conic::Tolerances tolerances);

}  // namespace kusabi::wedged
