// Cut coefficients as quotients rounded down.
#include "verify/wedged/proved_bounds.hpp"

namespace kusabi::verify {
namespace {

// Lower bound of 1 / x with a relative error below 2^-59. @pre x > 0
Dyadic inverse_below(const Dyadic& x) {
  const Dyadic one(1.0);
  // The relative error of quotient_above is below 2^-60, and (1 + e)(1 - e) < 1.
  constexpr long off = -60;
  return quotient_above(one, x) * (one - one.scaled(off));
}

}  // namespace

void ProvedBounds::limit(std::size_t candidate, Side side, double maximum) {
  auto& share = (side == Side::contact ? reaction_shares_ : gap_shares_)[candidate];
  share = larger(share, inverse_below(Dyadic(maximum)));
}

void ProvedBounds::exclude(std::size_t candidate, Side side) {
  (side == Side::contact ? separated_ : in_contact_).insert(static_cast<int>(candidate));
}

}  // namespace kusabi::verify
