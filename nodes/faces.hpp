// Of which living pattern a marginal leaf is a face.
//
// A leaf with t* = 0 has configurations, but none that satisfies every inequality strictly: its
// cone D(Y) of (14) has no interior. On regular structures there are hundreds of them. Some
// candidates in contact never carry a reaction, or some separated ones never move, and the
// configurations are those of another pattern as well (docs/theory.md, section 2).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "nodes/contact_solver.hpp"
#include "nodes/sign_pattern.hpp"
#include "problems/wedged_problem.hpp"

namespace kusabi::nodes {

/// Why D(Y) of a leaf (U, R) has no interior, and a larger cone that contains it.
struct Face {
  std::uint64_t within = 0;    ///< the set in contact of the living pattern
  std::uint64_t unloaded = 0;  ///< of U: r = 0 throughout D(Y)
  std::uint64_t unmoved = 0;   ///< of R: u_n = 0 throughout D(Y)
};

/// Recognises faces, leaf by leaf. What is zero is told from what is not by the widest gap between
/// the numbers of a configuration in the relative interior of D(Y); where no gap is wide, there is
/// no answer.
class FaceFinder {
 public:
  /// @param friction mu of each contact candidate, m numbers > 0
  /// @throws std::invalid_argument if the sizes do not fit or a number is out of range
  FaceFinder(const problems::WedgedProblem& problem, std::span<const double> friction);

  /// @param leaf marginal: |t*| is small, U and R cover everything
  /// @param living the sets in contact of all living patterns; the first that fits is taken
  /// @return nothing if `leaf` is no face of a living pattern, or if that cannot be told
  std::optional<Face> find(const SignPattern& leaf, std::span<const std::uint64_t> living);

 private:
  ContactSolver solver_;
};

}  // namespace kusabi::nodes
