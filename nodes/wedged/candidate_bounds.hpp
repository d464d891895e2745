// How much each candidate can take part in any wedged configuration, found before a tree is
// searched, and the cuts that follow (docs/theory/wedged.md, "Cuts").
//
// Let s = sum_k r_nk. If u_ni <= gap_i s wherever r_i = 0, and r_ni <= reaction_i s wherever
// u_ni = 0, then, since one of both is zero,
//
//   u_ni / gap_i + r_ni / reaction_i <= s
//
// in every wedged configuration; the relaxation of a node in which i is undecided does not know it.
// Each bound is the value of a cone program, in which the cuts found so far take part.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nodes/wedged/contact_solver.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "solvers/conic/cut.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// Of a candidate, for sum_k r_nk = 1, in scaled units (see ContactSolver). A bound below zero says
/// that there is no configuration with this sign.
struct CandidateBounds {
  double gap = 0;
  double reaction = 1;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& gap& reaction;
  }
};

/// Finds the bounds of one block's candidates.
class CandidateBounding {
 public:
  /// @pre no motions
  CandidateBounding(const problems::WedgedProblem& problem, std::span<const double> friction,
                    conic::Tolerances tolerances);

  /// Improves all bounds once.
  void sweep();

  [[nodiscard]] const std::vector<CandidateBounds>& bounds() const { return bounds_; }
  [[nodiscard]] std::uint64_t programs() const { return programs_; }

 private:
  double improved(int candidate, bool touching);

  int count_;
  double least_gap_;
  ContactSolver solver_;
  std::vector<CandidateBounds> bounds_, trivial_;
  std::uint64_t programs_ = 0;
};

/// The cut of each of these candidates that has one.
std::vector<conic::Cut> cuts_of(const support::IndexSet& free,
                                std::span<const CandidateBounds> bounds);

}  // namespace kusabi::wedged
