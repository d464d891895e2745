// Proof by a quadratic form: not below zero in any wedged configuration, but negative definite.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/arithmetic/wide.hpp"
#include "verify/arithmetic/word_grid.hpp"
#include "verify/wedged/block_proof.hpp"

namespace kusabi::verify {
namespace {

// The recorded numbers of a block with m candidates.
struct FormNumbers {
  std::span<const double> products;  // P, m x m, by rows
  std::span<const double> slips;     // S, for each pair (j, k) its d - 1 components
  std::span<const double> squares;   // sigma, m
};

FormNumbers parts_of_form(std::span<const double> numbers, std::size_t m, std::size_t d) {
  return {numbers.first(m * m), numbers.subspan(m * m, m * m * (d - 1)), numbers.last(m)};
}

bool has_allowed_signs(const FormNumbers& form) {
  const auto m = form.squares.size();
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j)
      if (i != j && form.products[m * i + j] < 0) return false;
    if (form.squares[i] <= 0) return false;
  }
  return true;
}

// P'F~ by rows, m x dm, exactly: sums of products of words.
struct Responses {
  std::vector<Wide> sums;
  long exponent = 0;
  std::size_t columns = 0;

  [[nodiscard]] Dyadic at(std::size_t row, std::size_t column) const {
    return {integer(sums[columns * row + column]), exponent};
  }
};

Responses responses_of(const WordGrid& products, const InverseColumns& inverse, std::size_t m,
                       std::size_t size) {
  Responses result{std::vector<Wide>(m * size), products.exponent + inverse.exponent, size};
  for (std::size_t i = 0; i < m; ++i) {
    const auto* const own = inverse.words.data() + size * i;
    for (std::size_t j = 0; j < m; ++j) {
      const auto factor = static_cast<Wide>(products.words[m * i + j]);
      if (factor == 0) continue;
      auto* const row = result.sums.data() + size * j;
      for (std::size_t k = 0; k < size; ++k) row[k] += factor * own[k];
    }
  }
  return result;
}

Dyadic size_of(const WordGrid& grid) {
  Dyadic sum;
  for (const auto word : grid.words) sum = sum + square(Dyadic(mpz_class(long{word}), 0));
  return sqrt_above(sum.scaled(2 * grid.exponent));
}

// E diag(omega) with 4 sigma omega^2 >= 1, truncated to a grid, and sizes of S, which include the
// truncated part.
class SlipPart {
 public:
  SlipPart(const FormNumbers& form, const Responses& responses, std::span<const Dyadic> friction,
           std::size_t d)
      : m_(friction.size()), tangents_(d - 1), exact_(m_ * m_ * tangents_), sizes_(m_ * m_) {
    std::vector<Dyadic> roots(m_);
    Dyadic largest;
    for (std::size_t k = 0; k < m_; ++k) {
      if (friction[k].sign() == 0) continue;  // r_tk = 0
      roots[k] = sqrt_above(quotient_above(Dyadic(0.25), Dyadic(form.squares[k])));
      for (std::size_t j = 0; j < m_; ++j) {
        for (std::size_t c = 0; c < tangents_; ++c) {
          auto& sum = exact_[place(j, k, c)];
          sum = roots[k] * (responses.at(j, d * k + 1 + c) + Dyadic(form.slips[place(j, k, c)]));
          largest = larger(largest, absolute(sum));
        }
      }
    }
    exponent_ = largest.magnitude() - word_bits(m_ * tangents_);
    words_.resize(exact_.size());
    for (std::size_t at = 0; at < exact_.size(); ++at)
      words_[at] = exact_[at].multiples(exponent_).get_si();
    measure(form, friction, roots);
  }

  // Upper bound of mu_k |S_jk|.
  [[nodiscard]] const Dyadic& size(std::size_t j, std::size_t k) const {
    return sizes_[m_ * j + k];
  }

  [[nodiscard]] Dyadic product(std::size_t j, std::size_t l) const {
    const auto* const row = words_.data() + m_ * tangents_ * j;
    const auto* const other = words_.data() + m_ * tangents_ * l;
    Wide sum = 0;
    for (std::size_t at = 0; at < m_ * tangents_; ++at)
      sum += static_cast<Wide>(row[at]) * other[at];
    return {integer(sum), 2 * exponent_};
  }

 private:
  [[nodiscard]] std::size_t place(std::size_t j, std::size_t k, std::size_t c) const {
    return (m_ * j + k) * tangents_ + c;
  }

  void measure(const FormNumbers& form, std::span<const Dyadic> friction,
               std::span<const Dyadic> roots) {
    const Dyadic unit(mpz_class(static_cast<long>(tangents_)), exponent_);
    for (std::size_t k = 0; k < m_; ++k) {
      if (friction[k].sign() == 0) continue;
      const auto off = quotient_above(unit, roots[k]);
      for (std::size_t j = 0; j < m_; ++j) {
        Dyadic sum;
        for (std::size_t c = 0; c < tangents_; ++c)
          sum = sum + square(Dyadic(form.slips[place(j, k, c)]));
        sizes_[m_ * j + k] = friction[k] * (sqrt_above(sum) + off);
      }
    }
  }

  std::size_t m_;
  std::size_t tangents_;
  std::vector<Dyadic> exact_;
  std::vector<Dyadic> sizes_;
  std::vector<std::int64_t> words_;
  long exponent_ = 0;
};

}  // namespace

// Proves that minus the form has a least eigenvalue larger than the effect of the error of F~.
Judgement BlockProof::judge_form(std::span<const double> numbers) const {
  if (motions() > 0) return {"a form proves nothing about unconstrained bodies"};
  const auto m = candidates();
  const auto d = block_.dimension;
  const auto form = parts_of_form(numbers, m, d);
  if (!has_allowed_signs(form))
    return {"a multiplier of two different candidates is below zero, or one of squares not above"};
  std::vector<std::size_t> normals;
  for (std::size_t i = 0; i < m; ++i) normals.push_back(d * i);
  const auto inverse = held_.front().inverse_columns(normals);
  if (!inverse) return {"K is too ill-conditioned to compute its displacements"};
  const auto products = words_of(form.products, d * m);
  const auto responses = responses_of(products, *inverse, m, d * m);
  const SlipPart slips(form, responses, friction_, d);
  std::vector<Dyadic> lower;
  for (std::size_t j = 0; j < m; ++j) {
    for (std::size_t l = 0; l <= j; ++l) {
      const auto twice =
          responses.at(j, d * l) + responses.at(l, d * j) + slips.size(j, l) + slips.size(l, j);
      auto entry = twice.scaled(-1) + slips.product(j, l);
      if (j == l) entry = entry + square(friction_[j]) * Dyadic(form.squares[j]);
      lower.push_back(Dyadic() - entry);
    }
  }
  const auto least = verify::least_eigenvalue(Profile::full(m), DyadicList(lower));
  const auto off = size_of(products) * inverse->error * (Dyadic(1.0) + steepest_);
  if (!least || !(*least > off)) return {"its form is not negative definite"};
  return {};
}

}  // namespace kusabi::verify
