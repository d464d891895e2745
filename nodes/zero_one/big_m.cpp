// Rounds over all rows; each solves a linear program for the range of the row where it is switched
// off.
#include "nodes/zero_one/big_m.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nodes/zero_one/bound_tightening.hpp"
#include "solvers/linear/rounded.hpp"

namespace kusabi::zero_one {
namespace {

using linear::rounded::sum_down;
using linear::rounded::sum_up;

constexpr std::uint64_t max_rounds = 20;
// Another round follows if one reduces the Ms by at least this share.
constexpr double min_round_gain = 0.01;
// Smallest M other than 0, relative to the largest term of its row and to its given value; smaller
// ones would be rounding errors.
constexpr double min_share = 1e-6;
constexpr double min_share_of_given = 1e-12;
// An M that decreases by less than this share is not changed.
constexpr double min_change = 1e-3;

}  // namespace

BigMs::BigMs(const linear::MixedProgram& given) {
  const auto& program = given.program;
  std::vector<bool> is_binary(program.columns.size());
  for (const int column : given.binaries) is_binary[static_cast<std::size_t>(column)] = true;
  struct Seen {
    int binaries = 0;
    std::size_t entry = 0;
    std::vector<linear::LinearTerm> others;
  };
  std::vector<Seen> seen(program.rows.size());
  for (std::size_t e = 0; e < program.entries.size(); ++e) {
    const auto& [row, column, value] = program.entries[e];
    auto& its = seen[static_cast<std::size_t>(row)];
    if (is_binary[static_cast<std::size_t>(column)]) {
      ++its.binaries;
      its.entry = e;
    } else {
      its.others.push_back({column, value});
    }
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto& row = program.rows[i];
    const bool one_sided = std::isfinite(row.lower) != std::isfinite(row.upper);
    if (seen[i].binaries != 1 || seen[i].others.empty() || !one_sided) continue;
    const auto& entry = program.entries[seen[i].entry];
    const bool from_below = std::isfinite(row.lower);
    const double sign = from_below ? -1 : 1;
    Row big{.row = i,
            .entry = seen[i].entry,
            .binary = entry.column,
            .from_below = from_below,
            .m = sign * entry.value,
            .upper = from_below ? -row.lower : row.upper,
            .others = std::move(seen[i].others)};
    for (auto& term : big.others) term.value *= sign;
    if (big.m != 0) rows_.push_back(std::move(big));
  }
}

std::uint64_t BigMs::smaller() const {
  return static_cast<std::uint64_t>(
      std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.smaller; }));
}

class BigMs::Round {
 public:
  Round(linear::MixedProgram& mixed, double cutoff, const support::Stop& stop,
        TighteningResult& result)
      : mixed_(mixed), ends_(mixed.program, cutoff, stop), stop_(stop), result_(result) {}

  /// @return the relative reduction of the Ms
  double apply(std::vector<Row>& rows) {
    double gone = 0;
    for (auto& row : rows) {
      gone += apply(row);
      if (result_.nothing_left || support::is_requested(stop_)) break;
    }
    result_.programs += ends_.programs();
    return gone / static_cast<double>(rows.size());
  }

 private:
  // @return the relative reduction of M
  double apply(Row& big) {
    const double now = std::abs(mixed_.program.entries[big.entry].value);
    auto& column = mixed_.program.columns[static_cast<std::size_t>(big.binary)];
    if (column.lower == column.upper || now == 0) return 0;
    // The value of the binary at which the row is relaxed.
    const double slack_at = big.m > 0 ? 0 : 1;
    ends_.set_column_bounds(big.binary, slack_at, slack_at);
    const auto range = ends_.upper_end(big.others);
    ends_.set_column_bounds(big.binary, column.lower, column.upper);
    if (range.lower > range.upper) {
      hold(column, big.binary, 1 - slack_at);
      return 0;
    }
    if (!std::isfinite(range.upper)) return 0;
    // Rounded such that neither side is stricter than given, or than necessary.
    const double tight = big.m > 0 ? sum_up(big.upper, -big.m) : big.upper;
    const double minimum = std::max(min_share * std::max(range.size, std::abs(tight)),
                                    min_share_of_given * std::abs(big.m));
    const double needed =
        range.upper <= tight ? tight : std::max(range.upper, sum_up(tight, minimum));
    const double m = big.m > 0 ? sum_down(needed, -tight) : -sum_up(needed, -tight);
    if (!(now - std::abs(m) > min_change * now)) return 0;
    // At the value one of the binary the row of a positive M is that of the file only if both
    // differences are exact: a point of a row one rounding error laxer need not be one of the file.
    const auto is_exact = [](double a, double b) { return sum_up(a, b) == sum_down(a, b); };
    if (big.m > 0 && !(is_exact(big.upper, -big.m) && is_exact(needed, -tight))) return 0;
    replace(big, m, big.m > 0 ? needed : big.upper);
    return (now - std::abs(m)) / now;
  }

  void replace(Row& big, double m, double upper) {
    auto& row = mixed_.program.rows[big.row];
    mixed_.program.entries[big.entry].value = big.from_below ? -m : m;
    (big.from_below ? row.lower : row.upper) = big.from_below ? -upper : upper;
    big.smaller = true;
    result_.changed = true;
  }

  void hold(linear::LinearColumn& column, int binary, double at) {
    if (at < column.lower || at > column.upper) {
      result_.nothing_left = true;
      return;
    }
    column.lower = column.upper = at;
    ends_.set_column_bounds(binary, at, at);
    ++result_.fixed;
    result_.changed = true;
  }

  linear::MixedProgram& mixed_;
  BoundTightening ends_;
  const support::Stop& stop_;
  TighteningResult& result_;
};

TighteningResult BigMs::tighten(linear::MixedProgram& mixed, double cutoff,
                                const support::Stop& stop) {
  TighteningResult result;
  if (rows_.empty() || !std::isfinite(cutoff)) return result;
  while (result.rounds < max_rounds && !result.nothing_left && !support::is_requested(stop)) {
    ++result.rounds;
    Round round(mixed, cutoff, stop, result);
    if (round.apply(rows_) < min_round_gain) break;
  }
  return result;
}

}  // namespace kusabi::zero_one
