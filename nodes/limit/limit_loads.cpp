// The nominal load first, in units that make it sure; then whatever else is asked for.
#include "nodes/limit/limit_loads.hpp"

#include <utility>

#include "nodes/evidence/verified_structure.hpp"
#include "nodes/limit/balanced_model.hpp"
#include "nodes/limit/compared_loads.hpp"
#include "nodes/limit/factor_curves.hpp"
#include "nodes/limit/proved_ends.hpp"
#include "nodes/limit/root_search.hpp"
#include "nodes/limit/worst_case_search.hpp"

namespace kusabi::limit {
namespace {

// The nominal load factor, in units that make it sure.
void find_nominal(RootSearch& search, const verify::Structure& truss, LimitAnswer& answer) {
  const auto& problem = search.problem();
  const auto shown = [&] {
    return shows_no_factor(truss, problem, search.model(),
                           Eigen::VectorXd::Zero(search.model().uncertain_count()),
                           search.load_factor().overpowering_motion());
  };
  answer.status = search.set_up(problems::limit_model(problem));
  if (search.ended()) return;
  if (answer.status == LoadStatus::collapses) {
    const double size = dissipation(problem, search.model(), search.nominal().motion);
    if (!is_out_of_balance(size)) return;
  } else if (answer.status == LoadStatus::not_carried && shown()) {
    answer.no_factor_proved = true;
    return;
  }
  answer.status = search.set_up(balanced_model(problem, 0));
  answer.no_factor_proved = answer.status == LoadStatus::not_carried && shown();
}

}  // namespace

LimitFindings limit_loads(engine::Campaign& campaign, const problems::Structure& structure,
                          const problems::LimitProblem& problem, const LimitQuestion& question) {
  const auto truss = evidence::verified_structure(structure);
  RootSearch search(campaign, problem, question.split_from);
  LimitFindings findings;
  auto& answer = findings.answer;
  find_nominal(search, truss, answer);
  if (answer.status != LoadStatus::collapses) {
    if (answer.status == LoadStatus::undetermined && search.ended()) {
      answer.rest = campaign.budget().why();
    }
    return findings;
  }
  answer.nominal = search.in_units(search.nominal(), search.model().dead);
  if (question.curve_load) {
    if (!search.ended()) {
      answer.load_curve = factor_curve(search, *question.curve_load, question.curve_to);
    }
    if (search.ended()) answer.rest = campaign.budget().why();
  }
  if (!question.alpha) return findings;
  search.settle_for(*question.alpha);
  const auto sample = [&]() -> std::optional<ZeroOneStart> {
    if (question.samples == 0) return {};
    SampledLoads sampled;
    if (!search.ended()) sampled = sampled_loads(search, question);
    if (search.ended()) answer.rest = campaign.budget().why();
    answer.samples = std::move(sampled.factors);
    return std::move(sampled.best);
  };
  const auto model = search.model();
  std::optional<ZeroOneStart> start;
  if (question.of_the_paper()) start = sample();
  WorstCaseSearch worst_case(search, question, truss, std::move(start));
  answer.worst = worst_case.solve();
  findings.certificate = std::move(worst_case.certificate());
  if (!search.is_set_up()) search.set_up(model);  // the last try was in units that did not do
  if (!question.of_the_paper()) sample();
  const bool known = answer.worst->collapse || answer.worst->status == RootStatus::not_carried;
  if (question.curve && known) {
    if (!search.ended()) {
      const Eigen::VectorXd load = dead_load(problem, answer.worst->zeta) - problem.dead;
      answer.curve = factor_curve(search, load, question.curve_to);
      answer.worst_curve = worst_factor_curve(search, truss, *question.alpha, question.curve_to);
    }
    if (search.ended()) answer.rest = campaign.budget().why();
  }
  return findings;
}

bool LimitAnswer::whole() const {
  if (status == LoadStatus::undetermined || rest != engine::Status::solved) return false;
  if (status == LoadStatus::not_carried) return no_factor_proved;
  const auto known = [](const std::optional<LoadCurve>& each) {
    return !each || !each->pieces.empty();
  };
  if (!known(curve) || !known(load_curve) || (worst_curve && !worst_curve->proved())) return false;
  return !worst || (worst->proved && worst->search == engine::Status::solved);
}

}  // namespace kusabi::limit
