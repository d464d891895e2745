// Proved bounds of the candidates of a block in the states of a theorem, and the cuts that follow:
// with s = sum_k r_nk + sum_j c_j tau_j, every state satisfies
//
//   A_k v_nk + B_k r_nk <= s,      v_n = u_n + g tau_dead,
//
// since v_nk or r_nk is zero. Without loads these are the wedged configurations. docs/theory/proofs.md has the same letters.
#pragma once

#include <cstddef>
#include <vector>

#include "support/index_set.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

class ProvedBounds {
 public:
  /// Initial bounds: r_n <= s for each candidate, that is A = 0, B = 1.
  explicit ProvedBounds(std::size_t candidates)
      : gap_shares_(candidates), reaction_shares_(candidates, Dyadic(1.0)) {}

  /// Sets r_n <= maximum s in contact, or v_n <= maximum s separated. @pre proved; maximum > 0
  void limit(std::size_t candidate, Side side, double maximum);

  /// Excludes this side of the candidate. @pre proved
  void exclude(std::size_t candidate, Side side);

  [[nodiscard]] const Dyadic& gap_share(std::size_t k) const { return gap_shares_[k]; }  ///< A_k
  /// B_k
  [[nodiscard]] const Dyadic& reaction_share(std::size_t k) const { return reaction_shares_[k]; }

  /// Candidates that are never separated: v_n = 0 in every state.
  [[nodiscard]] const support::IndexSet& in_contact() const { return in_contact_; }
  /// Candidates that are never in contact: r = 0 in every state.
  [[nodiscard]] const support::IndexSet& separated() const { return separated_; }

  /// True if some bound is proved only for states without large displacements.
  [[nodiscard]] bool except_large_displacements() const { return except_large_; }
  void leave_out_large_displacements() { except_large_ = true; }

 private:
  std::vector<Dyadic> gap_shares_;
  std::vector<Dyadic> reaction_shares_;
  support::IndexSet in_contact_;
  support::IndexSet separated_;
  bool except_large_ = false;
};

}  // namespace kusabi::verify
