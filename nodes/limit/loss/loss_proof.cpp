// One truss for all proofs, with strengths divided by the dynamic factor and rounded to the safe side.
#include "nodes/limit/loss/loss_proof.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>

#include "nodes/limit/search/limit_evidence.hpp"

namespace kusabi::limit {
namespace {

using support::IndexSet;

/// Limit of an elimination by the members with stress, which precedes enclosures by more members:
/// states of few members need fewer others. It takes about as long as an enclosure.
constexpr std::uint64_t few_products = 1'000'000;

/// Limit of an elimination by all members, some seconds. It suffices for trusses of 200 members
/// that are mechanisms, but not for one of 600 that is singular but for the rounding of coordinates.
constexpr std::uint64_t many_products = 1'000'000'000;

IndexSet set_of(const std::vector<std::size_t>& members) {
  IndexSet set;
  for (const auto member : members) set.insert(static_cast<int>(member));
  return set;
}

// The state without members outside `support`, and without their forces.
verify::StressState within(verify::StressState state, const std::vector<std::size_t>& support) {
  state.support = support;
  for (auto& column : state.columns) {
    std::erase_if(column.forces, [&](const auto& force) {
      return !std::ranges::binary_search(support, force.first);
    });
  }
  return state;
}

}  // namespace

LossProof::LossProof(const verify::Structure& truss, const problems::LimitProblem& problem,
                     double alpha, double sudden)
    : problem_(problem), alpha_(alpha), loaded_(with_loads(truss, problem, alpha)) {
  if (!loaded_) return;
  if (alpha == 0) {
    loaded_->uncertain->clear();
    loaded_->half_widths.clear();
    loaded_->load_names.clear();
  }
  exact_ = verify::exact_truss(*loaded_, sudden);
  truss_ = verify::limit_truss(*loaded_, sudden);
  if (truss_) proof_.emplace(*truss_);
}

// Members with stress may be too few for a proof by enclosures: where coordinates are rounded, they
// carry forces of 1e-16 only together with others. Those of the basis complete them. If the truss
// without the lost members is a mechanism, exact arithmetic alone can show that loads balance on it.
std::optional<ProvedState> LossProof::proved(verify::StressState state, const IndexSet& basic,
                                             double target, const IndexSet& lost, bool last,
                                             const support::Stop& stop) const {
  if (!loaded_) return {};
  // The simplex method leaves forces within its tolerance to lost members.
  const auto with_stress = set_of(state.support) - lost;
  const auto all = IndexSet::below(problem_.member_count()) - lost;
  const auto use = [&](const IndexSet& support) {
    state = within(std::move(state), {support.begin(), support.end()});
  };
  const auto by_enclosures = [&](const IndexSet& support) {
    use(support);
    if (!proof_ || support::is_requested(stop)) return false;
    const auto carried = proof_->carried(state);
    const auto* const factor = std::get_if<mpq_class>(&carried);
    return factor != nullptr && *factor >= target;
  };
  const auto exactly = [&](const IndexSet& support, std::uint64_t products) {
    use(support);
    auto found = verify::carried_factor(exact_, state, {stop, products});
    return found && found->factor >= target ? std::move(found) : std::nullopt;
  };
  // The members with forces then, of all that are admitted.
  const auto exactly_by_some = [&](const IndexSet& admitted, std::uint64_t products) {
    const auto found = exactly(admitted, products);
    if (!found) return false;
    const auto complete = state;
    if (!exactly(set_of(found->members), products)) state = complete;
    return true;
  };
  const auto completed = with_stress | (basic - lost);
  const bool shown = by_enclosures(with_stress) || exactly(with_stress, few_products) ||
                     exactly_by_some(completed, few_products) || by_enclosures(completed) ||
                     by_enclosures(all) || (last && exactly_by_some(all, many_products));
  if (!shown) return {};
  auto support = set_of(state.support);
  return ProvedState{std::move(support), std::move(state)};
}

std::optional<verify::CollapseMotion> LossProof::collapse(const IndexSet& lost,
                                                          const Eigen::VectorXd& zeta,
                                                          const Eigen::VectorXd& motion) const {
  if (!proof_ || motion.size() != problem_.free_count() || !motion.allFinite()) return {};
  const Eigen::VectorXd load = alpha_ == 0 ? Eigen::VectorXd() : zeta;
  return collapse_of(problem_, alpha_, {lost.begin(), lost.end()}, load, motion);
}

std::optional<double> LossProof::upper(const IndexSet& lost, const Eigen::VectorXd& zeta,
                                       const Eigen::VectorXd& motion) const {
  const auto recorded = collapse(lost, zeta, motion);
  if (!recorded) return {};
  const auto found = proof_->upper(*recorded);
  const auto* const value = std::get_if<mpq_class>(&found);
  if (value == nullptr) return {};
  return verify::rounded_up(*value);
}

bool LossProof::shows_no_factor(const IndexSet& lost, const Eigen::VectorXd& zeta,
                                const Eigen::VectorXd& motion) const {
  const auto recorded = collapse(lost, zeta, motion);
  return recorded && proof_->shows_no_factor(*recorded);
}

}  // namespace kusabi::limit
