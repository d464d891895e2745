// Conversion of certificates of splitting.
#include "nodes/limit/root/fixed_shares.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace kusabi::limit {
namespace {

/// Forces below this share of the largest one of a cut are rounding errors; a member without
/// freedom must be exactly zero.
constexpr double rounding = 1e-13;

}  // namespace

std::vector<StaticCut> cuts_of_point(const splitting::ColumnBlocks& point,
                                     const splitting::Sharing& sharing,
                                     const problems::LimitModel& model, double alpha) {
  const auto all = splitting::all_columns(point, sharing);
  const auto rows = static_cast<std::size_t>(point.rows());
  std::vector<StaticCut> cuts;
  for (std::size_t j = 0; j < model.uncertain.size(); ++j) {
    const auto column = std::span(all).subspan(rows * (j + 1), rows);
    const double unit = alpha * model.uncertain[j].reach();
    double largest = 0;
    for (std::size_t i = 0; i + 1 < rows; ++i) largest = std::max(largest, std::abs(column[i]));
    auto& cut = cuts.emplace_back();
    cut.column = static_cast<int>(j);
    if (unit == 0) continue;  // its share is zero, whatever its forces
    cut.factor = column[rows - 1] / unit;
    for (std::size_t i = 0; i + 1 < rows; ++i) {
      if (std::abs(column[i]) <= rounding * largest) continue;
      cut.forces.emplace_back(static_cast<int>(i), column[i] / unit);
    }
  }
  return cuts;
}

bool is_one_for_each(std::span<const StaticCut> cuts, const problems::LimitModel& model) {
  if (cuts.size() != model.uncertain.size()) return false;
  for (std::size_t j = 0; j < cuts.size(); ++j) {
    if (cuts[j].column != static_cast<int>(j)) return false;
  }
  return true;
}

std::optional<StaticProof> proof_of_fixed_shares(splitting::SafeStates& states,
                                                 const problems::LimitModel& model, double alpha,
                                                 std::span<const StaticCut> cuts, double room,
                                                 bool for_all) {
  const int members = model.member_count();
  std::vector<double> taken(static_cast<std::size_t>(members) + 1, 0.0);
  StaticProof proof;
  for (const auto& cut : cuts) {
    const double share = alpha * model.uncertain[static_cast<std::size_t>(cut.column)].reach();
    proof.mu.push_back(share);
    for (const auto& [member, force] : cut.forces) {
      taken[static_cast<std::size_t>(member)] += share * std::abs(force);
    }
    taken.back() += share * std::abs(cut.factor);
  }
  const Eigen::VectorXd yield = model.yield();
  Eigen::VectorXd of_member(members);  // at most half of the yield force
  for (int i = 0; i < members; ++i) {
    const double left = yield(i) - taken[static_cast<std::size_t>(i)];
    of_member(i) = std::clamp(left / 2, 0.0, room);
  }
  auto state = states.state(taken, of_member);
  while (!state && !for_all) {
    bool any = false;
    for (const int member : states.members_in_the_way()) {
      any = any || of_member(member) != 0;
      of_member(member) = 0;
    }
    if (!any) break;
    state = states.state(taken, of_member);
  }
  if (!state) return {};
  proof.signs.assign(model.uncertain.size(), 0);
  proof.factor = state->factor;
  proof.forces = std::move(state->forces);
  proof.one_sided = Eigen::VectorXd::Zero(model.uncertain_count());
  return proof;
}

}  // namespace kusabi::limit
