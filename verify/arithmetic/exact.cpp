// Mantissas and exponents of doubles, and sums of numbers with different exponents.
#include "verify/arithmetic/exact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "verify/arithmetic/wide.hpp"

namespace kusabi::verify {
namespace {

// value = mantissa * 2^exponent with an integer |mantissa| < 2^53.
struct Parts {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

Parts parts_of(double value) {
  if (!std::isfinite(value)) throw std::domain_error("a number is too large to compute with");
  constexpr int digits = std::numeric_limits<double>::digits;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(fraction * 0x1p53), exponent - digits};
}

mpz_class integer(std::int64_t value) {
  static_assert(sizeof(long) == sizeof(std::int64_t), "GMP takes long");
  return mpz_class(static_cast<long>(value));
}

void shift_up(mpz_class& value, long bits) {
  mpz_mul_2exp(value.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
}

double towards(const mpq_class& value, double limit) {
  double number = value.get_d();
  if (std::isinf(number)) number = std::copysign(std::numeric_limits<double>::max(), number);
  const auto beyond = [&] { return limit < 0 ? number > value : number < value; };
  while (std::isfinite(number) && beyond()) number = std::nextafter(number, limit);
  return number;
}

}  // namespace

bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

Dyadic::Dyadic(double value) {
  const auto parts = parts_of(value);
  mantissa_ = integer(parts.mantissa);
  exponent_ = parts.mantissa == 0 ? 0 : parts.exponent;
}

mpq_class Dyadic::rational() const {
  mpq_class value(mantissa_);
  const auto shift = static_cast<mp_bitcnt_t>(exponent_ < 0 ? -exponent_ : exponent_);
  if (exponent_ < 0) {
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), shift);
  } else {
    mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), shift);
  }
  return value;
}

double Dyadic::nearest() const {
  long exponent = 0;
  const double fraction = mpz_get_d_2exp(&exponent, mantissa_.get_mpz_t());
  constexpr long far = 10000;  // exceeds the exponent of any double
  return std::ldexp(fraction, static_cast<int>(std::clamp(exponent + exponent_, -far, far)));
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  if (a.exponent_ < b.exponent_) return b + a;
  mpz_class sum = a.mantissa_;
  shift_up(sum, a.exponent_ - b.exponent_);
  sum += b.mantissa_;
  return {std::move(sum), b.exponent_};
}

namespace {

// sum <- sum + sign |a| factor 2^shift in place. @pre the sum is zero or has this sign
void add_in_place(mpz_class& sum, int sign, const mpz_class& a, Wide factor, std::size_t shift) {
  const auto* const terms = mpz_limbs_read(a.get_mpz_t());
  const auto count = mpz_size(a.get_mpz_t());
  const auto old = mpz_size(sum.get_mpz_t());
  auto first = shift / GMP_NUMB_BITS;
  const auto size = static_cast<mp_size_t>(std::max(old, first + count + 2) + 1);
  auto* const limbs = mpz_limbs_modify(sum.get_mpz_t(), size);
  std::fill(limbs + old, limbs + size, mp_limb_t{0});
  factor <<= shift % GMP_NUMB_BITS;
  for (; factor != 0; factor >>= GMP_NUMB_BITS, ++first) {
    auto carry = mpn_addmul_1(limbs + first, terms, static_cast<mp_size_t>(count),
                              static_cast<mp_limb_t>(factor));
    for (auto* next = limbs + first + count; carry != 0; ++next) {
      *next += carry;
      carry = *next < carry ? 1 : 0;
    }
  }
  mpz_limbs_finish(sum.get_mpz_t(), sign < 0 ? -size : size);
}

}  // namespace

void Dyadic::add_product(const Dyadic& a, double b) {
  if (&a == this) return add_product(Dyadic(a), b);
  const auto parts = parts_of(b);
  if (parts.mantissa == 0 || a.sign() == 0) return;
  const long exponent = a.exponent_ + parts.exponent;
  if (sign() == 0) exponent_ = exponent;
  if (exponent < exponent_) {
    shift_up(mantissa_, exponent_ - exponent);
    exponent_ = exponent;
  }
  const auto size = std::abs(parts.mantissa);
  const auto shift = static_cast<std::size_t>(exponent - exponent_);
  const int product_sign = parts.mantissa < 0 ? -a.sign() : a.sign();
  if (sign() * product_sign >= 0) {
    add_in_place(mantissa_, product_sign, a.mantissa_, size, shift);
    return;
  }
  mpz_class product = a.mantissa_ * static_cast<unsigned long>(size);
  mpz_mul_2exp(product.get_mpz_t(), product.get_mpz_t(), shift);
  (parts.mantissa < 0 ? mpz_sub : mpz_add)(mantissa_.get_mpz_t(), mantissa_.get_mpz_t(),
                                           product.get_mpz_t());
}

mpz_class Dyadic::multiples(long exponent) const {
  mpz_class count = mantissa_;
  const long shift = exponent_ - exponent;
  if (shift >= 0) {
    shift_up(count, shift);
  } else {
    mpz_fdiv_q_2exp(count.get_mpz_t(), count.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
  }
  return count;
}

long Dyadic::magnitude() const {
  if (sign() == 0) return 0;
  return static_cast<long>(mpz_sizeinbase(mantissa_.get_mpz_t(), 2)) + exponent_;
}

Dyadic quotient_above(const Dyadic& a, const Dyadic& b) {
  if (a.sign() == 0) return {};
  // Digits added to the dividend such that the quotient has at least 64.
  constexpr long wanted = 64;
  mpz_class dividend = a.mantissa_;
  const auto have = static_cast<long>(mpz_sizeinbase(dividend.get_mpz_t(), 2));
  const auto divisor = static_cast<long>(mpz_sizeinbase(b.mantissa_.get_mpz_t(), 2));
  const long shift = std::max(0L, divisor + wanted - have);
  shift_up(dividend, shift);
  mpz_class quotient;
  mpz_cdiv_q(quotient.get_mpz_t(), dividend.get_mpz_t(), b.mantissa_.get_mpz_t());
  return {std::move(quotient), a.exponent_ - b.exponent_ - shift};
}

Dyadic sqrt_above(const Dyadic& value) {
  if (value.sign() == 0) return {};
  // Digits added such that the root has at least 64 and the exponent is even.
  constexpr std::size_t wanted = 128;
  mpz_class mantissa = value.mantissa_;
  long exponent = value.exponent_;
  const auto digits = mpz_sizeinbase(mantissa.get_mpz_t(), 2);
  long shift = digits < wanted ? static_cast<long>(wanted - digits) : 0;
  if ((exponent - shift) % 2 != 0) ++shift;
  shift_up(mantissa, shift);
  exponent -= shift;
  mpz_class root;
  mpz_class rest;
  mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), mantissa.get_mpz_t());
  if (sgn(rest) != 0) ++root;
  return {std::move(root), exponent / 2};
}

DyadicList::DyadicList(std::span<const double> values, int kept_bits) {
  long minimum = std::numeric_limits<long>::max();
  long largest = std::numeric_limits<long>::min();
  for (const double value : values) {
    if (value == 0) continue;
    const long its = parts_of(value).exponent;
    minimum = std::min(minimum, its);
    largest = std::max(largest, its);
  }
  if (minimum <= largest) exponent = std::max(minimum, largest - kept_bits);
  mantissas.reserve(values.size());
  for (const double value : values) {
    const auto parts = parts_of(value);
    auto mantissa = integer(parts.mantissa);
    const long shift = parts.exponent - exponent;
    if (parts.mantissa != 0 && shift >= 0) shift_up(mantissa, shift);
    if (parts.mantissa != 0 && shift < 0) {
      mpz_tdiv_q_2exp(mantissa.get_mpz_t(), mantissa.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
    }
    mantissas.push_back(std::move(mantissa));
  }
}

DyadicList::DyadicList(std::span<const Dyadic> values) {
  long minimum = std::numeric_limits<long>::max();
  for (const auto& value : values) {
    if (value.sign() != 0) minimum = std::min(minimum, value.exponent());
  }
  if (minimum < std::numeric_limits<long>::max()) exponent = minimum;
  mantissas.reserve(values.size());
  for (const auto& value : values) mantissas.push_back(value.multiples(exponent));
}

DyadicList& DyadicList::operator+=(DyadicList other) {
  if (exponent < other.exponent) std::swap(*this, other);
  for (std::size_t i = 0; i < size(); ++i) {
    shift_up(mantissas[i], exponent - other.exponent);
    mantissas[i] += other.mantissas[i];
  }
  exponent = other.exponent;
  return *this;
}

DyadicList& DyadicList::operator-=(DyadicList other) {
  for (auto& mantissa : other.mantissas) mpz_neg(mantissa.get_mpz_t(), mantissa.get_mpz_t());
  return *this += std::move(other);
}

DyadicList DyadicMatrix::operator*(const DyadicList& x) const {
  DyadicList product;
  product.exponent = entries.exponent + x.exponent;
  product.mantissas.resize(size);
  for (std::size_t row = 0; row < size; ++row) {
    auto* const sum = product.mantissas[row].get_mpz_t();
    for (std::size_t column = 0; column < size; ++column) {
      mpz_addmul(sum, entries.mantissas[row * size + column].get_mpz_t(),
                 x.mantissas[column].get_mpz_t());
    }
  }
  return product;
}

double rounded_down(const mpq_class& value) {
  return towards(value, -std::numeric_limits<double>::infinity());
}

double rounded_up(const mpq_class& value) {
  return towards(value, std::numeric_limits<double>::infinity());
}

}  // namespace kusabi::verify
