// Elimination of rows that are maps from columns to entries.
#include "solvers/linear/rational_factor.hpp"

#include <set>

namespace kusabi::linear {
namespace {

// Limit of the work of an elimination, in squares of the numbers of words that it computes, to which
// the time of their greatest common divisors is proportional: less than a second. It is counted, not
// timed, so that a result does not depend on the machine.
constexpr std::uint64_t max_work = 20'000'000;

std::uint64_t words(const mpq_class& number) {
  return mpz_size(number.get_num_mpz_t()) + mpz_size(number.get_den_mpz_t());
}

}  // namespace

std::optional<RationalFactor> RationalFactor::of(std::vector<Row> rows, const support::Stop& stop,
                                                 bool& too_much) {
  RationalFactor factor;
  std::vector<std::set<std::size_t>> in_column(rows.size());  // rows that are not yet pivots
  std::set<std::pair<std::size_t, std::size_t>> shortest;     // their numbers of entries
  for (std::size_t i = 0; i < rows.size(); ++i) {
    shortest.emplace(rows[i].size(), i);
    for (const auto& [column, entry] : rows[i]) in_column[column].insert(i);
  }
  std::uint64_t work = 0;
  while (!shortest.empty()) {
    too_much = work > max_work;
    if (too_much || support::is_requested(stop)) return {};
    const auto [count, from] = *shortest.begin();
    if (count == 0) return {};  // singular
    shortest.erase(shortest.begin());
    const auto& pivot_row = rows[from];
    auto pivot = pivot_row.begin();
    for (auto entry = pivot_row.begin(); entry != pivot_row.end(); ++entry) {
      in_column[entry->first].erase(from);
      if (in_column[entry->first].size() < in_column[pivot->first].size()) pivot = entry;
    }
    const std::size_t column = pivot->first;
    factor.pivots_.emplace_back(from, column);
    for (const std::size_t i : in_column[column]) {
      auto& row = rows[i];
      shortest.erase({row.size(), i});
      const auto own = row.find(column);
      const mpq_class ratio = own->second / pivot->second;
      row.erase(own);
      for (const auto& [at, entry] : pivot_row) {
        if (at == column) continue;
        auto& changed = row[at];
        changed -= ratio * entry;
        work += words(changed) * words(changed);
        if (sgn(changed) != 0) {
          in_column[at].insert(i);
        } else {
          row.erase(at);
          in_column[at].erase(i);
        }
      }
      shortest.emplace(row.size(), i);
      factor.steps_.push_back({i, from, ratio});
    }
  }
  factor.rows_ = std::move(rows);
  return factor;
}

Rationals RationalFactor::solve(Rationals b) const {
  for (const auto& [row, from, factor] : steps_) {
    if (sgn(b[from]) != 0) b[row] -= factor * b[from];
  }
  Rationals x(b.size());
  for (auto pivot = pivots_.rbegin(); pivot != pivots_.rend(); ++pivot) {
    const auto& [row, column] = *pivot;
    for (const auto& [at, entry] : rows_[row]) {
      if (at != column && sgn(x[at]) != 0) b[row] -= entry * x[at];
    }
    x[column] = b[row] / rows_[row].at(column);
  }
  return x;
}

Rationals RationalFactor::solve_transposed(Rationals c) const {
  Rationals y(c.size());
  for (const auto& [row, column] : pivots_) {
    y[row] = c[column] / rows_[row].at(column);
    if (sgn(y[row]) == 0) continue;
    for (const auto& [at, entry] : rows_[row]) c[at] -= entry * y[row];
  }
  for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
    if (sgn(y[step->row]) != 0) y[step->from] -= step->factor * y[step->row];
  }
  return y;
}

}  // namespace kusabi::linear
