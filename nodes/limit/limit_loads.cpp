// Nominal load in suitable units first, then the other results.
#include "nodes/limit/limit_loads.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "nodes/evidence/verified_structure.hpp"
#include "nodes/limit/compared_loads.hpp"
#include "nodes/limit/factor_curves.hpp"
#include "nodes/limit/guaranteed_interval.hpp"
#include "nodes/limit/loss/loss_search.hpp"
#include "nodes/limit/model/balanced_model.hpp"
#include "nodes/limit/root/root_search.hpp"
#include "nodes/limit/search/limit_evidence.hpp"
#include "nodes/limit/search/nominal_proof.hpp"
#include "nodes/limit/search/proved_ends.hpp"
#include "nodes/limit/search/worst_case_search.hpp"
#include "verify/limit/truss_consistency.hpp"

namespace kusabi::limit {
namespace {

using verify::LimitClaim;

// Solves the nominal load in suitable units.
// @param shown whether it is proved that the load has no factor
LoadStatus set_up(RootSearch& search, const std::function<bool()>& shown) {
  const auto& problem = search.problem();
  auto status = search.set_up(problems::limit_model(problem));
  if (search.ended()) return status;
  if (status == LoadStatus::collapses) {
    const double size = dissipation(problem, search.model(), search.nominal().motion);
    if (!is_out_of_balance(size)) return status;
  } else if (status == LoadStatus::not_carried && shown()) {
    return status;
  }
  status = search.set_up(balanced_model(problem, 0));
  if (status == LoadStatus::not_carried) shown();
  return status;
}

void find_nominal(RootSearch& search, const verify::Structure& truss,
                  const LimitParameters& parameters, LimitFindings& findings) {
  const auto shown = [&] {
    const auto& model = search.model();
    auto evidence = evidence_of_no_factor(
        truss, search.problem(), model, parameters.alpha.value_or(0),
        Eigen::VectorXd::Zero(model.uncertain_count()), search.load_factor().overpowering_motion());
    if (!evidence) return false;
    findings.theorems = {std::move(*evidence)};
    return true;
  };
  auto& answer = findings.answer;
  answer.status = set_up(search, shown);
  const bool is_shown = !findings.theorems.empty();
  if (answer.status == LoadStatus::not_carried && !is_shown)
    answer.status = LoadStatus::undetermined;
  if (answer.status != LoadStatus::collapses) return;
  auto proof = prove_nominal(search, truss);
  answer.nominal = std::move(proof.collapse);
  answer.nominal_factors = proof.factors;
  const bool without_uncertainty = parameters.alpha.value_or(0) == 0;
  if (without_uncertainty && !parameters.loss) findings.theorems = std::move(proof.theorems);
}

// The claims of a certificate begin with that on the largest factors, or that no factor is carried.
void add_theorem(WorstCaseSearch& search, const LimitWorstCase& worst, LimitClaim claim,
                 LimitFindings& findings) {
  auto& theorem = search.theorem();
  auto& theorems = findings.theorems;
  if (!theorem) return;
  // That there is no factor is a theorem on the reference load itself, not on its opposite.
  if (claim == LimitClaim::minimum) of_least_factors(*theorem);
  if (worst.status == RootStatus::not_carried) {
    theorems.clear();
    theorem->claim = LimitClaim::none;
  } else if (claim == LimitClaim::minimum && theorems.empty()) {
    return;
  }
  theorems.push_back(std::move(*theorem));
}

// The worst case with the opposite reference load, for least factors, by static cuts. Large trusses
// need no bound from above for a least factor that exceeds the largest one, since the guaranteed
// interval is then empty.
void find_least_factors(engine::Analysis& analysis, const verify::Structure& truss,
                        const problems::LimitProblem& problem, const LimitParameters& asked,
                        LimitFindings& findings) {
  auto mirrored = problem;
  mirrored.reference = -problem.reference;
  const auto mirrored_truss = verify::with_reversed_reference(truss);
  analysis.say_now_and_then([] {
    return "the least factors: the search again, with the reference load and the signs of factors "
           "reversed";
  });
  RootSearch search(analysis, mirrored, asked.split_from);
  const auto never = [] { return false; };
  if (set_up(search, never) == LoadStatus::collapses) search.choose_units(*asked.alpha);
  if (search.is_set_up()) {
    const auto& largest = findings.answer.worst->ends;
    if (is_proved(largest.upper)) {
      search.set_enough(-largest.at_most() - answered_gap * search.model().factor_unit);
    }
    const LimitParameters parameters{.alpha = asked.alpha, .corners = asked.corners};
    WorstCaseSearch minimum(search, parameters, mirrored_truss);
    const auto& worst = findings.answer.reversed.emplace(minimum.solve());
    add_theorem(minimum, worst, LimitClaim::minimum, findings);
  } else if (search.ended()) {
    findings.answer.rest = analysis.budget().stop_reason();
  }
}

// The worst case for alpha = 0, which is that of the nominal load.
LimitWorstCase worst_without_uncertainty(const LimitAnswer& answer, const support::Bracket& factor,
                                         Eigen::Index uncertain) {
  LimitWorstCase worst;
  worst.ends = factor;
  const bool proved = factor.proved_within(answer.nominal_factors.gap);
  worst.standing = support::proved_if(proved);
  worst.status = proved ? RootStatus::closed : RootStatus::open;
  worst.zeta = Eigen::VectorXd::Zero(uncertain);
  worst.collapse = answer.nominal;
  return worst;
}

void find_worst_cases(RootSearch& search, const LimitParameters& parameters,
                      const verify::Structure& truss, std::optional<ZeroOneStart> start,
                      LimitFindings& findings) {
  if (*parameters.alpha == 0 && parameters.method == LimitMethod::static_cuts) {
    auto& answer = findings.answer;
    const auto& [minimum, factor, gap] = answer.nominal_factors;
    const auto uncertain = search.model().uncertain_count();
    answer.worst = worst_without_uncertainty(answer, factor, uncertain);
    answer.reversed = worst_without_uncertainty(answer, minimum.negative(), uncertain);
    return;
  }
  findings.theorems.clear();
  WorstCaseSearch largest(search, parameters, truss, std::move(start));
  const auto& worst = findings.answer.worst.emplace(largest.solve());
  add_theorem(largest, worst, LimitClaim::largest, findings);
  if (worst.status == RootStatus::not_carried || worst.as_printed) return;
  find_least_factors(search.analysis(), truss, search.problem(), parameters, findings);
}

// For sudden losses the yield forces are divided by the dynamic factor: the loads grow by it, and
// so does the reference load.
LossAnswer worst_loss(RootSearch& search, const verify::Structure& truss,
                      const LimitParameters& parameters) {
  const double sudden = parameters.loss->sudden;
  auto problem = search.problem();
  problem.tension /= sudden;
  problem.compression /= sudden;
  const double alpha = parameters.alpha.value_or(0);
  const auto model = problems::limit_model(problem, search.model().force_unit / sudden);
  return LossSearch(search.analysis(), truss, problem, model, *parameters.loss, alpha).solve();
}

// Limit loads with the strengths of the file.
LimitFindings loads_at_strength(engine::Analysis& analysis, const problems::Structure& structure,
                                const problems::LimitProblem& problem,
                                const LimitParameters& parameters) {
  const auto truss = evidence::verified_structure(structure);
  RootSearch search(analysis, problem, parameters.split_from);
  LimitFindings findings;
  auto& answer = findings.answer;
  const auto note_end = [&] {
    if (search.ended()) answer.rest = analysis.budget().stop_reason();
  };
  find_nominal(search, truss, parameters, findings);
  if (answer.status != LoadStatus::collapses) {
    if (answer.status == LoadStatus::undetermined) note_end();
    return findings;
  }
  if (!answer.nominal_factors.proved()) note_end();
  if (!search.is_set_up()) {  // stopped in the last set_up() of the proof
    note_end();
    return findings;
  }
  if (parameters.curve_load) {
    if (!search.ended()) {
      answer.load_curve = factor_curve(search, *parameters.curve_load, parameters.curve_to);
    }
    note_end();
  }
  if (parameters.loss) {
    note_end();
    if (!search.ended()) findings.loss = worst_loss(search, truss, parameters);
    return findings;
  }
  if (!parameters.alpha) return findings;
  search.choose_units(*parameters.alpha);
  if (!search.is_set_up()) {
    note_end();
    return findings;
  }
  const auto sample = [&]() -> std::optional<ZeroOneStart> {
    if (parameters.samples == 0) return {};
    SampledLoads sampled;
    if (!search.ended()) sampled = sampled_loads(search, parameters);
    note_end();
    answer.samples = std::move(sampled.factors);
    return std::move(sampled.best);
  };
  const auto model = search.model();
  std::optional<ZeroOneStart> start;
  if (parameters.of_the_paper()) start = sample();
  find_worst_cases(search, parameters, truss, std::move(start), findings);
  if (!search.is_set_up()) search.set_up(model);  // the units of the last attempt were not suitable
  if (!parameters.of_the_paper()) sample();
  const bool known = answer.worst->collapse || answer.worst->status == RootStatus::not_carried;
  if (parameters.curve && known) {
    if (!search.ended()) {
      const Eigen::VectorXd load = dead_load(problem, answer.worst->zeta) - problem.dead;
      answer.curve = factor_curve(search, load, parameters.curve_to);
      answer.worst_curve =
          worst_factor_curve(search, truss, *parameters.alpha, parameters.curve_to);
    }
    note_end();
  }
  return findings;
}

// Limit loads with all struts at their residual strength.
LimitFindings loads_after_buckling(engine::Analysis& analysis, const problems::Structure& structure,
                                   problems::LimitProblem problem,
                                   const LimitParameters& parameters) {
  const auto buckled = problems::after_buckling(structure);
  problem.members = buckled.members;
  for (int i = 0; i < problem.member_count(); ++i)
    problem.compression(i) = problem.members[static_cast<std::size_t>(i)].yield->compression;
  return loads_at_strength(analysis, buckled, problem,
                           {.alpha = parameters.alpha,
                            .split_from = parameters.split_from,
                            .corners = parameters.corners,
                            .loss = parameters.loss});
}

}  // namespace

LimitFindings limit_loads(engine::Analysis& analysis, const problems::Structure& structure,
                          const problems::LimitProblem& problem,
                          const LimitParameters& parameters) {
  auto findings = loads_at_strength(analysis, structure, problem, parameters);
  const bool collapses = findings.answer.status == LoadStatus::collapses;
  if (!problems::has_struts(structure) || !collapses) return findings;
  analysis.say("limit loads with all struts at their residual strength");
  auto residual = loads_after_buckling(analysis, structure, problem, parameters);
  findings.residual = std::move(residual.answer);
  findings.residual_loss = std::move(residual.loss);
  if (auto& loss = findings.residual_loss; loss && loss->theorem) loss->theorem->residual = true;
  if (findings.theorems.empty()) return findings;  // claims at strength come first
  for (auto& theorem : residual.theorems) {
    theorem.residual = true;
    findings.theorems.push_back(std::move(theorem));
  }
  return findings;
}

engine::Status LimitFindings::ended() const {
  if (residual && residual->ended() != engine::Status::solved) return residual->ended();
  for (const auto* const each : {&loss, &residual_loss}) {
    if (*each && (*each)->search != engine::Status::solved) return (*each)->search;
  }
  return answer.ended();
}

bool LimitFindings::whole() const {
  return answer.whole() && (!residual || residual->whole()) && (!loss || loss->proved()) &&
         (!residual_loss || residual_loss->proved());
}

engine::Status LimitAnswer::ended() const {
  for (const auto* const each : {&worst, &reversed}) {
    if (*each && (*each)->search != engine::Status::solved) return (*each)->search;
  }
  return rest;
}

bool LimitAnswer::whole() const {
  if (status == LoadStatus::undetermined || ended() != engine::Status::solved) return false;
  if (status == LoadStatus::not_carried) return true;
  const auto known = [](const std::optional<LoadCurve>& each) {
    return !each || !each->pieces.empty();
  };
  if (!known(curve) || !known(load_curve) || (worst_curve && !worst_curve->proved())) return false;
  if (!worst) return nominal_factors.proved() && is_proved(nominal_interval(*this, {}).standing());
  const auto interval = guaranteed_interval(*this);
  return worst->proved() && (!reversed || reversed->proved() || interval.is_empty()) &&
         is_proved(interval.standing());
}

}  // namespace kusabi::limit
