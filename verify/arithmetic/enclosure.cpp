// MPFR computes both bounds, the lower one rounded down and the upper one up.
#include "verify/arithmetic/enclosure.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace kusabi::verify {
namespace {

constexpr mpfr_prec_t precision = 320;

// The bounds of a product or quotient of intervals are among those of their bounds.
template <class Operation>
void extremes(Operation operation, const std::array<mpfr_srcptr, 2>& a,
              const std::array<mpfr_srcptr, 2>& b, mpfr_ptr lower, mpfr_ptr upper) {
  mpfr_t value;
  mpfr_init2(value, precision);
  bool first = true;
  bool valid = true;
  for (const auto* x : a) {
    for (const auto* y : b) {
      operation(value, x, y, MPFR_RNDD);
      valid = valid && mpfr_nan_p(value) == 0;
      if (first || mpfr_less_p(value, lower) != 0) mpfr_set(lower, value, MPFR_RNDD);
      operation(value, x, y, MPFR_RNDU);
      if (first || mpfr_greater_p(value, upper) != 0) mpfr_set(upper, value, MPFR_RNDU);
      first = false;
    }
  }
  if (!valid) {
    mpfr_set_nan(lower);
    mpfr_set_nan(upper);
  }
  mpfr_clear(value);
}

Dyadic exactly(mpfr_srcptr value) {
  if (mpfr_zero_p(value) != 0) return {};
  mpz_class mantissa;
  const auto exponent = mpfr_get_z_2exp(mantissa.get_mpz_t(), value);
  return {std::move(mantissa), static_cast<long>(exponent)};
}

}  // namespace

Enclosure::Enclosure(double value) {
  mpfr_init2(lower_, precision);
  mpfr_init2(upper_, precision);
  mpfr_set_d(lower_, value, MPFR_RNDD);
  mpfr_set_d(upper_, value, MPFR_RNDU);
}

Enclosure::Enclosure(const Dyadic& value) {
  const mpz_class mantissa = value.multiples(value.exponent());
  mpfr_init2(lower_, precision);
  mpfr_init2(upper_, precision);
  mpfr_set_z_2exp(lower_, mantissa.get_mpz_t(), value.exponent(), MPFR_RNDD);
  mpfr_set_z_2exp(upper_, mantissa.get_mpz_t(), value.exponent(), MPFR_RNDU);
}

Enclosure::Enclosure(const Enclosure& other) {
  mpfr_init2(lower_, precision);
  mpfr_init2(upper_, precision);
  mpfr_set(lower_, other.lower_, MPFR_RNDD);
  mpfr_set(upper_, other.upper_, MPFR_RNDU);
}

Enclosure::Enclosure(Enclosure&& other) noexcept : Enclosure(0.0) {
  *this = std::move(other);
}

Enclosure& Enclosure::operator=(const Enclosure& other) {
  mpfr_set(lower_, other.lower_, MPFR_RNDD);
  mpfr_set(upper_, other.upper_, MPFR_RNDU);
  return *this;
}

Enclosure& Enclosure::operator=(Enclosure&& other) noexcept {
  mpfr_swap(lower_, other.lower_);
  mpfr_swap(upper_, other.upper_);
  return *this;
}

Enclosure::~Enclosure() {
  mpfr_clear(lower_);
  mpfr_clear(upper_);
}

Enclosure operator+(const Enclosure& a, const Enclosure& b) {
  Enclosure sum;
  mpfr_add(sum.lower_, a.lower_, b.lower_, MPFR_RNDD);
  mpfr_add(sum.upper_, a.upper_, b.upper_, MPFR_RNDU);
  return sum;
}

Enclosure operator-(const Enclosure& a, const Enclosure& b) {
  Enclosure difference;
  mpfr_sub(difference.lower_, a.lower_, b.upper_, MPFR_RNDD);
  mpfr_sub(difference.upper_, a.upper_, b.lower_, MPFR_RNDU);
  return difference;
}

Enclosure operator*(const Enclosure& a, const Enclosure& b) {
  Enclosure product;
  // Two products are enough if each interval has one sign, as nearly all have.
  if (mpfr_sgn(a.lower_) >= 0 && mpfr_sgn(b.lower_) >= 0) {
    mpfr_mul(product.lower_, a.lower_, b.lower_, MPFR_RNDD);
    mpfr_mul(product.upper_, a.upper_, b.upper_, MPFR_RNDU);
    return product;
  }
  if (mpfr_sgn(a.lower_) >= 0 && mpfr_sgn(b.upper_) <= 0) {
    mpfr_mul(product.lower_, a.upper_, b.lower_, MPFR_RNDD);
    mpfr_mul(product.upper_, a.lower_, b.upper_, MPFR_RNDU);
    return product;
  }
  if (mpfr_sgn(a.upper_) <= 0 && mpfr_sgn(b.lower_) >= 0) return b * a;
  if (mpfr_sgn(a.upper_) <= 0 && mpfr_sgn(b.upper_) <= 0) {
    mpfr_mul(product.lower_, a.upper_, b.upper_, MPFR_RNDD);
    mpfr_mul(product.upper_, a.lower_, b.lower_, MPFR_RNDU);
    return product;
  }
  extremes(mpfr_mul, {a.lower_, a.upper_}, {b.lower_, b.upper_}, product.lower_, product.upper_);
  return product;
}

void Enclosure::add_product(const Enclosure& a, const Enclosure& b) {
  const auto add = [this](mpfr_srcptr below_a, mpfr_srcptr below_b, mpfr_srcptr above_a,
                          mpfr_srcptr above_b) {
    mpfr_fma(lower_, below_a, below_b, lower_, MPFR_RNDD);
    mpfr_fma(upper_, above_a, above_b, upper_, MPFR_RNDU);
  };
  if (!a.finite() || !b.finite()) {
    *this += a * b;
  } else if (mpfr_sgn(a.lower_) >= 0 && mpfr_sgn(b.lower_) >= 0) {
    add(a.lower_, b.lower_, a.upper_, b.upper_);
  } else if (mpfr_sgn(a.lower_) >= 0 && mpfr_sgn(b.upper_) <= 0) {
    add(a.upper_, b.lower_, a.lower_, b.upper_);
  } else if (mpfr_sgn(a.upper_) <= 0 && mpfr_sgn(b.lower_) >= 0) {
    add(a.lower_, b.upper_, a.upper_, b.lower_);
  } else if (mpfr_sgn(a.upper_) <= 0 && mpfr_sgn(b.upper_) <= 0) {
    add(a.upper_, b.upper_, a.lower_, b.lower_);
  } else {
    *this += a * b;
  }
}

Enclosure operator/(const Enclosure& a, const Enclosure& b) {
  Enclosure quotient;
  // The condition counts NaN as zero.
  if (!(mpfr_sgn(b.lower_) > 0 || mpfr_sgn(b.upper_) < 0) || !b.finite()) {
    mpfr_set_nan(quotient.lower_);
    mpfr_set_nan(quotient.upper_);
    return quotient;
  }
  extremes(mpfr_div, {a.lower_, a.upper_}, {b.lower_, b.upper_}, quotient.lower_, quotient.upper_);
  return quotient;
}

Enclosure operator-(const Enclosure& a) {
  return Enclosure() - a;
}

Enclosure sqrt(const Enclosure& a) {
  Enclosure root;
  mpfr_sqrt(root.lower_, a.lower_, MPFR_RNDD);  // not finite for a negative number
  mpfr_sqrt(root.upper_, a.upper_, MPFR_RNDU);
  return root;
}

Enclosure magnitude(const Enclosure& a) {
  if (!a.finite() || mpfr_sgn(a.lower_) >= 0) return a;
  if (mpfr_sgn(a.upper_) <= 0) return -a;
  Enclosure result;
  mpfr_neg(result.upper_, a.lower_, MPFR_RNDU);
  mpfr_max(result.upper_, result.upper_, a.upper_, MPFR_RNDU);
  return result;
}

bool Enclosure::finite() const {
  return mpfr_number_p(lower_) != 0 && mpfr_number_p(upper_) != 0;
}

bool Enclosure::is_zero() const {
  return mpfr_zero_p(lower_) != 0 && mpfr_zero_p(upper_) != 0;
}

Dyadic Enclosure::lower() const {
  return exactly(lower_);
}

Dyadic Enclosure::upper() const {
  return exactly(upper_);
}

Dyadic Enclosure::distance(const Dyadic& value) const {
  const auto above = upper() - value;
  const auto below = value - lower();
  return above < below ? below : above;
}

}  // namespace kusabi::verify
