// ZeroSet: the zero coordinates of an extremal ray, which identify it.
//
// In the plane the friction cone of a candidate is p >= 0, q >= 0 with
//
//   p = mu r_n - r_t,   q = mu r_n + r_t,
//
// so C_r of section 4.2 of the wedged paper is {p >= 0, q >= 0, u_n >= 0}, 3m inequalities in 2m
// unknowns. An extremal ray is determined by those that hold as equalities: no two rays have the
// same set. Rays are found, sent, compared and sorted as sets of bits; coordinates are computed at
// the end.
#pragma once

#include <bit>
#include <compare>
#include <cstdint>

namespace kusabi::rays {

/// One bit per contact candidate.
using Candidates = std::uint64_t;

/// One word, unlike the sets of sign patterns: billions of pairs of rays are compared.
inline constexpr int max_candidates = 64;

inline Candidates bit(int candidate) {
  return Candidates{1} << static_cast<unsigned>(candidate);
}

/// The candidates 0, ..., count - 1; count <= max_candidates.
inline Candidates first_candidates(int count) {
  return count >= max_candidates ? ~Candidates{0} : bit(count) - 1;
}

/// True if `a` has the lowest candidate that is in only one of the two sets: lexicographic order,
/// in which longer words come first.
inline bool before(Candidates a, Candidates b) {
  const Candidates differing = a ^ b;
  return (a & differing & (~differing + 1)) != 0;
}

/// Candidates at which p, q and u_n are zero.
struct ZeroSet {
  Candidates p = 0;
  Candidates q = 0;
  Candidates u = 0;

  friend bool operator==(const ZeroSet&, const ZeroSet&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& p& q& u;
  }
};

/// Number of equalities of a zero set. It is needed for every pair of rays, so the bits of the
/// three words are counted together, without a popcount instruction, which the target processor may
/// lack.
inline int size(const ZeroSet& zero) {
  constexpr auto every = [](std::uint64_t byte) { return byte * 0x0101010101010101U; };
  const auto in_nibbles = [&](std::uint64_t word) {
    word -= (word >> 1U) & every(0x55);
    return (word & every(0x33)) + ((word >> 2U) & every(0x33));
  };
  const auto sums = in_nibbles(zero.p) + in_nibbles(zero.q) + in_nibbles(zero.u);  // up to 12 each
  const auto in_bytes = (sums & every(0x0f)) + ((sums >> 4U) & every(0x0f));
  return static_cast<int>((in_bytes * every(1)) >> 56U);
}

/// Candidates by their state in a configuration. `all` are the m candidates.
class Supports {
 public:
  Supports(const ZeroSet& zero, Candidates all)
      : reaction_(all & ~(zero.p & zero.q)),
        separated_(all & ~zero.u),
        up_(reaction_ & zero.p),
        down_(reaction_ & zero.q),
        all_(all) {}

  Candidates reaction() const { return reaction_; }                     ///< r_n > 0
  Candidates separated() const { return separated_; }                   ///< u_n > 0
  Candidates sticking() const { return reaction_ & ~(up_ | down_); }    ///< |r_t| < mu r_n
  Candidates sliding_up() const { return up_; }                         ///< r_t = mu r_n
  Candidates sliding_down() const { return down_; }                     ///< r_t = -mu r_n
  Candidates idle() const { return all_ & ~(reaction_ | separated_); }  ///< u_n = r_n = 0

 private:
  Candidates reaction_, separated_, up_, down_, all_;
};

/// Order of all results: by reactions, then by separated candidates, then by sliding. It depends on
/// bits only, so rounding cannot change it.
inline bool comes_before(const ZeroSet& a, const ZeroSet& b) {
  const auto reaction_a = ~(a.p & a.q);
  const auto reaction_b = ~(b.p & b.q);
  if (reaction_a != reaction_b) return before(reaction_a, reaction_b);
  if (a.u != b.u) return before(~a.u, ~b.u);
  if (a.p != b.p) return before(~a.p, ~b.p);
  return before(~a.q, ~b.q);
}

}  // namespace kusabi::rays
