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

namespace kusabi::verify {

/// How far the numbers of a certificate may be from those of the truss that they are the roundings
/// of. Empty lists: they are the truss's own.
struct LimitErrors {
  std::vector<Dyadic> columns;    ///< of B, by member: the sum over its entries
  std::vector<Dyadic> dead;       ///< f_D, by displacement
  std::vector<Dyadic> reference;  ///< f_R
};

class LimitProof {
 public:
  /// Begins with the bound of motions by elongations. The certificate must outlive this.
  /// @param errors what is shown is shown for every truss within them
  explicit LimitProof(const LimitCertificate& certificate, LimitErrors errors = {});

  /// Whether a motion is bounded by the elongations it makes, which shows that the truss is no
  /// mechanism. If not, no lower end can be shown.
  [[nodiscard]] bool stable() const { return !reach_.empty(); }

  /// The kinematic principle for the recorded load and motion: no smaller than lambda_min, exactly.
  /// Otherwise why it proves nothing.
  [[nodiscard]] std::variant<mpq_class, std::string> upper() const;

  /// A number that no admissible load of the node has a factor below; or why it is not shown.
  /// @pre stable()
  [[nodiscard]] std::variant<mpq_class, std::string> lower(const LimitNode& node) const;

 private:
  void bound_motions();
  [[nodiscard]] Dyadic defect(const Sparse& forces, std::vector<Dyadic> load) const;
  [[nodiscard]] Dyadic column_error(std::size_t member) const;

  const LimitCertificate& certificate_;
  LimitErrors errors_;
  Dyadic dead_error_;            // in all, |f_D|_1
  Dyadic reference_error_;       // |f_R|_1
  std::vector<Dyadic> reach_;    // kappa: the largest |u_e| is at most the sum of kappa_i |b_i'u|
  std::vector<Dyadic> defects_;  // |rho_c|_1 of each cut
};

/// What is wrong with the nodes as a cover of all signs; nothing if every combination of signs is
/// below one of them.
std::optional<std::string> flaw_of_sign_cover(const LimitCertificate& certificate);

/// A double that is not above, and one that is not below; infinite if there is no other.
double rounded_down(const mpq_class& value);
double rounded_up(const mpq_class& value);

}  // namespace kusabi::verify
