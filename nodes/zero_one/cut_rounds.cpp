// Rounds of Algorithm 5.1.
#include "nodes/zero_one/cut_rounds.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "nodes/zero_one/disjunctive_cuts.hpp"

namespace kusabi::zero_one {
namespace {

using linear::LinearStatus;

// The limit of remark 5.2, in rounds for each binary.
constexpr double rounds_per_binary = 1.8;

std::vector<double> residuals(const Relaxation& relaxation) {
  std::vector<double> list(relaxation.binaries());
  for (std::size_t k = 0; k < list.size(); ++k) {
    const double at = relaxation.value(k);
    list[k] = std::min(at, 1 - at) <= integrality_tolerance ? 0 : at * (1 - at);
  }
  return list;
}

std::ptrdiff_t fractional(const std::vector<double>& residual) {
  return std::count_if(residual.begin(), residual.end(), [](double at) { return at > 0; });
}

}  // namespace

std::optional<std::size_t> CutOrder::next(const std::vector<double>& residual) {
  auto chosen = largest(residual);
  if (!chosen && rejected_) {
    rejected_.reset();
    chosen = largest(residual);
  }
  return chosen;
}

void CutOrder::found_none(std::size_t binary) {
  without_cut_[binary] = true;
  rejected_.reset();
}

void CutOrder::new_point(std::optional<std::size_t> rejected) {
  without_cut_.assign(without_cut_.size(), false);
  rejected_ = rejected;
}

std::optional<std::size_t> CutOrder::largest(const std::vector<double>& residual) const {
  std::optional<std::size_t> chosen;
  for (std::size_t k = 0; k < residual.size(); ++k) {
    if (residual[k] == 0 || without_cut_[k] || rejected_ == k) continue;
    if (!chosen || residual[k] > residual[*chosen]) chosen = k;
  }
  return chosen;
}

CutRounds add_disjunctive_cuts(Relaxation& relaxation, const linear::Basis& basis) {
  CutRounds result;
  result.basis = basis;
  const auto root = relaxation.root();
  const std::size_t rows = relaxation.program().rows.size();
  if (relaxation.solve(root, basis) != LinearStatus::optimal) return result;
  auto residual = residuals(relaxation);
  auto point = relaxation.values();
  CutOrder order(residual.size());
  const auto maximum =
      static_cast<std::uint64_t>(rounds_per_binary * static_cast<double>(residual.size()));
  while (result.rounds < maximum && fractional(residual) > 0 &&
         !support::is_requested(relaxation.stop())) {
    const auto chosen = order.next(residual);
    if (!chosen) break;
    ++result.rounds;
    ++result.programs;
    const auto cut = deepest_cut(relaxation, rows, point, *chosen);
    if (!cut) {
      order.found_none(*chosen);
      continue;
    }
    ++result.found;
    relaxation.add_row({.lower = cut->lower}, cut->terms);
    if (relaxation.solve(root, result.basis) != LinearStatus::optimal) {
      relaxation.drop_last_row();
      break;
    }
    auto now = residuals(relaxation);
    point = relaxation.values();
    if (fractional(now) <= fractional(residual)) {
      ++result.kept;
      result.basis = relaxation.basis();
      order.kept();
    } else {
      // The next cut is made for this point, as in the algorithm, but without this cut.
      relaxation.drop_last_row();
      order.rejected(*chosen);
    }
    residual = std::move(now);
  }
  return result;
}

}  // namespace kusabi::zero_one
