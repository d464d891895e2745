// Linear programs that ask for the ends of a form, and the rows that profit.
#include "nodes/zero_one/bound_tightening.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "solvers/linear/precise_bound.hpp"
#include "solvers/linear/precise_simplex.hpp"
#include "solvers/linear/safe_bound.hpp"

namespace kusabi::zero_one {
namespace {

using linear::infinity;
using linear::LinearStatus;
using linear::LinearTerm;

// An end whose proof in doubles is this near to it, relative to its size (at least one), is left at
// that.
constexpr double margin = 1e-6;

constexpr std::uint64_t most_rounds = 20;
// A round pays for the next if it took at least this share of all the Ms.
constexpr double worth_a_round = 0.01;
// No M becomes smaller than this share of itself or of its row's bound: one that is nothing but
// rounding has no scale.
constexpr double least_share = 1e-6;
// An M that shrinks by less than this share of itself is left as it is.
constexpr double worth_a_change = 1e-3;

linear::LinearProgram with_objective_row(const linear::LinearProgram& given, double cutoff) {
  auto program = given;
  std::vector<LinearTerm> objective;
  for (std::size_t j = 0; j < program.columns.size(); ++j) {
    objective.push_back({static_cast<int>(j), program.columns[j].cost});
    program.columns[j].cost = 0;
  }
  program.constant = 0;
  const double most = linear::rounded::sum_up(cutoff, -given.constant);
  program.add_row({.upper = most}, objective);
  return program;
}

}  // namespace

BoundTightening::BoundTightening(const linear::LinearProgram& program, double cutoff,
                                 support::Stop stop)
    : program_(with_objective_row(program, cutoff)),
      simplex_(program_),
      implied_(implied_bounds(program_)),
      stop_(std::move(stop)) {}

void BoundTightening::set_column_bounds(int column, double lower, double upper) {
  auto& own = program_.columns.at(static_cast<std::size_t>(column));
  own.lower = lower;
  own.upper = upper;
  simplex_.set_column_bounds(column, lower, upper);
  implied_.lower[static_cast<std::size_t>(column)] = lower;
  implied_.upper[static_cast<std::size_t>(column)] = upper;
}

FormRange BoundTightening::range(std::span<const LinearTerm> form) {
  const auto below = end(form, 1);
  const auto above = end(form, -1);
  return {below.lower, above.upper, below.proved && above.proved};
}

FormRange BoundTightening::upper_end(std::span<const LinearTerm> form) {
  return end(form, -1);
}

// The least of sign * form.
FormRange BoundTightening::end(std::span<const LinearTerm> form, double sign) {
  const auto set_costs = [&](double factor) {
    for (const auto& [column, value] : form) {
      if (column < 0 || column >= simplex_.columns()) {
        throw std::invalid_argument("bound tightening: no such column");
      }
      program_.columns[static_cast<std::size_t>(column)].cost = factor * value;
      simplex_.set_cost(column, factor * value);
    }
  };
  set_costs(sign);
  const linear::SolveLimits limits{.stop = stop_};
  auto status = simplex_.solve_primal(limits);
  if (status == LinearStatus::failed) status = simplex_.solve_robustly(limits);
  double least = -infinity;
  bool proved = true;
  if (status == LinearStatus::optimal) {
    least = linear::safe_dual_bound(program_, simplex_.duals(), implied_.lower, implied_.upper);
    const double found = simplex_.objective();
    const double enough = found - margin * std::max(1.0, std::abs(found));
    if (!(least >= enough)) std::tie(least, proved) = least_precisely();
  } else if (status == LinearStatus::infeasible) {
    std::tie(least, proved) = least_precisely();
  }
  set_costs(0);
  if (least == infinity) return {infinity, -infinity, proved};
  return sign > 0 ? FormRange{least, infinity, proved} : FormRange{-infinity, -least, proved};
}

// The least of the form as it is among the costs, in more digits, and whether that is proved;
// infinity: no point matters.
std::pair<double, bool> BoundTightening::least_precisely() {
  using linear::Residuals;
  const auto found = linear::solve_precisely(program_, simplex_.basis(), stop_);
  for (const auto residuals : {Residuals::proved, Residuals::forgiven}) {
    const bool proved = residuals == Residuals::proved;
    if (found.status == LinearStatus::optimal) {
      const auto bound =
          linear::safe_bound(program_, found.duals, implied_.lower, implied_.upper, residuals);
      if (bound.value > -infinity) return {bound.value, proved};
    } else if (found.status == LinearStatus::infeasible && !found.duals.empty()) {
      const double excess = linear::safe_infeasibility(program_, found.duals, implied_.lower,
                                                       implied_.upper, residuals);
      if (excess > 0) return {infinity, proved};
    }
  }
  return {-infinity, true};
}

namespace {

// a'x + m tau <= upper; tau the binary, at `place` of the program's entries.
struct BigRow {
  std::size_t row = 0;
  std::size_t entry = 0;
  int binary = 0;
  bool from_below = false;  // the row is lower <= a'x + m tau, here with all signs changed
  std::vector<LinearTerm> others;
};

std::vector<BigRow> big_rows(const linear::MixedProgram& mixed) {
  std::vector<bool> is_binary(mixed.program.columns.size());
  for (const int column : mixed.binaries) is_binary[static_cast<std::size_t>(column)] = true;
  struct Seen {
    int binaries = 0;
    std::size_t entry = 0;
    std::vector<LinearTerm> others;
  };
  std::vector<Seen> seen(mixed.program.rows.size());
  for (std::size_t e = 0; e < mixed.program.entries.size(); ++e) {
    const auto& [row, column, value] = mixed.program.entries[e];
    auto& its = seen[static_cast<std::size_t>(row)];
    if (is_binary[static_cast<std::size_t>(column)]) {
      ++its.binaries;
      its.entry = e;
    } else {
      its.others.push_back({column, value});
    }
  }
  std::vector<BigRow> rows;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto& row = mixed.program.rows[i];
    const bool one_sided = std::isfinite(row.lower) != std::isfinite(row.upper);
    if (seen[i].binaries != 1 || seen[i].others.empty() || !one_sided) continue;
    BigRow big{i, seen[i].entry, mixed.program.entries[seen[i].entry].column,
               std::isfinite(row.lower), std::move(seen[i].others)};
    if (big.from_below) {
      for (auto& term : big.others) term.value = -term.value;
    }
    rows.push_back(std::move(big));
  }
  return rows;
}

// One round over all rows.
class Round {
 public:
  Round(linear::MixedProgram& mixed, double cutoff, bool proofs_only, const support::Stop& stop,
        Tightening& result)
      : mixed_(mixed),
        ends_(mixed.program, cutoff, stop),
        proofs_only_(proofs_only),
        stop_(stop),
        result_(result) {}

  /// @return the share of the Ms that is gone
  double apply(const std::vector<BigRow>& rows) {
    double before = 0;
    double gone = 0;
    for (const auto& row : rows) {
      const double m = std::abs(mixed_.program.entries[row.entry].value);
      before += 1;
      gone += m > 0 ? apply(row) / m : 0;
      if (result_.nothing_left || support::asked(stop_)) break;
    }
    result_.programs += ends_.programs();
    return before > 0 ? gone / before : 0;
  }

 private:
  // @return by how much M shrank
  double apply(const BigRow& big) {
    auto& row = mixed_.program.rows[big.row];
    auto& entry = mixed_.program.entries[big.entry];
    auto& column = mixed_.program.columns[static_cast<std::size_t>(big.binary)];
    if (column.lower == column.upper || entry.value == 0) return 0;
    const double m = big.from_below ? -entry.value : entry.value;
    const double upper = big.from_below ? -row.lower : row.upper;
    // The value of the binary at which the row asks for less.
    const double slack_at = m > 0 ? 0 : 1;
    ends_.set_column_bounds(big.binary, slack_at, slack_at);
    const auto range = ends_.upper_end(big.others);
    ends_.set_column_bounds(big.binary, column.lower, column.upper);
    if (proofs_only_ && !range.proved) return 0;
    if (range.lower > range.upper) {
      hold(column, big.binary, 1 - slack_at, range.proved);
      return 0;
    }
    const double tight = m > 0 ? upper - m : upper;
    const double loose = m > 0 ? upper : upper - m;
    const double needed =
        std::max(range.upper, tight + least_share * std::max(std::abs(m), std::abs(upper)));
    const double shrunk = std::abs(m) - (needed - tight);
    if (!(shrunk > worth_a_change * std::abs(m))) return 0;
    // Rounded such that no side asks for more than before, or than needed.
    using linear::rounded::sum_down;
    using linear::rounded::sum_up;
    const double new_m = m > 0 ? sum_down(needed, -sum_up(upper, -m)) : -sum_up(needed, -upper);
    entry.value = big.from_below ? -new_m : new_m;
    const double new_upper = m > 0 ? needed : upper;
    (big.from_below ? row.lower : row.upper) = big.from_below ? -new_upper : new_upper;
    ++result_.coefficients;
    result_.proved = result_.proved && range.proved;
    return loose - needed;
  }

  void hold(linear::LinearColumn& column, int binary, double at, bool proved) {
    result_.proved = result_.proved && proved;
    if (at < column.lower || at > column.upper) {
      result_.nothing_left = true;
      return;
    }
    column.lower = column.upper = at;
    ends_.set_column_bounds(binary, at, at);
    ++result_.fixed;
  }

  linear::MixedProgram& mixed_;
  BoundTightening ends_;
  bool proofs_only_;
  const support::Stop& stop_;
  Tightening& result_;
};

}  // namespace

Tightening tighten_big_m(linear::MixedProgram& mixed, double cutoff, bool proofs_only,
                         const support::Stop& stop) {
  Tightening result;
  const auto rows = big_rows(mixed);
  if (rows.empty() || !std::isfinite(cutoff)) return result;
  while (result.rounds < most_rounds && !result.nothing_left && !support::asked(stop)) {
    ++result.rounds;
    Round round(mixed, cutoff, proofs_only, stop, result);
    if (round.apply(rows) < worth_a_round) break;
  }
  return result;
}

}  // namespace kusabi::zero_one
