// LimitTruss: the truss of the proofs of a limit-load certificate, with bounds of its rounding.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "verify/arithmetic/exact.hpp"
#include "verify/limit/limit_certificate.hpp"

namespace kusabi::verify {

/// A number within `error` of `value`.
struct Approximate {
  Dyadic value;
  Dyadic error;
};

/// Nonzero entries of a column of B.
using TrussColumn = std::vector<std::pair<std::size_t, Approximate>>;

/// The truss of the proof: that of a certificate, whose numbers are doubles, or that of a problem
/// file, whose direction cosines are roots, enclosed with a hundred digits.
struct LimitTruss {
  std::vector<TrussColumn> columns;    ///< B, by member
  std::vector<Approximate> dead;       ///< f_D
  std::vector<Approximate> reference;  ///< f_R
  std::vector<double> half_widths{};   ///< of the uncertain loads of the problem file, in its order
  std::vector<std::string> members{};  ///< names; empty: that of a certificate, with numbers only
};

/// The truss with the numbers of the certificate.
LimitTruss recorded_truss(const LimitCertificate& certificate);

/// b'u of a member, with the nearest values of b.
Dyadic elongation_of(const TrussColumn& column, const std::vector<Dyadic>& motion);

}  // namespace kusabi::verify
