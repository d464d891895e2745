// A corner is a known load without cuts.
#include "nodes/limit/root/corner.hpp"

#include <cstddef>

#include "nodes/limit/root/fixed_shares.hpp"

namespace kusabi::limit {
namespace {

bool is_undecided(const problems::LimitModel& model, double alpha, const Signs& signs,
                  std::size_t j) {
  return signs[j] == 0 && alpha * model.uncertain[j].weight > 0;
}

}  // namespace

int first_undecided(const problems::LimitModel& model, double alpha, const Signs& signs) {
  for (std::size_t j = 0; j < signs.size(); ++j) {
    if (is_undecided(model, alpha, signs, j)) return static_cast<int>(j);
  }
  return -1;
}

int undecided_count(const problems::LimitModel& model, double alpha, const Signs& signs) {
  int count = 0;
  for (std::size_t j = 0; j < signs.size(); ++j) {
    if (is_undecided(model, alpha, signs, j)) ++count;
  }
  return count;
}

Eigen::VectorXd corner_load(double alpha, const Signs& signs) {
  Eigen::VectorXd zeta(static_cast<Eigen::Index>(signs.size()));
  for (std::size_t j = 0; j < signs.size(); ++j) {
    zeta(static_cast<Eigen::Index>(j)) = alpha * signs[j];
  }
  return zeta;
}

std::optional<StaticProof> proof_of_corner(splitting::SafeStates& states,
                                           const problems::LimitModel& model, double alpha,
                                           std::span<const StaticCut> cuts, const Signs& signs,
                                           double room, bool for_all) {
  states.set_load(dead_load(model, corner_load(alpha, signs)));
  auto proof = proof_of_fixed_shares(states, model, 0, {}, room, for_all);
  if (!proof) return {};
  proof->signs = signs;
  proof->mu.assign(cuts.size(), 0.0);
  return proof;
}

}  // namespace kusabi::limit
