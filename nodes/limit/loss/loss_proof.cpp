// One certificate, whose yield forces, motion and forces are replaced from proof to proof.
#include "nodes/limit/loss/loss_proof.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

#include "nodes/limit/search/limit_evidence.hpp"

namespace kusabi::limit {

using support::IndexSet;

LossProof::LossProof(const verify::Structure& truss, const problems::LimitProblem& problem,
                     const problems::LimitModel& model)
    : problem_(problem),
      model_(model),
      certificate_(limit_certificate(problem, model, 0,
                                     {Eigen::VectorXd::Zero(model.uncertain_count()),
                                      {0, {}, Eigen::VectorXd::Zero(model.free_count())}},
                                     {}, {})) {
  auto meant = meant_truss(certificate_, truss);
  auto& column = certificate_.columns.emplace_back();
  auto& exact = meant.columns.emplace_back();
  for (std::size_t e = 0; e < certificate_.reference.size(); ++e) {
    if (certificate_.reference[e] == 0) continue;
    column.emplace_back(e, certificate_.reference[e]);
    exact.emplace_back(e, meant.reference[e]);
  }
  proof_.emplace(certificate_, std::move(meant));
}

// @param excess of the factor, >= 0
void LossProof::remove(const IndexSet& lost, double excess) {
  certificate_.tension.assign(problem_.tension.begin(), problem_.tension.end());
  certificate_.compression.assign(problem_.compression.begin(), problem_.compression.end());
  for (const int i : lost) {
    certificate_.tension[static_cast<std::size_t>(i)] = 0;
    certificate_.compression[static_cast<std::size_t>(i)] = 0;
  }
  certificate_.tension.push_back(excess);
  certificate_.compression.push_back(excess);
}

void LossProof::set_motion(const Eigen::VectorXd& motion) {
  const auto in_units = problems::motion_in_units(model_, motion);
  certificate_.motion.assign(in_units.begin(), in_units.end());
}

bool LossProof::carries(const IndexSet& present, double target, double factor,
                        const Eigen::VectorXd& forces) {
  // Half of the excess: the difference of two doubles may be rounded up.
  remove(IndexSet::below(model_.member_count()) - present, std::max(0.0, (factor - target) / 2));
  const auto in_units = problems::forces_in_units(model_, forces);
  verify::LimitNode node;
  node.signs.resize(certificate_.uncertain.size());
  node.one_sided.resize(certificate_.uncertain.size());
  node.factor = std::max(target, factor);
  node.forces.assign(in_units.begin(), in_units.end());
  node.forces.push_back(0);
  return std::holds_alternative<mpq_class>(proof_->lower(node));
}

std::optional<double> LossProof::upper(const IndexSet& lost, const Eigen::VectorXd& motion) {
  if (motion.size() != model_.free_count() || !motion.allFinite()) return {};
  remove(lost, 0);
  set_motion(motion);
  const auto found = proof_->upper();
  const auto* const value = std::get_if<mpq_class>(&found);
  if (value == nullptr) return {};
  return verify::rounded_up(*value);
}

bool LossProof::shows_no_factor(const IndexSet& lost, const Eigen::VectorXd& motion) {
  if (motion.size() != model_.free_count() || !motion.allFinite()) return false;
  remove(lost, 0);
  set_motion(motion);
  return proof_->shows_no_factor();
}

}  // namespace kusabi::limit
