// Sets J0 and J1 of Algorithm 4.2 of the limit paper: the binaries fixed at 0 and at 1. Bit sets
// over any number of binaries, in the order of MixedProgram::binaries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <boost/serialization/vector.hpp>

namespace kusabi::zero_one {

class Fixings {
 public:
  Fixings() = default;
  explicit Fixings(std::size_t binaries)
      : zero_((binaries + word - 1) / word), one_(zero_.size()) {}

  [[nodiscard]] bool at_zero(std::size_t k) const { return has(zero_, k); }
  [[nodiscard]] bool at_one(std::size_t k) const { return has(one_, k); }
  [[nodiscard]] bool free(std::size_t k) const { return !at_zero(k) && !at_one(k); }

  /// @pre free(k)
  void fix(std::size_t k, bool at_one) { (at_one ? one_ : zero_)[k / word] |= bit(k); }

  friend bool operator==(const Fixings&, const Fixings&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& zero_& one_;
  }

 private:
  using Words = std::vector<std::uint64_t>;
  static constexpr std::size_t word = 64;

  static std::uint64_t bit(std::size_t k) { return std::uint64_t{1} << (k % word); }
  static bool has(const Words& words, std::size_t k) { return (words[k / word] & bit(k)) != 0; }

  Words zero_;
  Words one_;
};

}  // namespace kusabi::zero_one
