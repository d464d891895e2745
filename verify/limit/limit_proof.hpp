// Proofs of bounds of load factors of a truss in exact arithmetic. docs/theory/proofs.md
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
#include "verify/limit/limit_truss.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::verify {

/// A column of T as weight times direction, t = w d, exactly: for a single component w is its
/// absolute value and d is +1 or -1; otherwise w is 1.
struct LimitColumn {
  double weight = 1;
  Sparse direction;

  explicit LimitColumn(const Sparse& load);
};

class LimitProof {
 public:
  /// @param cuts of the nodes @pre both outlive this object
  explicit LimitProof(const LimitTruss& truss, std::span<const LimitCut> cuts = {});

  /// Upper bound of lambda_min by the kinematic principle, for a load and a motion; otherwise the
  /// reason why there is none.
  /// @pre indices are in range, numbers finite and as many as the truss needs, as below
  [[nodiscard]] std::variant<mpq_class, std::string> upper(const CollapseMotion& collapse) const;

  /// Lower bound of the factors of all admissible loads of the node; otherwise the reason why there
  /// is none.
  [[nodiscard]] std::variant<mpq_class, std::string> lower(const LimitNode& node) const;

  /// A load factor that the members of the support carry under every admissible load: forces near
  /// those of the state are in equilibrium and within the yield forces. Otherwise the reason why
  /// this is not proved. Forces of members outside the support are left out.
  /// @pre indices are in range, forces are finite
  [[nodiscard]] std::variant<mpq_class, std::string> carried(const StressState& state) const;

  /// True if the load is admissible and the motion, or its opposite, proves that no factor exists:
  /// after a correction at one displacement that makes the work of f_R zero, the work of the load
  /// exceeds the largest dissipation of the members.
  [[nodiscard]] bool shows_no_factor(const CollapseMotion& collapse) const;

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

  [[nodiscard]] std::variant<mpq_class, std::string> proved(
      const Dyadic& factor, const Stress& stress, const std::vector<bool>& stressed) const;
  [[nodiscard]] bool are_covered(const std::vector<double>& defects,
                                 const std::vector<double>& slack) const;
  [[nodiscard]] Dyadic excess(const CollapseMotion& collapse, const std::vector<Dyadic>& u) const;
  [[nodiscard]] bool is_admissible(const std::vector<double>& load) const;

  const LimitTruss& truss_;
  std::span<const LimitCut> cuts_;
  std::vector<LimitColumn> uncertain_;  // T
  std::vector<Sparse> columns_;         // B in doubles
  std::vector<Sparse> column_errors_;   // bounds of their errors; empty: there are none
  mutable std::optional<std::vector<double>> unit_forces_;  // computed when first needed
  std::vector<Sparse> defects_;  // of each cut, nonzero entries, rounded up
};

}  // namespace kusabi::verify
