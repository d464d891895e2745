// Estimates of the set of candidates in contact: level sets of random combinations of the softest
// modes of F_nn. They are smooth on any face and need no coordinates.
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// The start of a trial.
struct ModeStart {
  support::IndexSet contact;
  double share = 0;  ///< see Linearisation
};

/// Starts of one block; the same numbers on all ranks.
class ModeStarts {
 public:
  explicit ModeStarts(const problems::WedgedProblem& block);

  /// The start with this number, which determines it.
  [[nodiscard]] ModeStart at(std::uint64_t number) const;

 private:
  Eigen::MatrixXd modes_;  // m x count, the softest first
};

}  // namespace kusabi::wedged
