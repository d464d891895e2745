// Columns named as in the result file.
#include "run/limit/members_csv.hpp"

#include <algorithm>
#include <optional>

#include "problems/limit/collapse_mode.hpp"
#include "problems/limit/utilisation.hpp"
#include "run/limit/loss_report.hpp"
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

/// Cells on the loss of each member.
class Losses {
 public:
  explicit Losses(const limit::LossAnswer& loss) : loss_(loss) {}

  void add_member(CsvWriter& csv, int member) const {
    const auto single = std::ranges::find(loss_.singles, member, &limit::SingleLoss::member);
    if (single == loss_.singles.end()) {
      const bool stopped = loss_.singles.empty() && loss_.eligible > 0;
      csv.nothing().word(stopped ? "" : "kept");
    } else if (single->status == limit::LoadStatus::collapses) {
      csv.number(single->factor).word("collapses");
    } else {
      csv.nothing().word(loss_state(single->status));
    }
    const bool lost = std::ranges::find(loss_.lost, member) != loss_.lost.end();
    csv.word(lost ? "lost" : "");
  }

 private:
  const limit::LossAnswer& loss_;
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
  if (report.loss) csv.word("factor_after_loss").word("state_after_loss").word("worst_loss");
  csv.end_row();
  for (int i = 0; i < problem.member_count(); ++i) {
    const auto& bar = problem.members[static_cast<std::size_t>(i)];
    csv.text(problems::member_name(problem, i));
    for (const int node : {bar.first, bar.second})
      csv.text(problem.node_names[static_cast<std::size_t>(node)]);
    csv.number(problem.tension(i)).number(problem.compression(i));
    nominal.add_member(csv, i);
    worst.add_member(csv, i);
    if (report.loss) Losses(*report.loss).add_member(csv, i);
    csv.end_row();
  }
}

}  // namespace kusabi::run
