// What has been proved of how much the candidates of a block take part in wedged configurations,
// and the cuts that follow: with s = sum_k r_nk
//
//   A_k u_nk + B_k r_nk <= s
//
// in every one of them, since u_nk or r_nk is zero. docs/theory/proofs.md has the same letters.
#pragma once

#include <cstddef>
#include <vector>

#include "support/index_set.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

class ProvedBounds {
 public:
  /// Of so many candidates nothing is known but r_n <= s: A = 0, B = 1.
  explicit ProvedBounds(std::size_t candidates)
      : gap_shares_(candidates), reaction_shares_(candidates, Dyadic(1.0)) {}

  /// In contact r_n <= most s, or separated u_n <= most s. @pre it is true; most > 0
  void limit(std::size_t candidate, Side side, double most);

  /// No wedged configuration has the candidate on this side. @pre it is true
  void exclude(std::size_t candidate, Side side);

  [[nodiscard]] const Dyadic& gap_share(std::size_t k) const { return gap_shares_[k]; }  ///< A_k
  /// B_k
  [[nodiscard]] const Dyadic& reaction_share(std::size_t k) const { return reaction_shares_[k]; }

  /// Those that are never separated: u_n = 0 in every wedged configuration.
  [[nodiscard]] const support::IndexSet& in_contact() const { return in_contact_; }
  /// Those that are never in contact: r = 0 likewise.
  [[nodiscard]] const support::IndexSet& separated() const { return separated_; }

 private:
  std::vector<Dyadic> gap_shares_;
  std::vector<Dyadic> reaction_shares_;
  support::IndexSet in_contact_;
  support::IndexSet separated_;
};

}  // namespace kusabi::verify
