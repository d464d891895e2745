// The proofs of a certificate of a worst-case limit load, in exact arithmetic.
// docs/theory/proofs.md derives what is checked here, with the same letters; nothing of the solver
// is used, and nothing that it says is believed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <gmpxx.h>

#include "verify/arithmetic/exact.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_reach.hpp"

namespace kusabi::verify {

/// A number within `error` of `value`.
struct Near {
  Dyadic value;
  Dyadic error;
};

/// The truss that is meant: that of a certificate, whose numbers are doubles, or that of a problem
/// file, whose directions are roots, known to a hundred digits.
struct LimitTruss {
  std::vector<std::vector<std::pair<std::size_t, Near>>> columns;  ///< B, by member
  std::vector<Near> dead;                                          ///< f_D
  std::vector<Near> reference;                                     ///< f_R
  std::vector<double> half_widths{};  ///< of its uncertain loads, in its own order
};

/// The truss as the certificate has it.
LimitTruss recorded_truss(const LimitCertificate& certificate);

class LimitProof {
 public:
  /// The certificate must outlive this.
  LimitProof(const LimitCertificate& certificate, LimitTruss truss);
  explicit LimitProof(const LimitCertificate& certificate)
      : LimitProof(certificate, recorded_truss(certificate)) {}

  /// The kinematic principle for the recorded load and motion: no smaller than lambda_min, exactly.
  /// Otherwise why it proves nothing.
  [[nodiscard]] std::variant<mpq_class, std::string> upper() const;

  /// A number that no admissible load of the node has a factor below; or why it is not shown.
  [[nodiscard]] std::variant<mpq_class, std::string> lower(const LimitNode& node) const;

  /// Whether the recorded load is within its bounds, and the recorded motion, or its opposite,
  /// shows that it is carried at no factor: made free of work of f_R at one displacement, the load
  /// does more work on it than the members can dissipate.
  [[nodiscard]] bool shows_no_factor() const;

 private:
  [[nodiscard]] std::vector<Dyadic> defect(const Sparse& forces, std::vector<Dyadic> load,
                                           double factor) const;
  [[nodiscard]] std::vector<Dyadic> still_motion(bool without_work) const;
  [[nodiscard]] bool load_is_admissible() const;

  const LimitCertificate& certificate_;
  LimitTruss truss_;
  std::vector<LimitColumn> uncertain_;       // T
  std::vector<SparseDyadic> column_errors_;  // how far B is from the doubles of the certificate
  std::vector<Sparse> defects_;              // of each cut, where it is not zero, rounded up
};

/// What is wrong with the nodes as a cover of all signs; nothing if every combination of signs is
/// below one of them.
std::optional<std::string> flaw_of_sign_cover(const LimitCertificate& certificate);

/// A double that is not above, and one that is not below; infinite if there is no other.
double rounded_down(const mpq_class& value);
double rounded_up(const mpq_class& value);

}  // namespace kusabi::verify
