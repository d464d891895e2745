// What tells one extremal ray from another: which of its coordinates are zero.
//
// In the plane the friction cone of a candidate is p >= 0, q >= 0 with
//
//   p = mu r_n - r_t,   q = mu r_n + r_t,
//
// so C_r of the paper's section 4.2 is {p >= 0, q >= 0, u_n >= 0}, 3m inequalities in 2m unknowns.
// An extremal ray is known by those that hold as equalities: no two have the same set of them. So
// rays are found, sent, compared and sorted as sets of bits; numbers are made of them at the end.
#pragma once

#include <bit>
#include <compare>
#include <cstdint>

namespace kusabi::rays {

/// A bit for each contact candidate.
using Candidates = std::uint64_t;

/// One word, unlike the sets of sign patterns: pairs of rays are compared by the billion.
inline constexpr int most_candidates = 64;

inline Candidates bit(int candidate) {
  return Candidates{1} << static_cast<unsigned>(candidate);
}

/// The candidates 0, ..., count - 1; count <= most_candidates.
inline Candidates first_candidates(int count) {
  return count >= most_candidates ? ~Candidates{0} : bit(count) - 1;
}

/// True if of the first candidate that only one of two sets has, `a` is the one: the order of a
/// dictionary in which longer words come first.
inline bool before(Candidates a, Candidates b) {
  const Candidates differing = a ^ b;
  return (a & differing & (~differing + 1)) != 0;
}

/// Where p, q and u_n are zero.
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

/// How many equalities a zero set has. Asked of every pair of rays, so the bits of the three words
/// are counted side by side: processors that this is built for need not have an instruction for it.
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

/// Which candidates do what in a configuration. `all` are the m candidates.
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

/// The order of every answer: by where there are reactions, then by what is separated, then by what
/// slides. Bits decide, so rounding cannot change it.
inline bool comes_before(const ZeroSet& a, const ZeroSet& b) {
  const auto reaction_a = ~(a.p & a.q);
  const auto reaction_b = ~(b.p & b.q);
  if (reaction_a != reaction_b) return before(reaction_a, reaction_b);
  if (a.u != b.u) return before(~a.u, ~b.u);
  if (a.p != b.p) return before(~a.p, ~b.p);
  return before(~a.q, ~b.q);
}

}  // namespace kusabi::rays
