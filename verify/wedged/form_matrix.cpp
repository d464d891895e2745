// Products of words are added exactly; factors that only have to be near their value are doubles.
#include "verify/wedged/form_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "verify/arithmetic/cholesky.hpp"
#include "verify/arithmetic/least_squares.hpp"
#include "verify/arithmetic/wide.hpp"

namespace kusabi::verify {

bool FormNumbers::has_allowed_signs() const {
  const auto m = squares.size();
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j)
      if (i != j && products[m * i + j] < 0) return false;
    if (squares[i] <= 0) return false;
  }
  return std::ranges::all_of(pairs, [](double pair) { return pair >= 0; });
}

namespace {

Dyadic size_of(std::span<const double> values) {
  return norm_above(DyadicList(values));
}

Dyadic size_of(const WordGrid& grid) {
  Dyadic sum;
  for (const auto word : grid.words) sum = sum + square(Dyadic(mpz_class(long{word}), 0));
  return sqrt_above(sum.scaled(2 * grid.exponent));
}

// The numbers truncated to a grid of words. @param terms as of words_of()
WordGrid words_of(const std::vector<Dyadic>& values, std::size_t terms) {
  Dyadic largest;
  for (const auto& value : values) largest = larger(largest, absolute(value));
  WordGrid grid{.words = {}, .exponent = largest.magnitude() - word_bits(terms)};
  grid.words.reserve(values.size());
  for (const auto& value : values) grid.words.push_back(value.multiples(grid.exponent).get_si());
  return grid;
}

// A'B, exactly, by rows.
struct WideMatrix {
  std::vector<Wide> sums;
  long exponent = 0;
  std::size_t columns = 0;

  [[nodiscard]] Dyadic at(std::size_t row, std::size_t column) const {
    return {integer(sums[columns * row + column]), exponent};
  }
};

// @param rows of both matrices
WideMatrix transposed_product(const WordGrid& a, const WordGrid& b, std::size_t rows) {
  const auto height = a.words.size() / rows;
  const auto width = b.words.size() / rows;
  WideMatrix result{std::vector<Wide>(height * width), a.exponent + b.exponent, width};
  for (std::size_t i = 0; i < rows; ++i) {
    const auto* const own = b.words.data() + width * i;
    for (std::size_t k = 0; k < height; ++k) {
      const auto factor = static_cast<Wide>(a.words[height * i + k]);
      if (factor == 0) continue;
      auto* const row = result.sums.data() + width * k;
      for (std::size_t l = 0; l < width; ++l) row[l] += factor * own[l];
    }
  }
  return result;
}

}  // namespace

NormalRows normal_rows(const InverseColumns& inverse, const std::vector<ApproximateList>& lifting,
                       std::size_t m, std::size_t d) {
  const auto size = d * m;
  const auto n = size + lifting.size();
  NormalRows rows{{std::vector<std::int64_t>(m * n), inverse.exponent}, inverse.error};
  std::int64_t largest = 0;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t k = 0; k < size; ++k) {
      const auto word = inverse.words[size * i + k];
      rows.grid.words[n * i + k] = word;
      largest = std::max(largest, std::abs(word));
    }
  const long top = inverse.exponent + Dyadic(mpz_class(long{largest}), 0).magnitude();
  for (std::size_t j = 0; j < lifting.size(); ++j) {
    // The unit of a is a power of two such that D is as large as F.
    Dyadic maximum;
    for (std::size_t i = 0; i < m; ++i)
      maximum = larger(maximum, absolute(lifting[j].values[d * i]));
    const long shift = top - maximum.magnitude();
    for (std::size_t i = 0; i < m; ++i)
      rows.grid.words[n * i + size + j] =
          lifting[j].values[d * i].scaled(shift).multiples(inverse.exponent).get_si();
    const Dyadic truncated(mpz_class(1), inverse.exponent);
    rows.error =
        rows.error + Dyadic(static_cast<double>(m)) * (lifting[j].error.scaled(shift) + truncated);
  }
  return rows;
}

FormMatrix::FormMatrix(const FormNumbers& form, const NormalRows& rows, std::size_t d) {
  const auto m = form.squares.size();
  const auto n = rows.grid.words.size() / m;
  std::vector<Dyadic> acting(m * n);
  const auto pairs = words_of(form.pairs, d * m);
  if (!form.pairs.empty()) {
    const auto of_pairs = transposed_product(pairs, rows.grid, m);
    for (std::size_t at = 0; at < acting.size(); ++at) acting[at] = of_pairs.at(at / n, at % n);
  }
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < m; ++j)
      acting[n * i + d * j] = acting[n * i + d * j] + Dyadic(form.products[m * i + j]);
  const auto words = words_of(acting, d * m);
  const auto products = transposed_product(words, rows.grid, m);
  size_ = n;
  lower_.reserve(n * (n + 1) / 2);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t l = 0; l <= k; ++l) lower_.push_back(products.at(k, l) + products.at(l, k));
  const Dyadic truncated(mpz_class(1), words.exponent);
  const auto size = size_of(rows.grid);
  const auto size_of_pairs = form.pairs.empty() ? Dyadic() : size_of(pairs);
  error_ = (rows.error * (size_of(form.products) + size_of_pairs * (size.scaled(1) + rows.error)) +
            size * sqrt_above(Dyadic(static_cast<double>(m * n))) * truncated)
               .scaled(1);
}

void FormMatrix::add_friction(const FormNumbers& form, std::span<const Dyadic> friction,
                              std::size_t d) {
  const auto m = friction.size();
  for (std::size_t k = 0; k < m; ++k) {
    const bool slides = friction[k].sign() == 0;  // r_tk = 0
    const Dyadic twice_square = Dyadic(form.squares[k]).scaled(1);
    for (std::size_t t = d * k + 1; t < d * k + d; ++t) {
      for (std::size_t i = 0; slides && i < size_; ++i) at(i, t) = Dyadic();
      at(t, t) = at(t, t) - twice_square;
    }
    auto& own = at(d * k, d * k);
    own = own + square(friction[k]) * twice_square;
    for (std::size_t j = 0; j < m && !slides; ++j) {
      Dyadic sum;
      for (std::size_t c = 0; c + 1 < d; ++c) {
        const Dyadic slip(form.slips[(m * j + k) * (d - 1) + c]);
        sum = sum + square(slip);
        auto& entry = at(d * j, d * k + 1 + c);
        entry = entry + slip;
      }
      auto& entry = at(d * j, d * k);
      entry = entry + (friction[k] * sqrt_above(sum)).scaled(j == k ? 1 : 0);
    }
  }
}

// C, p x n by rows, near the one for which T + G C + C'G' has the part -level I outside G'r = 0 and
// no coupling to the rest: C = S (-G'T + (G'T G - level G'G) S G'/2), S = (G'G)^-1.
std::optional<std::vector<double>> FormMatrix::equilibrium_factors(std::span<const double> motions,
                                                                   std::size_t p) {
  const auto n = size_;
  const auto size = motions.size() / p;
  double level = 0;
  for (std::size_t i = 0; i < n; ++i)
    level += std::abs(at(i, i).nearest()) / static_cast<double>(n);
  std::vector<double> factors(p * n);
  std::vector<double> moved(p * p);  // S G'T G
  std::vector<double> column(size);
  const LeastSquares of_motions(motions, size);
  for (std::size_t l = 0; l < n; ++l) {
    for (std::size_t k = 0; k < size; ++k) column[k] = at(k, l).nearest();
    const auto shares = of_motions.solve(column);
    if (!shares) return {};
    for (std::size_t q = 0; q < p; ++q) {
      factors[n * q + l] = -(*shares)[q];
      for (std::size_t s = 0; l < size && s < p; ++s)
        moved[p * q + s] += (*shares)[q] * motions[p * l + s];
    }
  }
  for (std::size_t q = 0; q < p; ++q) moved[p * q + q] -= level;
  for (std::size_t l = 0; l < size; ++l) {
    std::ranges::fill(column, 0);
    column[l] = 1;
    const auto shares = of_motions.solve(column);  // S G'
    for (std::size_t q = 0; shares && q < p; ++q)
      for (std::size_t s = 0; s < p; ++s) factors[n * q + l] += moved[p * q + s] * (*shares)[s] / 2;
  }
  return factors;
}

bool FormMatrix::restrict_to_equilibrium(const std::vector<ApproximateList>& motions) {
  const auto p = motions.size();
  if (p == 0) return true;
  const auto size = motions.front().values.size();
  std::vector<double> rounded(p * size);
  Dyadic off;  // bound of the sum of the errors of all entries
  for (std::size_t k = 0; k < size; ++k)
    for (std::size_t q = 0; q < p; ++q) {
      const auto value = motions[q].values[k];
      rounded[p * k + q] = value.nearest();
      off = off + absolute(value - Dyadic(rounded[p * k + q])) + motions[q].error;
    }
  const auto factors = equilibrium_factors(rounded, p);
  if (!factors || !std::ranges::all_of(*factors, [](double c) { return std::isfinite(c); }))
    return false;
  for (std::size_t q = 0; q < p; ++q) {
    std::vector<Dyadic> own;
    for (std::size_t l = 0; l < size_; ++l) own.emplace_back((*factors)[size_ * q + l]);
    for (std::size_t k = 0; k < size; ++k) {
      const Dyadic motion(rounded[p * k + q]);
      for (std::size_t l = 0; l < size_; ++l) {
        auto& entry = at(k, l);
        const auto product = motion * own[l];
        entry = entry + (k == l ? product.scaled(1) : product);
      }
    }
  }
  error_ = error_ + off * size_of(*factors).scaled(1);
  return true;
}

std::optional<Dyadic> FormMatrix::min_opposite() const {
  std::vector<Dyadic> opposite;
  opposite.reserve(lower_.size());
  for (const auto& entry : lower_) opposite.push_back(Dyadic() - entry);
  return verify::min_eigenvalue(Profile::full(size_), DyadicList(opposite));
}

}  // namespace kusabi::verify
