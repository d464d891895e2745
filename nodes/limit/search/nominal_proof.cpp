// One program (5) for each end, and one with the margin of a proof.
#include "nodes/limit/search/nominal_proof.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "engine/collectives.hpp"
#include "nodes/limit/model/balanced_model.hpp"
#include "nodes/limit/root/fixed_shares.hpp"
#include "nodes/limit/search/limit_evidence.hpp"
#include "nodes/limit/search/proved_ends.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/truss_consistency.hpp"

namespace kusabi::limit {
namespace {

/// A collapse under the nominal load, and the basis at which the simplex method found it.
struct WithBasis {
  Collapse collapse;
  linear::Basis basis;
};

/// The best proved bounds of an end of the carried factors by all models so far.
struct Known {
  support::Bracket bracket;
  /// Width of the narrowest bracket by one model, and its evidence; infinity: there is none.
  double width = linear::infinity;
  verify::TrussTheorem theorem;

  void add(ProvedEnds&& found);
};

// A later model may prove less than an earlier one.
void Known::add(ProvedEnds&& found) {
  const auto& ends = found.ends;
  if (ends.lower && !(bracket.at_least() >= ends.lower->value)) bracket.lower = ends.lower;
  if (ends.upper && !(bracket.at_most() <= ends.upper->value)) bracket.upper = ends.upper;
  if (!(ends.width() < width)) return;
  width = ends.width();
  theorem = std::move(found.theorem);
}

// Without a dead load factor zero is carried without any force, exactly: no margin is needed.
void prove_zero(ProvedEnds& proved) {
  auto& [ends, theorem] = proved;
  if (ends.at_least() >= 0 || !theorem.truss.uncertain) return;
  const auto truss = verify::limit_truss(theorem.truss);
  const auto is_zero = [](const verify::Dyadic& load) { return load.sign() == 0; };
  if (!truss || !std::ranges::all_of(truss->dead, is_zero)) return;
  verify::LimitNode unstressed;
  unstressed.signs.resize(truss->uncertain.size());
  unstressed.forces.resize(truss->members());
  unstressed.one_sided.resize(truss->uncertain.size());
  const auto lower = verify::LimitProof(*truss).lower(unstressed);
  if (!std::holds_alternative<mpq_class>(lower)) return;
  theorem.nodes = {std::move(unstressed)};
  ends.lower = support::Bound{0, support::Standing::proved};
}

// Both bounds of the largest factor of `problem`, which may have the opposite reference load.
// @param again as of proved_ends
ProvedEnds proved_largest(const verify::Structure& truss, const problems::LimitProblem& problem,
                          const problems::LimitModel& model, const WithBasis& found, bool again) {
  splitting::SafeStates states(model);
  states.start_from(found.basis);
  const auto proof = proof_of_fixed_shares(states, model, 0, {}, first_room, false);
  ClosedNode node;
  node.signs.resize(model.uncertain.size());
  if (proof) node = closed_node(*proof, {});
  const Worst nominal{Eigen::VectorXd::Zero(model.uncertain_count()), found.collapse};
  auto proved =
      proved_ends({truss, problem, model, 0, nominal, {}, {std::move(node)}, found.basis}, again);
  prove_zero(proved);
  return proved;
}

// A factor of the simplex method without its rounding error beyond the proved bounds.
double within(const support::Bracket& proved, double factor) {
  return std::min(std::max(factor, proved.at_least()), proved.at_most());
}

// The model with the opposite reference load.
problems::LimitModel mirrored(problems::LimitModel model) {
  model.reference = -model.reference;
  return model;
}

/// Both ends: the largest factor, and minus the least one, with the opposite reference load. Filled
/// on rank 0.
struct BothEnds {
  Known largest;
  Known opposite;
};

NominalProof proof_in_model(RootSearch& search, const verify::Structure& truss, BothEnds& known) {
  auto& load_factor = search.load_factor();
  load_factor.restart();
  const WithBasis largest{search.nominal(), load_factor.basis()};
  std::optional<WithBasis> opposite;
  if (auto collapse = load_factor.opposite_collapse(search.model().dead))
    opposite = WithBasis{*std::move(collapse), load_factor.basis()};
  const bool again = !search.ended();
  NominalProof proof;
  const auto [above, below] = engine::from_first_rank(search.analysis().transport(), [&] {
    known.largest.add(proved_largest(truss, search.problem(), search.model(), largest, again));
    if (opposite) {
      auto problem = search.problem();
      problem.reference = -problem.reference;
      known.opposite.add(proved_largest(verify::with_reversed_reference(truss), problem,
                                        mirrored(search.model()), *opposite, again));
    }
    return std::pair(known.largest.bracket, known.opposite.bracket);
  });
  proof.factors.largest = above;
  proof.factors.minimum = below.negative();
  proof.factors.gap = answered_gap * search.model().factor_unit;
  const auto least = opposite ? std::optional(-opposite->collapse.factor) : std::nullopt;
  proof.collapse = search.in_units(search.nominal(), least);
  auto& [factor, minimum, forces, motion] = proof.collapse;
  factor = within(proof.factors.largest, factor);
  if (minimum) minimum = within(proof.factors.minimum, *minimum);
  return proof;
}

std::vector<verify::TrussTheorem> theorems(BothEnds known) {
  std::vector<verify::TrussTheorem> all;
  for (auto* const end : {&known.largest, &known.opposite}) {
    if (!std::isfinite(end->width)) break;
    all.push_back(std::move(end->theorem));
  }
  if (all.size() == 2) of_least_factors(all.back());
  return all;
}

}  // namespace

NominalProof prove_nominal(RootSearch& search, const verify::Structure& truss) {
  const auto model = search.model();
  BothEnds known;
  auto proof = proof_in_model(search, truss, known);
  while (!proof.factors.proved() && !search.ended()) {
    auto more = with_more_yield(search.problem(), search.model());
    if (!more || search.set_up(*std::move(more)) != LoadStatus::collapses) break;
    proof = proof_in_model(search, truss, known);
  }
  proof.theorems = theorems(std::move(known));
  if (search.model().max_yield != model.max_yield) search.set_up(model);
  return proof;
}

}  // namespace kusabi::limit
