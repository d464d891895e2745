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
#include "verify/limit/limit_truss.hpp"
#include "verify/limit/stress_state.hpp"

namespace kusabi::verify {

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

  /// A load factor that the members of the support carry under every admissible load: forces near
  /// those of the state are in equilibrium and within the yield forces. Otherwise the reason why
  /// this is not proved. Forces of members outside the support are left out.
  /// @pre indices are in range, forces are finite
  [[nodiscard]] std::variant<mpq_class, std::string> carried(const StressState& state) const;

  /// True if the recorded load is admissible and the recorded motion, or its opposite, proves that
  /// no factor exists: after a correction at one displacement that makes the work of f_R zero, the
  /// work of the load exceeds the largest dissipation of the members.
  [[nodiscard]] bool shows_no_factor() const;

 private:
  [[nodiscard]] Sparse defect_of(const LimitCut& cut, std::span<const EnclosedSum> sums) const;
  [[nodiscard]] Sparse exact_defect_of(const LimitCut& cut) const;
  [[nodiscard]] std::vector<Dyadic> defect(const Sparse& forces, std::vector<Dyadic> load,
                                           double factor) const;
  struct Stress {
    std::vector<double> forces;   ///< q, by member
    std::vector<Dyadic> taken;    ///< part of the yield forces that is not available, by member
    std::vector<Dyadic> defects;  ///< bounds of the equilibrium errors, by displacement
  };

  [[nodiscard]] std::variant<std::vector<double>, std::string> slack_of(const Stress& stress) const;
  [[nodiscard]] std::optional<std::string> yielding(const std::vector<double>& slack,
                                                    const std::vector<Dyadic>& defects) const;
  [[nodiscard]] bool are_covered(const std::vector<double>& defects,
                                 const std::vector<double>& slack) const;
  [[nodiscard]] bool load_is_admissible() const;
  [[nodiscard]] std::string name_of(std::size_t member) const;

  const LimitCertificate& certificate_;
  LimitTruss truss_;
  std::vector<LimitColumn> uncertain_;  // T
  // Bounds of the distance of B from the doubles of the certificate.
  std::vector<Sparse> column_errors_;
  mutable std::optional<std::vector<double>> unit_forces_;  // computed when first needed
  std::vector<Sparse> defects_;  // of each cut, nonzero entries, rounded up
};

}  // namespace kusabi::verify
