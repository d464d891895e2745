// SHA-1 (FIPS 180-4, section 6.1). The Unbalanced Tree Search benchmark uses it as its random
// number generator; certificates end with it as a checksum. It is not secure against deliberate
// collisions and is not used for that.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace kusabi::support {

/// The 160 bits as five words; the first byte is the most significant one of the first word.
using Sha1Digest = std::array<std::uint32_t, 5>;

/// Digest of a message of any length.
Sha1Digest sha1(std::string_view message);

/// Digest of a message given in pieces.
class Sha1Stream {
 public:
  void add(std::string_view piece);
  [[nodiscard]] Sha1Digest digest() const;

 private:
  Sha1Digest chain_{0x67452301U, 0xEFCDAB89U, 0x98BADCFEU, 0x10325476U, 0xC3D2E1F0U};
  std::string rest_;         // incomplete block
  std::uint64_t bytes_ = 0;  // total length
};

/// A digest as 40 hexadecimal digits.
std::string hexadecimal(const Sha1Digest& digest);

namespace detail {
using Sha1Block = std::array<std::uint32_t, 16>;
/// Digest of a message of one padded block.
Sha1Digest sha1_of_block(const Sha1Block& block);
}  // namespace detail

/// Digest of a message of a few words, each with its most significant byte first.
template <std::size_t Count>
requires(Count <= 13)  // fits into one block with end mark and length
    Sha1Digest sha1(const std::array<std::uint32_t, Count>& words) {
  detail::Sha1Block block{};
  for (std::size_t place = 0; place < Count; ++place) block[place] = words[place];
  block[Count] = 0x80000000U;
  block[15] = 32 * Count;
  return detail::sha1_of_block(block);
}

}  // namespace kusabi::support
