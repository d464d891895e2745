// SHA-1 (FIPS 180-4, section 6.1), which the Unbalanced Tree Search benchmark uses as its random
// number generator: only with it do the published counts come out. Certificates end with it too, so
// that damage is noticed. It is long broken as a hash that protects from malice; nothing here uses
// it so.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace kusabi::support {

/// The 160 bits as five words; the first byte is the upper one of the first word.
using Sha1Digest = std::array<std::uint32_t, 5>;

/// The digest of a message of any length.
Sha1Digest sha1(std::string_view message);

/// The same of a message that comes in pieces.
class Sha1Stream {
 public:
  void add(std::string_view piece);
  [[nodiscard]] Sha1Digest digest() const;

 private:
  Sha1Digest chain_{0x67452301U, 0xEFCDAB89U, 0x98BADCFEU, 0x10325476U, 0xC3D2E1F0U};
  std::string rest_;         // less than a block
  std::uint64_t bytes_ = 0;  // of all pieces
};

/// A digest as 40 hexadecimal digits.
std::string hexadecimal(const Sha1Digest& digest);

namespace detail {
using Sha1Block = std::array<std::uint32_t, 16>;
/// The digest of a message of one block, padded already.
Sha1Digest sha1_of_block(const Sha1Block& block);
}  // namespace detail

/// The digest of a message of a few words, each written with its upper byte first.
template <std::size_t Count>
requires(Count <= 13)  // with its end mark and its length it fills one block
    Sha1Digest sha1(const std::array<std::uint32_t, Count>& words) {
  detail::Sha1Block block{};
  for (std::size_t place = 0; place < Count; ++place) block[place] = words[place];
  block[Count] = 0x80000000U;
  block[15] = 32 * Count;
  return detail::sha1_of_block(block);
}

}  // namespace kusabi::support
