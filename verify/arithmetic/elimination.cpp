// Gaussian elimination in rational numbers.
#include "verify/arithmetic/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace kusabi::verify {
namespace {

// a -= factor b.
void subtract(Rationals& a, const mpq_class& factor, const Rationals& b) {
  if (sgn(factor) == 0) return;
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= factor * b[k];
}

}  // namespace

mpq_class dot(const Rationals& a, const Rationals& b) {
  mpq_class sum;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (sgn(a[k]) != 0 && sgn(b[k]) != 0) sum += a[k] * b[k];
  }
  return sum;
}

Elimination::Elimination(std::size_t unknowns) {
  for (std::size_t k = 0; k < unknowns; ++k) basis_.emplace_back(unknowns).at(k) = 1;
}

Rationals Elimination::products(const Rationals& row) const {
  Rationals result;
  for (const auto& column : basis_) result.push_back(dot(row, column));
  return result;
}

bool Elimination::add_equation(const Rationals& row) {
  const auto product = products(row);
  // The pivot is the largest product, which keeps numerators and denominators small.
  const auto largest = std::max_element(product.begin(), product.end(),
                                        [](auto& a, auto& b) { return abs(a) < abs(b); });
  if (largest == product.end() || sgn(*largest) == 0) return false;
  std::vector<Rationals> none;
  take(static_cast<std::size_t>(largest - product.begin()), product, none);
  return true;
}

void Elimination::add_equations_largest_first(const std::vector<Rationals>& rows) {
  std::vector<Rationals> product;  // of each row, with the vectors that are left
  product.reserve(rows.size());
  for (const auto& row : rows) product.push_back(products(row));
  // Sizes by which basis vectors are scaled: those of their largest products.
  std::vector<double> size(basis_.size(), 0);
  for (const auto& own : product) {
    for (std::size_t k = 0; k < own.size(); ++k)
      size[k] = std::max(size[k], std::abs(own[k].get_d()));
  }
  while (!basis_.empty()) {
    double maximum = 0;
    std::size_t row = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < product.size(); ++i) {
      for (std::size_t k = 0; k < basis_.size(); ++k) {
        if (sgn(product[i][k]) == 0) continue;
        const double share = std::abs(product[i][k].get_d()) / size[k];
        if (!(share > maximum)) continue;  // also if both are below all doubles
        maximum = share;
        row = i;
        at = k;
      }
    }
    if (maximum == 0) break;
    take(at, product[row], product);
    size.erase(size.begin() + static_cast<std::ptrdiff_t>(at));
  }
  for (const auto& row : rows)
    add_equation(row);  // remaining ones, whose products are below all doubles
}

void Elimination::take(std::size_t at, Rationals pivots, std::vector<Rationals>& products) {
  const auto place = static_cast<std::ptrdiff_t>(at);
  removed_.push_back(std::move(basis_[at]));
  for (std::size_t k = 0; k < basis_.size(); ++k) {
    if (k == at || sgn(pivots[k]) == 0) continue;
    const mpq_class factor = pivots[k] / pivots[at];
    subtract(basis_[k], factor, removed_.back());
    for (auto& own : products) {
      if (sgn(own[at]) != 0) own[k] -= factor * own[at];
    }
  }
  basis_.erase(basis_.begin() + place);
  for (auto& own : products) own.erase(own.begin() + place);
}

std::optional<Rationals> solution(std::vector<Rationals> rows, Rationals right) {
  const std::size_t unknowns = rows.empty() ? 0 : rows.front().size();
  std::vector<std::size_t> row_of(unknowns, rows.size());
  std::size_t rank = 0;
  for (std::size_t column = 0; column < unknowns && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && sgn(rows[pivot][column]) == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[pivot], rows[rank]);
    std::swap(right[pivot], right[rank]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == rank || sgn(rows[i][column]) == 0) continue;
      const mpq_class factor = rows[i][column] / rows[rank][column];
      subtract(rows[i], factor, rows[rank]);
      right[i] -= factor * right[rank];
    }
    row_of[column] = rank++;
  }
  for (std::size_t i = rank; i < rows.size(); ++i) {
    if (sgn(right[i]) != 0) return {};
  }
  Rationals x(unknowns);
  for (std::size_t column = 0; column < unknowns; ++column) {
    const auto row = row_of[column];
    if (row < rows.size()) x[column] = right[row] / rows[row][column];
  }
  return x;
}

}  // namespace kusabi::verify
