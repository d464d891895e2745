// Upper bound, cover, and one piece of the cover at a time.
#include "verify/limit/truss_proof.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "support/index_set.hpp"
#include "verify/limit/loss_cover.hpp"
#include "verify/limit/sign_cover.hpp"
#include "verify/limit/stress_state.hpp"
#include "verify/limit/truss_consistency.hpp"

namespace kusabi::verify {
namespace {

support::IndexSet set_of(const std::vector<std::size_t>& members) {
  support::IndexSet set;
  for (const auto member : members) set.insert(static_cast<int>(member));
  return set;
}

// The reason why some loss has a member of every state; nothing: none has.
std::optional<std::string> flaw_of_losses(const TrussTheorem& theorem, const LimitTruss& truss) {
  std::vector<support::IndexSet> supports;
  for (const auto& state : theorem.states) supports.push_back(set_of(state.support));
  const LossCover cover(supports, set_of(theorem.kept), static_cast<int>(theorem.losses));
  if (!cover.flaw()) return {};
  std::string why = "no state is left after the loss of";
  for (const int member : *cover.flaw()) why += ' ' + truss.names[static_cast<std::size_t>(member)];
  return why;
}

}  // namespace

TrussProof::TrussProof(const TrussTheorem& theorem) : theorem_(theorem) {
  const auto truss = truss_of(theorem);
  truss_ = limit_truss(truss, theorem.sudden);
  if (truss_) proof_.emplace(*truss_, theorem.cuts);
  if (theorem.losses > 0) exact_ = exact_truss(truss, theorem.sudden);
}

std::vector<std::string> TrussProof::refusals(double& upper) const {
  upper = -std::numeric_limits<double>::infinity();
  if (!proof_) return {"the direction of a member is undefined"};
  if (theorem_.claim == LimitClaim::none) {
    if (proof_->shows_no_factor(theorem_.collapse)) return {};
    return {"the motion does not show that the load is not carried at any factor"};
  }
  std::vector<std::string> refusals;
  const auto found = proof_->upper(theorem_.collapse);
  if (const auto* const why = std::get_if<std::string>(&found)) {
    refusals.push_back("upper bound: " + *why);
  } else {
    upper = rounded_up(std::get<mpq_class>(found));
    if (std::isinf(upper))
      refusals.emplace_back("the upper bound exceeds the range of double precision");
  }
  const bool of_losses = theorem_.losses > 0;
  if (pieces() == 0 && (of_losses || theorem_.claim == LimitClaim::minimum)) return refusals;
  const auto flaw = of_losses ? flaw_of_losses(theorem_, *truss_)
                              : flaw_of_sign_cover(theorem_.nodes, truss_->uncertain.size());
  if (flaw) refusals.push_back(*flaw);
  return refusals;
}

// States by enclosures, and exactly only if these do not prove them: a state may exist only because
// loads balance exactly.
std::variant<double, std::string> TrussProof::lower(std::size_t piece) const {
  if (!proof_) return "the direction of a member is undefined";
  if (theorem_.losses == 0) {
    const auto& node = theorem_.nodes[piece];
    const auto found = proof_->lower(node);
    if (const auto* const value = std::get_if<mpq_class>(&found)) return rounded_down(*value);
    return "the node of line " + std::to_string(node.line) + ": " + std::get<std::string>(found);
  }
  const auto& state = theorem_.states[piece];
  const auto name = "state " + std::to_string(piece + 1) + ": ";
  const auto enclosed = proof_->carried(state);
  if (const auto* const factor = std::get_if<mpq_class>(&enclosed);
      factor != nullptr && *factor >= theorem_.lower)
    return theorem_.lower;
  const auto carried = carried_factor(exact_, state);
  if (!carried)
    return name + "the forces of the state are not in equilibrium within the yield forces";
  if (carried->factor < theorem_.lower)
    return name + "the state carries less than the claimed factor";
  return theorem_.lower;
}

}  // namespace kusabi::verify
