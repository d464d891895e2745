// The proofs of a certificate of a worst-case limit load, in exact arithmetic. docs/theory.md,
// section 8, derives what is checked here, with the same letters; nothing of the solver is used,
// and nothing that it says is believed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <gmpxx.h>

#include "verify/exact.hpp"
#include "verify/limit_certificate.hpp"
#include "verify/limit_reach.hpp"

namespace kusabi::verify {

/// How far the numbers of a certificate may be from those of the truss that they are the roundings
/// of. Empty lists: they are the truss's own.
struct LimitErrors {
  std::vector<SparseError> columns;  ///< of B, by member
  std::vector<Dyadic> dead;          ///< f_D, by displacement
  std::vector<Dyadic> reference;     ///< f_R
};

class LimitProof {
 public:
  /// The certificate must outlive this.
  /// @param errors what is shown is shown for every truss within them
  explicit LimitProof(const LimitCertificate& certificate, LimitErrors errors = {});

  /// The kinematic principle for the recorded load and motion: no smaller than lambda_min, exactly.
  /// Otherwise why it proves nothing.
  [[nodiscard]] std::variant<mpq_class, std::string> upper() const;

  /// A number that no admissible load of the node has a factor below; or why it is not shown.
  [[nodiscard]] std::variant<mpq_class, std::string> lower(const LimitNode& node) const;

  /// Whether the recorded motion, or its opposite, shows that the recorded load is carried at no
  /// factor: made free of work of f_R at one displacement, the load does more work on it than the
  /// members can dissipate. @pre no errors
  [[nodiscard]] bool shows_no_factor() const;

 private:
  [[nodiscard]] std::vector<Dyadic> defect(const Sparse& forces, std::vector<Dyadic> load,
                                           double factor) const;

  const LimitCertificate& certificate_;
  LimitErrors errors_;
  std::vector<Sparse> defects_;  // of each cut, where it is not zero, rounded up
};

/// What is wrong with the nodes as a cover of all signs; nothing if every combination of signs is
/// below one of them.
std::optional<std::string> flaw_of_sign_cover(const LimitCertificate& certificate);

/// A double that is not above, and one that is not below; infinite if there is no other.
double rounded_down(const mpq_class& value);
double rounded_up(const mpq_class& value);

}  // namespace kusabi::verify
