// One program (5) for each end, and one with the margin of a proof.
#include "nodes/limit/search/nominal_proof.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "engine/collectives.hpp"
#include "nodes/limit/model/balanced_model.hpp"
#include "nodes/limit/root/fixed_shares.hpp"
#include "nodes/limit/search/limit_evidence.hpp"
#include "nodes/limit/search/proved_ends.hpp"
#include "verify/limit/limit_proof.hpp"

namespace kusabi::limit {
namespace {

/// A collapse under the nominal load, and the basis at which the simplex method found it.
struct WithBasis {
  Collapse collapse;
  linear::Basis basis;
};

FactorBracket proved_part(const LimitEnds& ends) {
  FactorBracket bracket;
  if (ends.lower_proved) bracket.lower = ends.lower;
  if (ends.upper_proved) bracket.upper = ends.upper;
  bracket.lower_proved = ends.lower_proved;
  bracket.upper_proved = ends.upper_proved;
  return bracket;
}

// Without a dead load factor zero is carried without any force, exactly: no margin is needed.
void prove_zero(const verify::Structure& truss, ProvedEnds& proved) {
  auto& [ends, certificate] = proved;
  if (ends.lower_proved && ends.lower >= 0) return;
  const auto is_zero = [](double load) { return load == 0; };
  if (!std::ranges::all_of(certificate.dead, is_zero)) return;
  verify::LimitNode unstressed;
  unstressed.signs.resize(certificate.uncertain.size());
  unstressed.forces.resize(certificate.members());
  unstressed.one_sided.resize(certificate.uncertain.size());
  auto meant = meant_truss(certificate, truss);
  if (!meant) return;
  const auto lower = verify::LimitProof(certificate, *std::move(meant)).lower(unstressed);
  if (!std::holds_alternative<mpq_class>(lower)) return;
  certificate.nodes = {std::move(unstressed)};
  ends.lower = 0;
  ends.lower_proved = true;
}

// Both bounds of the largest factor of `problem`, which may have the opposite reference load.
ProvedEnds proved_largest(const verify::Structure& truss, const problems::LimitProblem& problem,
                          const problems::LimitModel& model, const WithBasis& found) {
  splitting::SafeStates states(model);
  states.start_from(found.basis);
  const auto proof = proof_of_fixed_shares(states, model, 0, {}, first_room, false);
  ClosedNode node;
  node.signs.resize(model.uncertain.size());
  if (proof) node = closed_node(*proof, {});
  const Worst nominal{Eigen::VectorXd::Zero(model.uncertain_count()), found.collapse};
  auto proved = proved_ends({truss, problem, model, 0, nominal, {}, {std::move(node)}}, true);
  prove_zero(truss, proved);
  return proved;
}

// The model with the opposite reference load.
problems::LimitModel mirrored(problems::LimitModel model) {
  model.reference = -model.reference;
  return model;
}

std::pair<LimitEnds, LimitEnds> prove_both(RootSearch& search, const verify::Structure& truss,
                                           const WithBasis& largest,
                                           const std::optional<WithBasis>& opposite,
                                           std::vector<verify::LimitStatement>& statements) {
  const auto add = [&](verify::LimitClaim claim, ProvedEnds& proved) {
    const auto& ends = proved.ends;
    const bool whole = ends.lower_proved && ends.upper_proved;
    if (whole && (claim == verify::LimitClaim::largest || !statements.empty()))
      statements.push_back({{}, claim, std::move(proved.certificate)});
  };
  statements.clear();
  auto above = proved_largest(truss, search.problem(), search.model(), largest);
  add(verify::LimitClaim::largest, above);
  ProvedEnds below;
  if (opposite) {
    auto problem = search.problem();
    problem.reference = -problem.reference;
    below = proved_largest(verify::with_reversed_reference(truss), problem,
                           mirrored(search.model()), *opposite);
    add(verify::LimitClaim::minimum, below);
  }
  return {above.ends, below.ends};
}

NominalProof proof_in_model(RootSearch& search, const verify::Structure& truss) {
  auto& load_factor = search.load_factor();
  load_factor.restart();
  const WithBasis largest{search.nominal(), load_factor.basis()};
  std::optional<WithBasis> opposite;
  if (auto collapse = load_factor.opposite_collapse(search.model().dead))
    opposite = WithBasis{*std::move(collapse), load_factor.basis()};
  NominalProof proof;
  const auto [above, below] = engine::from_first_rank(search.analysis().transport(), [&] {
    return prove_both(search, truss, largest, opposite, proof.statements);
  });
  proof.factors.largest = proved_part(above);
  proof.factors.minimum = negative(proved_part(below));
  proof.factors.gap = answered_gap * search.model().factor_unit;
  const auto least = opposite ? std::optional(-opposite->collapse.factor) : std::nullopt;
  proof.collapse = search.in_units(search.nominal(), least);
  return proof;
}

}  // namespace

NominalProof prove_nominal(RootSearch& search, const verify::Structure& truss) {
  const auto model = search.model();
  auto proof = proof_in_model(search, truss);
  while (!proof.factors.proved() && !search.ended()) {
    auto more = with_more_yield(search.problem(), search.model());
    if (!more || search.set_up(*std::move(more)) != LoadStatus::collapses) break;
    proof = proof_in_model(search, truss);
  }
  if (search.model().max_yield != model.max_yield) search.set_up(model);
  return proof;
}

}  // namespace kusabi::limit
