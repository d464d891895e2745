// Entries are words of 64 bits; products are added in 128 bits.
#include "verify/arithmetic/truncated_matrix.hpp"

#include <algorithm>

#include "verify/arithmetic/wide.hpp"

namespace kusabi::verify {
namespace {

// Sums of as many products as there are columns fit into 127 bits if the factors are below these
// powers of two.
constexpr long bits_of_entries = 54;
constexpr std::size_t bits_of_vectors = 62;
constexpr std::size_t max_columns = 1U << 10U;

std::int64_t word(const mpz_class& value) {
  static_assert(sizeof(long) == sizeof(std::int64_t));
  return value.get_si();
}

bool fits(const mpz_class& value) {
  return mpz_sizeinbase(value.get_mpz_t(), 2) <= bits_of_vectors;
}

}  // namespace

TruncatedMatrix::TruncatedMatrix(const DyadicMatrix& matrix) : size_(matrix.size) {
  if (size_ > max_columns) return;
  long bits = 0;
  for (const auto& entry : matrix.entries.mantissas)
    bits = std::max(bits, static_cast<long>(mpz_sizeinbase(entry.get_mpz_t(), 2)));
  const long cut = std::max(0L, bits - bits_of_entries);
  exponent_ = matrix.entries.exponent + cut;
  entries_.reserve(matrix.entries.size());
  mpz_class left;
  for (const auto& entry : matrix.entries.mantissas) {
    mpz_tdiv_q_2exp(left.get_mpz_t(), entry.get_mpz_t(), static_cast<mp_bitcnt_t>(cut));
    entries_.push_back(word(left));
  }
  // The error of each of the size^2 entries is less than one unit.
  if (cut > 0) cut_off_ = Dyadic(static_cast<double>(size_)).scaled(exponent_);
}

std::optional<DyadicList> TruncatedMatrix::operator*(const DyadicList& x) const {
  if (entries_.size() != size_ * size_ || !std::ranges::all_of(x.mantissas, fits)) return {};
  std::vector<std::int64_t> factors(size_);
  std::ranges::transform(x.mantissas, factors.begin(), word);
  DyadicList product;
  product.exponent = exponent_ + x.exponent;
  product.mantissas.reserve(size_);
  for (std::size_t row = 0; row < size_; ++row) {
    const auto* const entries = entries_.data() + row * size_;
    Wide sum = 0;
    for (std::size_t column = 0; column < size_; ++column)
      sum += static_cast<Wide>(entries[column]) * factors[column];
    product.mantissas.push_back(integer(sum));
  }
  return product;
}

}  // namespace kusabi::verify
