// Pricing program: minimise sum_i z_i (y+_i + y-_i) + k+ + k- with B (y+ - y-) - (k+ - k-) f_R =
// d_j. Another j changes the right-hand side only, which suits the dual simplex method.
#include "nodes/limit/model/static_cut.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

namespace kusabi::limit {
namespace {

linear::LinearProgram pricing_program(const problems::LimitModel& model) {
  linear::LinearProgram program;
  program.name = "static cut";
  for (int k = 0; k < model.free_count(); ++k) program.add_row({.lower = 0, .upper = 0}, {});
  for (const double sign : {1.0, -1.0}) {
    for (int i = 0; i < model.member_count(); ++i) {
      const int column = program.add_column({.cost = 1});
      for (Eigen::SparseMatrix<double>::InnerIterator entry(model.equilibrium, i); entry; ++entry) {
        program.entries.push_back({static_cast<int>(entry.row()), column, sign * entry.value()});
      }
    }
    const int factor = program.add_column({.cost = 1});
    for (int k = 0; k < model.free_count(); ++k) {
      if (model.reference(k) != 0) {
        program.entries.push_back({k, factor, -sign * model.reference(k)});
      }
    }
  }
  return program;
}

}  // namespace

double StaticCut::bound(const Eigen::VectorXd& z) const {
  double total = std::abs(factor);
  for (const auto& [member, force] : forces) total += std::abs(force) * z(member);
  return total;
}

StaticPricing::StaticPricing(const problems::LimitModel& model, support::Stop stop)
    : model_(model), stop_(std::move(stop)), simplex_(pricing_program(model)) {}

void StaticPricing::set_point(const Eigen::VectorXd& z, int first) {
  const int members = model_.member_count();
  for (int i = 0; i < members; ++i) {
    simplex_.set_cost(i, z(i));
    simplex_.set_cost(members + 1 + i, z(i));
  }
  simplex_.use_slack_basis();
  start_.reset();
  if (cut(first)) start_ = simplex_.basis();
}

void StaticPricing::restart() {
  if (start_) {
    simplex_.set_basis(*start_);
  } else {
    simplex_.use_slack_basis();
  }
}

void StaticPricing::aim_at(int column) {
  if (last_column_ >= 0) {
    for (const auto& [degree, value] : direction(last_column_)) {
      simplex_.set_row_bounds(degree, 0, 0);
    }
  }
  for (const auto& [degree, value] : direction(column)) {
    simplex_.set_row_bounds(degree, value, value);
  }
  last_column_ = column;
}

std::optional<StaticCut> StaticPricing::cut(int column) {
  aim_at(column);
  const auto* const optimum = std::get_if<linear::CheckedOptimum>(&simplex_.solve(stop_));
  if (optimum == nullptr) return std::nullopt;
  StaticCut cut;
  cut.column = column;
  const int members = model_.member_count();
  const auto force = [&](int i) { return optimum->value(i) - optimum->value(members + 1 + i); };
  double largest = 0;
  for (int i = 0; i < members; ++i) largest = std::max(largest, std::abs(force(i)));
  // Smaller forces are rounding errors; a member without freedom must be exactly zero.
  constexpr double rounding = 1e-13;
  for (int i = 0; i < members; ++i) {
    if (std::abs(force(i)) > rounding * largest) cut.forces.emplace_back(i, force(i));
  }
  cut.factor = optimum->value(members) - optimum->value(2 * members + 1);
  return cut;
}

}  // namespace kusabi::limit
