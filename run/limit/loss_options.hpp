// Options of `kusabi limit` on the loss of members.
#pragma once

#include <optional>
#include <string>

#include "nodes/limit/model/limit_parameters.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"
#include "run/command/option_table.hpp"

namespace kusabi::run {

struct LossOptions {
  int maximum = 0;  ///< 0: the loss of members is not requested
  std::optional<double> at_least{};
  double sudden = 1;
  std::string kept{};  ///< list of names: a node, or a member as "a-b"

  void describe(OptionTable& table);

  /// Nothing if the loss of members is not requested.
  /// @throws WrongInput if a name in `kept` is neither a node nor a member
  [[nodiscard]] std::optional<limit::LossParameters> parameters(
      const problems::Structure& truss, const problems::LimitProblem& problem) const;
};

}  // namespace kusabi::run
