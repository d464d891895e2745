// P = I - B G' with the rounded pseudo-inverse B = G (G'G)^-1; all other operations are exact.
#include "verify/structure/projected_stiffness.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "verify/structure/regularised_stiffness.hpp"

namespace kusabi::verify {
namespace {

constexpr long kept_bits = 160;

// A matrix by columns.
using Columns = std::vector<std::vector<Dyadic>>;

// B and a bound of the error of its entries; nothing if the columns of G are dependent.
std::optional<std::pair<Columns, Dyadic>> pseudo_inverse(const ContactMotions& motions) {
  const auto p = motions.count;
  std::vector<Rationals> gram(p, Rationals(p));
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < p; ++j) {
      for (const auto& row : motions.rows) gram[i][j] += row[i] * row[j];
    }
  }
  const auto inverse = inverse_columns(std::move(gram));
  if (!inverse) return {};
  Columns columns;
  Dyadic error;
  for (const auto& shares : *inverse) {
    const auto near = restricted_to_candidates(motions, shares);
    auto& column = columns.emplace_back();
    for (std::size_t row = 0; row < near.values.size(); ++row) column.push_back(near.values[row]);
    error = larger(error, near.error);
  }
  return std::pair(std::move(columns), error);
}

Columns columns_of(const ContactMotions& motions) {
  Columns columns(motions.count);
  for (const auto& row : motions.rows) {
    // Entries are doubles, so their denominators are powers of two.
    for (std::size_t k = 0; k < motions.count; ++k) {
      const auto bits = static_cast<long>(mpz_scan1(row[k].get_den_mpz_t(), 0));
      columns[k].emplace_back(row[k].get_num(), -bits);
    }
  }
  return columns;
}

// Product of the transpose of a matrix with a vector.
std::vector<Dyadic> transposed_product(const std::vector<Dyadic>& matrix,
                                       const std::vector<Dyadic>& a) {
  std::vector<Dyadic> product(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].sign() == 0) continue;
    for (std::size_t j = 0; j < a.size(); ++j) {
      if (matrix[a.size() * i + j].sign() != 0)
        product[j] = product[j] + matrix[a.size() * i + j] * a[i];
    }
  }
  return product;
}

// M -= G B'M.
void subtract_products(const Columns& g, const Columns& b, std::vector<Dyadic>& matrix) {
  Columns products;
  for (const auto& column : b) products.push_back(transposed_product(matrix, column));
  for (std::size_t k = 0; k < g.size(); ++k) {
    const auto n = g[k].size();
    for (std::size_t i = 0; i < n; ++i) {
      if (g[k][i].sign() == 0) continue;
      for (std::size_t j = 0; j < n; ++j)
        matrix[n * i + j] = matrix[n * i + j] - g[k][i] * products[k][j];
    }
  }
}

EnclosedMatrix on_a_grid(const std::vector<Dyadic>& matrix, std::size_t size) {
  std::optional<long> largest;
  for (const auto& entry : matrix) {
    if (entry.sign() != 0)
      largest = std::max(largest.value_or(entry.magnitude()), entry.magnitude());
  }
  const long grid = largest.value_or(0) - kept_bits;
  EnclosedMatrix result;
  result.middle.size = size;
  result.middle.entries.exponent = grid;
  for (const auto& entry : matrix) result.middle.entries.mantissas.push_back(entry.multiples(grid));
  result.radius = Dyadic(mpz_class(static_cast<unsigned long>(size)), grid);
  return result;
}

}  // namespace

EnclosedMatrix projected(const EnclosedMatrix& stiffness, const ContactMotions& motions) {
  const auto n = stiffness.middle.size;
  const auto inverse = pseudo_inverse(motions);
  if (!inverse) return {{n, DyadicList(n * n)}, Dyadic()};
  const auto& [b, error] = *inverse;
  const auto g = columns_of(motions);
  std::vector<Dyadic> matrix;
  for (std::size_t at = 0; at < n * n; ++at) matrix.push_back(stiffness.middle.entries[at]);
  subtract_products(g, b, matrix);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) std::swap(matrix[n * i + j], matrix[n * j + i]);
  }
  subtract_products(g, b, matrix);
  auto result = on_a_grid(matrix, n);
  // |K| e (2 + e), e = |B - B~| |G|, in Frobenius norms.
  Dyadic square_sum;
  for (const auto& column : g) {
    for (const auto& value : column) square_sum = square_sum + square(value);
  }
  const Dyadic count(static_cast<double>(n * motions.count));
  const auto off = count * error * sqrt_above(square_sum);
  result.radius = result.radius + norm_above(stiffness.middle.entries) * off * (Dyadic(2.0) + off);
  return result;
}

}  // namespace kusabi::verify
