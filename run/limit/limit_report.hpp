// Results of `kusabi limit`: table and JSON.
#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/limit/root/limit_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"
#include "run/limit/limit.hpp"
#include "run/limit/limit_cases.hpp"
#include "run/output/output_folder.hpp"
#include "run/output/terminal_page.hpp"

namespace kusabi::run {

/// Both views of the answer in the governing load case. @pre the references outlive it
struct LimitReport {
  LimitReport(const LimitOptions& of, std::span<const LimitCase> all, const LimitCase& governs,
              int on_ranks)
      : options(of),
        cases(all),
        truss(governs.truss),
        problem(governs.problem),
        answer(governs.found.answer),
        residual(governs.found.residual),
        loss(governs.found.loss),
        residual_loss(governs.found.residual_loss),
        load_case(governs.name),
        ranks(on_ranks) {}

  const LimitOptions& options;
  std::span<const LimitCase> cases;  ///< all cases, at least one
  const problems::Structure& truss;
  const problems::LimitProblem& problem;
  const limit::LimitAnswer& answer;
  const std::optional<limit::LimitAnswer>& residual;  ///< struts at their residual strength
  const std::optional<limit::LossAnswer>& loss;
  const std::optional<limit::LossAnswer>& residual_loss;
  const std::string& load_case;  ///< empty: the file has none
  int ranks;

  /// @param page page of the output
  [[nodiscard]] std::string table(const Page& page) const;
};

/// The members `result` and `statistics` of a result file.
nlohmann::ordered_json result_json(const LimitReport& report);
nlohmann::ordered_json statistics_json(const LimitReport& report);

/// One row per member, in the order of the file: forces, utilisation, yielding.
void write_members_csv(std::ostream& out, const LimitReport& report);

/// Collapse under the nominal load and in the worst case, as far as they are known.
void draw_collapses(OutputFolder& folder, const LimitReport& report);

/// A load by nodes, in the order of the nodes; zeros are left out. @param load n^d
nlohmann::ordered_json load_json(const problems::LimitProblem& problem,
                                 const Eigen::VectorXd& load);

/// A collapse mode: nodes that move, members that yield. @param lost members that are not there
nlohmann::ordered_json mode_json(const problems::LimitProblem& problem,
                                 const Eigen::VectorXd& motion, std::span<const int> lost = {});

/// zeta of each uncertain load, by its name: the key `critical_parameters`. @param zeta m
nlohmann::ordered_json parameters_json(const problems::LimitProblem& problem,
                                       const Eigen::VectorXd& zeta);

/// The factors of the actions of a combination under a load: the key `critical_factors`.
nlohmann::ordered_json factors_json(const problems::Structure& truss,
                                    const problems::LimitProblem& problem,
                                    const Eigen::VectorXd& zeta);

}  // namespace kusabi::run
