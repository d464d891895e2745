// Columns named as in the result file.
#include "run/limit/members_csv.hpp"

#include <optional>

#include "problems/limit/collapse_mode.hpp"
#include "problems/limit/utilisation.hpp"
#include "run/output/csv.hpp"

namespace kusabi::run {
namespace {

/// One collapse by members; all cells are empty if there is none.
class Collapse {
 public:
  Collapse(const problems::LimitProblem& problem,
           const std::optional<limit::LimitCollapse>& collapse) {
    if (!collapse) return;
    forces_ = collapse->forces;
    utilisation_ = problems::utilisation(problem, forces_);
    elongation_ = Eigen::VectorXd::Zero(problem.member_count());
    for (const auto& [member, elongation] :
         problems::collapse_mode(problem, collapse->motion).yielding)
      elongation_(member) = elongation;
  }

  void add_member(CsvWriter& csv, int member) const {
    if (forces_.size() == 0) {
      csv.nothing().nothing().nothing();
      return;
    }
    csv.number(forces_(member)).number(utilisation_(member));
    const double elongation = elongation_(member);
    csv.word(elongation > 0 ? "tension" : elongation < 0 ? "compression" : "");
  }

 private:
  Eigen::VectorXd forces_;
  Eigen::VectorXd utilisation_;
  Eigen::VectorXd elongation_;  // 0: elastic
};

}  // namespace

void write_members_csv(std::ostream& out, const LimitReport& report) {
  const auto& problem = report.problem;
  const auto& answer = report.answer;
  const Collapse nominal(problem, answer.nominal);
  const Collapse worst(problem, answer.worst ? answer.worst->collapse : std::nullopt);
  CsvWriter csv(out);
  for (const char* const column :
       {"member", "first", "second", "yield_tension", "yield_compression", "nominal_forces",
        "nominal_utilisation", "nominal_mode", "forces", "utilisation", "collapse_mode"})
    csv.word(column);
  csv.end_row();
  for (int i = 0; i < problem.member_count(); ++i) {
    const auto& bar = problem.members[static_cast<std::size_t>(i)];
    csv.text(problems::member_name(problem, i));
    for (const int node : {bar.first, bar.second})
      csv.text(problem.node_names[static_cast<std::size_t>(node)]);
    csv.number(problem.tension(i)).number(problem.compression(i));
    nominal.add_member(csv, i);
    worst.add_member(csv, i);
    csv.end_row();
  }
}

}  // namespace kusabi::run
