// Proofs with the smallest sufficient margin for rounding errors.
#include "nodes/limit/search/proved_ends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "nodes/limit/root/corner.hpp"
#include "nodes/limit/root/worst_case.hpp"
#include "nodes/limit/search/limit_evidence.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/sign_cover.hpp"

namespace kusabi::limit {
namespace {

/// Scaled forces; the first has been tried, but not for all members.
constexpr double margins[] = {first_room, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5};

double infinite() {
  return std::numeric_limits<double>::infinity();
}

// The proved lower bound for all loads of a node; minus infinity: none.
double lower_end(const verify::LimitProof& proof, const verify::LimitNode& node) {
  const auto found = proof.lower(node);
  const auto* value = std::get_if<mpq_class>(&found);
  return value == nullptr ? -infinite() : verify::rounded_down(*value);
}

verify::TrussTheorem theorem_for(const LimitEvidence& evidence,
                                 const std::vector<ClosedNode>& nodes) {
  return theorem_of(evidence.problem, evidence.model, evidence.alpha, evidence.worst, evidence.cuts,
                    nodes);
}

/// A way to compute a proof.
struct Attempt {
  bool by_state = false;  ///< of a corner; otherwise by the relaxation
  double room = 0;
  bool for_all = false;
};

// Smallest margins first, all of one program before the next.
std::vector<Attempt> attempts(bool is_corner) {
  std::vector<Attempt> all;
  for (const bool by_state : {true, false}) {
    if (by_state && !is_corner) continue;
    for (const double room : margins) {
      for (const bool for_all : {false, true}) all.push_back({by_state, room, for_all});
    }
  }
  return all;
}

/// The proofs of a node with cuts of its own.
struct WithOwnCuts {
  verify::TrussTheorem theorem;
  verify::LimitProof proof;

  WithOwnCuts(const LimitEvidence& evidence, const verify::LimitTruss& truss,
              const std::vector<StaticCut>& cuts)
      : theorem(
            theorem_of(evidence.problem, evidence.model, evidence.alpha, evidence.worst, cuts, {})),
        proof(truss, theorem.cuts) {}
};

// Replaces the proof of a node by one with a larger margin, if its bound is better.
// @param shared proofs of nodes with the common cuts only
// @param had_proof whether its forces are a proof that was tried
// @return the proved bound
double with_more_room(const LimitEvidence& evidence, const verify::LimitTruss& truss,
                      const verify::LimitProof& shared, ClosedNode& node, bool had_proof,
                      double shown, double wanted) {
  auto cuts = evidence.cuts;
  cuts.insert(cuts.end(), node.own_cuts.begin(), node.own_cuts.end());
  // All data except the node are the same for all margins.
  std::optional<WithOwnCuts> own;
  if (!node.own_cuts.empty()) own.emplace(evidence, truss, cuts);
  const auto& proof = own ? own->proof : shared;
  const double alpha = evidence.alpha / evidence.model.force_unit;
  splitting::SafeStates states(evidence.model);
  if (!evidence.nominal_basis.empty()) states.start_from(evidence.nominal_basis);
  const auto state = [&](double room, bool for_all) {
    return proof_of_corner(states, evidence.model, alpha, cuts, node.signs, room, for_all);
  };
  auto tried = had_proof ? node.forces : std::vector<double>();
  const bool is_corner = first_undecided(evidence.model, alpha, node.signs) < 0;
  for (const auto [by_state, room, for_all] : attempts(is_corner)) {
    const auto found =
        by_state ? state(room, for_all)
                 : proof_with_room(evidence.model, alpha, cuts, node.signs, room, for_all);
    if (!found) continue;
    auto candidate = closed_node(*found, node.own_cuts);
    if (by_state && candidate.forces == tried) continue;  // no further member has room
    tried = candidate.forces;
    const double lower = lower_end(
        proof, limit_node(evidence.problem, evidence.model, evidence.alpha, cuts, candidate));
    if (lower <= shown) continue;
    shown = lower;
    node = std::move(candidate);
    if (shown >= wanted) return shown;
  }
  return shown;
}

}  // namespace

ProvedEnds proved_ends(LimitEvidence evidence, bool again) {
  auto& nodes = evidence.nodes;
  // A node closed without proof has no forces; its signs are enough to compute some.
  std::vector<bool> has_proof;
  for (auto& node : nodes) {
    has_proof.push_back(!node.forces.empty());
    node.forces.resize(static_cast<std::size_t>(evidence.model.member_count()));
  }
  ProvedEnds result;
  auto& [ends, theorem] = result;
  auto loaded = with_loads(evidence.truss, evidence.problem, evidence.alpha);
  const auto meant = loaded ? verify::limit_truss(*loaded) : std::nullopt;
  if (!meant) return result;
  const auto& truss = *meant;
  theorem = theorem_for(evidence, nodes);
  bool changed = false;
  {
    const verify::LimitProof proof(truss, theorem.cuts);
    const auto upper = proof.upper(theorem.collapse);
    if (const auto* value = std::get_if<mpq_class>(&upper)) {
      ends.upper = support::Bound{verify::rounded_up(*value), support::Standing::proved};
    }
    double minimum = infinite();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      double shown = has_proof[k] ? lower_end(proof, theorem.nodes[k]) : -infinite();
      const double wanted =
          std::min(ends.at_most(), evidence.lower) - 2 * closed_gap * evidence.model.factor_unit;
      if (again && shown < wanted) {
        const double more =
            with_more_room(evidence, truss, proof, nodes[k], has_proof[k], shown, wanted);
        changed = changed || more > shown;
        shown = more;
      }
      minimum = std::min(minimum, shown);
    }
    if (std::isfinite(minimum) &&
        !verify::flaw_of_sign_cover(theorem.nodes, truss.uncertain.size())) {
      ends.lower = support::Bound{minimum, support::Standing::proved};
    }
  }
  if (changed) theorem = theorem_for(evidence, nodes);
  theorem.truss = *std::move(loaded);
  return result;
}

std::optional<double> proved_upper(const verify::Structure& truss,
                                   const problems::LimitProblem& problem,
                                   const problems::LimitModel& model, double alpha,
                                   const Eigen::VectorXd& zeta, const Eigen::VectorXd& motion) {
  const auto loaded = with_loads(truss, problem, alpha);
  const auto meant = loaded ? verify::limit_truss(*loaded) : std::nullopt;
  if (!meant) return {};
  const auto collapse =
      collapse_of(problem, alpha, {}, zeta, problems::motion_in_units(model, motion));
  const auto upper = verify::LimitProof(*meant).upper(collapse);
  const auto* const value = std::get_if<mpq_class>(&upper);
  if (value == nullptr) return {};
  return verify::rounded_up(*value);
}

std::optional<verify::TrussTheorem> evidence_of_no_factor(const verify::Structure& truss,
                                                          const problems::LimitProblem& problem,
                                                          const problems::LimitModel& model,
                                                          double alpha, const Eigen::VectorXd& zeta,
                                                          const Eigen::VectorXd& motion) {
  if (motion.size() != model.free_count() || !motion.allFinite()) return {};
  auto loaded = with_loads(truss, problem, alpha);
  const auto meant = loaded ? verify::limit_truss(*loaded) : std::nullopt;
  if (!meant) return {};
  verify::TrussTheorem theorem{.truss = *std::move(loaded), .claim = verify::LimitClaim::none};
  theorem.collapse =
      collapse_of(problem, alpha, {}, zeta, problems::motion_in_units(model, motion));
  if (!verify::LimitProof(*meant).shows_no_factor(theorem.collapse)) return {};
  return theorem;
}

}  // namespace kusabi::limit
