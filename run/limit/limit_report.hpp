// `kusabi limit FILE`: collapse load factor of a truss ((5) of the limit paper), and with `--alpha`
// its least value under uncertain dead loads ((13)): options, tables, JSON, CSV and pictures.
#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "answer/verdict.hpp"
#include "engine/options.hpp"
#include "nodes/limit/loss/loss_answer.hpp"
#include "nodes/limit/model/limit_parameters.hpp"
#include "nodes/limit/root/limit_answer.hpp"
#include "problems/limit/half_widths.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"
#include "run/limit/limit_cases.hpp"
#include "run/output/output_file.hpp"
#include "run/output/terminal_page.hpp"

namespace kusabi::run {

struct LimitOptions {
  ProblemInput input;
  std::string load_case;   ///< requested load case; empty: all
  std::string curve_load;  ///< file of the load of a curve
  problems::RequestedHalfWidths asked;
  limit::LimitParameters parameters;         ///< its alpha follows from `asked` and the file
  engine::Limits limits;                     ///< limits of the tree search
  limit::LossParameters loss{.maximum = 0};  ///< 0: the loss of members is not requested
  std::string kept;                          ///< nodes and members, as in the call
  CheckpointChoice checkpoint;
};

/// Load factors that are carried, and the members that yield at their ends.
answer::Verdict limit_verdict(const LimitOptions& options, std::span<const LimitCase> cases);

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

/// The requested curves, breakpoint by breakpoint.
std::string curves_text(const LimitReport& report);

/// Adds the keys of the curves to `result` (docs/result-files.md).
void add_curves(nlohmann::ordered_json& result, const LimitReport& report);

/// One row per breakpoint, curve by curve.
void write_curves_csv(std::ostream& out, const LimitReport& report);

/// The word in results for what remains after a loss.
const char* loss_state(limit::LoadStatus status);

/// The worst loss, and the members whose loss alone lowers the factor.
std::string loss_text(const problems::LimitProblem& problem, const problems::Structure& truss,
                      const limit::LossAnswer& loss);

/// Names of members.
std::vector<std::string> names_of(const problems::LimitProblem& problem,
                                  const std::vector<int>& members);

/// The key `member_loss` of a result: what the answer does not have.
nlohmann::ordered_json loss_json(const problems::LimitProblem& problem,
                                 const problems::Structure& truss, const limit::LossAnswer& loss);

/// Of the load case in which the least known factor remains. What the search of a case left open
/// before it had an answer, the nominal load bounds from above: no loss raises the factor.
/// @pre parameters.loss, and no case is carried at no factor without a loss
answer::MemberLoss member_loss(std::span<const LimitCase> cases,
                               const limit::LimitParameters& parameters);

/// Lines of the table. @pre report.residual
std::string strut_text(const LimitReport& report);

/// The key `struts` of a result. @pre report.residual
nlohmann::ordered_json strut_json(const LimitReport& report);

/// "With all struts at their residual strength the dead load is carried at no load factor.", if that
/// is so in some case; empty otherwise, and if that is so at full strength in some case.
std::string strut_sentence(std::span<const LimitCase> cases);

/// Lines on the bounds of (29).
std::string printed_ends_text(const limit::LimitWorstCase& worst);

/// Lines on the result and the cost of (29). @pre worst.zero_one
std::string zero_one_text(const limit::LimitWorstCase& worst);

/// JSON without values that depend on the number of ranks.
nlohmann::ordered_json zero_one_json(const limit::LimitZeroOne& zero_one);

/// True if its M is too small: exact arithmetic, or the load of the best point of the printed
/// method, refutes (29).
bool is_refuted(const limit::LimitWorstCase& worst);

/// Unit of alpha; nothing where alpha multiplies the uncertain loads.
std::optional<std::string_view> unit_of_alpha(const problems::LimitProblem& problem);

/// Members with the highest utilisation besides those that yield, in descending order.
std::string utilisation_text(const problems::LimitProblem& problem,
                             const limit::LimitCollapse& collapse);

/// The uncertain loads by direction and value, or the factors of the actions of a combination; empty
/// if zeta is.
/// @param truss of the load case  @param zeta m, in multiples of the uncertain loads
std::string critical_load_text(const problems::Structure& truss,
                               const problems::LimitProblem& problem, const Eigen::VectorXd& zeta);

/// "1.35 self, 1.05 crane, -0.9 wind; 1.5 snow times the load factor"; empty if the load case is no
/// combination of actions, or zeta is empty.
std::string combination_text(const problems::Structure& truss,
                             const problems::LimitProblem& problem, const Eigen::VectorXd& zeta);

}  // namespace kusabi::run
