// Gaussian elimination in rational numbers, and of equations with a right-hand side in integers
// whose common divisors are removed: half of the time of rational numbers is spent on the common
// divisors of each sum and product.
#include "verify/arithmetic/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
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

namespace {

using Integers = std::vector<mpz_class>;

// Numbers in the same ratios that are integers.
Integers integers_of(const Rationals& numbers) {
  mpz_class denominator = 1;
  for (const auto& each : numbers)
    mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), each.get_den_mpz_t());
  Integers result;
  result.reserve(numbers.size());
  for (const auto& each : numbers)
    result.emplace_back(each.get_num() * (denominator / each.get_den()));
  return result;
}

// Divides the integers by their greatest common divisor.
void reduce(Integers& row) {
  mpz_class divisor;
  for (const auto& each : row) {
    if (sgn(each) != 0) divisor = gcd(divisor, each);
    if (divisor == 1) return;
  }
  if (divisor == 0) return;
  for (auto& each : row)
    if (sgn(each) != 0) mpz_divexact(each.get_mpz_t(), each.get_mpz_t(), divisor.get_mpz_t());
}

// Subtracts the multiple of the pivot row that makes the entry of a column zero.
void eliminate(Integers& row, const Integers& pivots, std::size_t column) {
  const mpz_class common = gcd(pivots[column], row[column]);
  const mpz_class own = pivots[column] / common;
  const mpz_class other = row[column] / common;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (sgn(row[k]) != 0) row[k] *= own;
    if (sgn(pivots[k]) != 0) row[k] -= other * pivots[k];
  }
  reduce(row);
}

struct Pivot {
  std::size_t row, column;
};

// Equations row'x = right for several right-hand sides, as rows of integers with the right-hand
// sides last, in an order of elimination.
class Equations {
 public:
  // @param rows of coefficients, followed by their right-hand sides
  Equations(const std::vector<Rationals>& rows, std::size_t unknowns) : unknowns_(unknowns) {
    rows_.reserve(rows.size());
    for (const auto& row : rows) rows_.push_back(integers_of(row));
  }

  // A solution for each right-hand side. @return nothing if one of them has none
  std::optional<std::vector<Rationals>> solve() {
    std::vector<std::size_t> left(rows_.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    std::vector<Pivot> pivots;
    while (const auto pivot = next(left)) {
      std::erase(left, pivot->row);
      for (const auto i : left)
        if (sgn(rows_[i][pivot->column]) != 0)
          eliminate(rows_[i], rows_[pivot->row], pivot->column);
      pivots.push_back(*pivot);
    }
    const auto is_zero = [&](std::size_t i) { return entries(i, rows_[i].size()) == 0; };
    if (!std::ranges::all_of(left, is_zero)) return {};
    std::vector<Rationals> solutions;
    const std::size_t sides = rows_.empty() ? 0 : rows_.front().size() - unknowns_;
    solutions.reserve(sides);
    for (std::size_t side = 0; side < sides; ++side)
      solutions.push_back(substituted(pivots, unknowns_ + side));
    return solutions;
  }

 private:
  // The number of entries of a row that are not zero, of the first `size`.
  std::size_t entries(std::size_t row, std::size_t size) const {
    const auto begin = rows_[row].begin();
    return static_cast<std::size_t>(std::count_if(begin, begin + static_cast<std::ptrdiff_t>(size),
                                                  [](auto& x) { return sgn(x) != 0; }));
  }

  // The row with the fewest entries that are not zero, and the column of the fewest among those of
  // the row: equations of bodies that touch few others then fill in little.
  // @return nothing if no equation is left
  std::optional<Pivot> next(const std::vector<std::size_t>& left) const {
    std::optional<Pivot> best;
    std::size_t fewest = 0;
    for (const auto i : left) {
      const auto own = entries(i, unknowns_);
      if (own == 0 || (best && own >= fewest)) continue;
      best = Pivot{i, 0};
      fewest = own;
    }
    if (!best) return {};
    fewest = left.size() + 1;
    for (std::size_t column = 0; column < unknowns_; ++column) {
      if (sgn(rows_[best->row][column]) == 0) continue;
      const auto own = static_cast<std::size_t>(
          std::ranges::count_if(left, [&](auto i) { return sgn(rows_[i][column]) != 0; }));
      if (own >= fewest) continue;
      best->column = column;
      fewest = own;
    }
    return best;
  }

  // The unknowns have a common denominator; those without a pivot are zero.
  // @param right column of the right-hand side
  Rationals substituted(const std::vector<Pivot>& pivots, std::size_t right) const {
    Integers x(unknowns_);
    mpz_class denominator = 1;
    for (auto pivot = pivots.rbegin(); pivot != pivots.rend(); ++pivot) {
      const auto& row = rows_[pivot->row];
      mpz_class rest = row[right] * denominator;
      for (std::size_t k = 0; k < unknowns_; ++k)
        if (sgn(row[k]) != 0 && sgn(x[k]) != 0) rest -= row[k] * x[k];
      const mpz_class common = gcd(rest, row[pivot->column]);
      const mpz_class factor = row[pivot->column] / common;
      if (factor != 1) {
        for (auto& each : x) each *= factor;
        denominator *= factor;
      }
      x[pivot->column] = rest / common;
    }
    Rationals result;
    for (const auto& each : x) result.emplace_back(each, denominator).canonicalize();
    return result;
  }

  std::size_t unknowns_;
  std::vector<Integers> rows_;
};

}  // namespace

std::optional<Rationals> solution(std::vector<Rationals> rows, const Rationals& right) {
  if (rows.empty()) return Rationals();
  const std::size_t unknowns = rows.front().size();
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(right[i]);
  auto solutions = Equations(rows, unknowns).solve();
  if (!solutions) return {};
  return std::move(solutions->front());
}

std::optional<std::vector<Rationals>> inverse_columns(std::vector<Rationals> rows) {
  const std::size_t size = rows.size();
  for (std::size_t i = 0; i < size; ++i) {
    rows[i].resize(2 * size);
    rows[i][size + i] = 1;
  }
  return Equations(rows, size).solve();
}

}  // namespace kusabi::verify
