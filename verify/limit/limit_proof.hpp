// Proofs of the claims of a limit-load certificate in exact arithmetic. docs/theory/proofs.md
// derives them with the same letters. They depend neither on the solver nor on any result of it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <gmpxx.h>

#include "verify/arithmetic/exact.hpp"
#include "verify/limit/enclosed_sum.hpp"
#include "verify/limit/equilibrium_correction.hpp"
#include "verify/limit/limit_certificate.hpp"

namespace kusabi::verify {

/// A number within `error` of `value`.
struct Approximate {
  Dyadic value;
  Dyadic error;
};

/// The truss of the proof: that of a certificate, whose numbers are doubles, or that of a problem
/// file, whose direction cosines are roots, enclosed with a hundred digits.
struct LimitTruss {
  std::vector<std::vector<std::pair<std::size_t, Approximate>>> columns;  ///< B, by member
  std::vector<Approximate> dead;                                          ///< f_D
  std::vector<Approximate> reference;                                     ///< f_R
  std::vector<double> half_widths{};   ///< of the uncertain loads of the problem file, in its order
  std::vector<std::string> members{};  ///< names; empty: that of a certificate, with numbers only
};

/// The truss with the numbers of the certificate.
LimitTruss recorded_truss(const LimitCertificate& certificate);

class LimitProof {
 public:
  /// @pre the certificate outlives this object
  LimitProof(const LimitCertificate& certificate, LimitTruss truss);
  explicit LimitProof(const LimitCertificate& certificate)
      : LimitProof(certificate, recorded_truss(certificate)) {}

  /// Upper bound of lambda_min by the kinematic principle, for the recorded load and motion;
  /// otherwise the reason why there is none.
  [[nodiscard]] std::variant<mpq_class, std::string> upper() const;

  /// Lower bound of the factors of all admissible loads of the node; otherwise the reason why there
  /// is none.
  [[nodiscard]] std::variant<mpq_class, std::string> lower(const LimitNode& node) const;

  /// True if the recorded load is admissible and the recorded motion, or its opposite, proves that
  /// no factor exists: after a correction at one displacement that makes the work of f_R zero, the
  /// work of the load exceeds the largest dissipation of the members.
  [[nodiscard]] bool shows_no_factor() const;

 private:
  [[nodiscard]] Sparse defect_of(const LimitCut& cut, std::span<const EnclosedSum> sums) const;
  [[nodiscard]] Sparse exact_defect_of(const LimitCut& cut) const;
  [[nodiscard]] std::vector<Dyadic> defect(const Sparse& forces, std::vector<Dyadic> load,
                                           double factor) const;
  [[nodiscard]] std::optional<std::string> yielding(const LimitNode& node,
                                                    const std::vector<Dyadic>& taken,
                                                    const std::vector<double>& defects) const;
  [[nodiscard]] std::vector<Dyadic> corrected_motion(bool without_work) const;
  [[nodiscard]] bool load_is_admissible() const;
  [[nodiscard]] std::string name_of(std::size_t member) const;

  const LimitCertificate& certificate_;
  LimitTruss truss_;
  std::vector<LimitColumn> uncertain_;  // T
  std::vector<SparseDyadic>
      column_errors_;            // bounds of the distance of B from the doubles of the certificate
  std::vector<Sparse> defects_;  // of each cut, nonzero entries, rounded up
};

/// Checks that the nodes cover all combinations of signs. @return the fault; nothing if every
/// combination is below a node
std::optional<std::string> flaw_of_sign_cover(const LimitCertificate& certificate);

/// The nearest doubles below and above the number or equal to it; infinite if there is none.
double rounded_down(const mpq_class& value);
double rounded_up(const mpq_class& value);

}  // namespace kusabi::verify
