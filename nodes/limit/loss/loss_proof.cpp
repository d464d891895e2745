// One certificate, whose yield forces, load and motion are replaced from proof to proof.
#include "nodes/limit/loss/loss_proof.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "nodes/limit/search/limit_evidence.hpp"

namespace kusabi::limit {
namespace {

using support::IndexSet;

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
                     const problems::LimitModel& model, double alpha)
    : problem_(problem),
      exact_(verify::exact_truss(truss)),
      certificate_(limit_certificate(problem, model, alpha,
                                     {Eigen::VectorXd::Zero(model.uncertain_count()),
                                      {0, {}, Eigen::VectorXd::Zero(model.free_count())}},
                                     {}, {})) {
  if (alpha > 0) verify::add_uncertain(certificate_.uncertain, certificate_.alpha, exact_);
  if (auto meant = meant_truss(certificate_, truss))
    proof_.emplace(certificate_, *std::move(meant));
}

std::optional<ProvedState> LossProof::proved(verify::StressState state, double target,
                                             const IndexSet& lost) const {
  const auto reached = [&] {
    auto found = verify::carried_factor(exact_, state);
    return found && found->factor >= target ? std::move(found) : std::nullopt;
  };
  const auto with_support = [&] {
    auto support = set_of(state.support);
    return ProvedState{std::move(support), std::move(state)};
  };
  // The simplex method leaves forces within its tolerance to lost members.
  auto support = state.support;
  std::erase_if(support,
                [&](std::size_t member) { return lost.contains(static_cast<int>(member)); });
  state = within(std::move(state), support);
  if (reached()) return with_support();
  // Further members carry the rounding errors of coordinates, loads and forces.
  state.support.clear();
  for (const int i : IndexSet::below(problem_.member_count()) - lost)
    state.support.push_back(static_cast<std::size_t>(i));
  const auto all = reached();
  if (!all) return {};
  auto smaller = within(state, all->members);
  if (const auto found = verify::carried_factor(exact_, smaller); found && found->factor >= target)
    state = std::move(smaller);
  return with_support();
}

bool LossProof::set(const IndexSet& lost, const Eigen::VectorXd& zeta,
                    const Eigen::VectorXd& motion) {
  if (!proof_ || motion.size() != problem_.free_count() || !motion.allFinite()) return false;
  certificate_.tension.assign(problem_.tension.begin(), problem_.tension.end());
  certificate_.compression.assign(problem_.compression.begin(), problem_.compression.end());
  for (const int i : lost) {
    certificate_.tension[static_cast<std::size_t>(i)] = 0;
    certificate_.compression[static_cast<std::size_t>(i)] = 0;
  }
  for (std::size_t j = 0; j < certificate_.load.size(); ++j) {
    const double share = zeta.size() == 0 ? 0 : zeta(static_cast<Eigen::Index>(j));
    certificate_.load[j] = share == 0 ? 0 : std::copysign(certificate_.alpha[j], share);
  }
  certificate_.motion.assign(motion.begin(), motion.end());
  return true;
}

std::optional<double> LossProof::upper(const IndexSet& lost, const Eigen::VectorXd& zeta,
                                       const Eigen::VectorXd& motion) {
  if (!set(lost, zeta, motion)) return {};
  const auto found = proof_->upper();
  const auto* const value = std::get_if<mpq_class>(&found);
  if (value == nullptr) return {};
  return verify::rounded_up(*value);
}

bool LossProof::shows_no_factor(const IndexSet& lost, const Eigen::VectorXd& zeta,
                                const Eigen::VectorXd& motion) {
  return set(lost, zeta, motion) && proof_->shows_no_factor();
}

void LossProof::write_loads(bool uncertain, verify::LossStatement& statement) const {
  auto& truss = statement.truss;
  auto& columns = truss.uncertain.emplace();
  truss.half_widths.clear();
  truss.load_names.clear();
  if (!uncertain) return;
  for (std::size_t j = 0; j < certificate_.uncertain.size(); ++j) {
    auto& column = columns.emplace_back();
    for (const auto& [e, value] : certificate_.uncertain[j]) {
      const auto& free = problem_.degrees.free[e];
      column.push_back(
          {static_cast<std::size_t>(free.node), static_cast<std::size_t>(free.axis), value});
    }
    truss.half_widths.emplace_back(certificate_.alpha[j]);
    truss.load_names.push_back(certificate_.names[j]);
  }
  statement.load = certificate_.load;
}

}  // namespace kusabi::limit
