// WholeStates: whole-structure solver common to all outputs, built at first use, since it takes
// seconds for a large body.
#pragma once

#include <optional>

#include "problems/structure/checks/checked_structure.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "problems/wedged/whole_structure.hpp"

namespace kusabi::run {

class WholeStates {
 public:
  /// Both must outlive it.
  WholeStates(const problems::CheckedStructure& structure, const problems::WedgedProblem& problem)
      : structure_(structure), problem_(problem) {}

  [[nodiscard]] const problems::Structure& structure() const { return structure_; }
  [[nodiscard]] const problems::WedgedProblem& problem() const { return problem_; }
  [[nodiscard]] const problems::WholeStructure& whole() const {
    if (!whole_) whole_.emplace(structure_, problem_);
    return *whole_;
  }

 private:
  const problems::CheckedStructure& structure_;
  const problems::WedgedProblem& problem_;
  mutable std::optional<problems::WholeStructure> whole_;
};

}  // namespace kusabi::run
