// SHA-1: compression function and padding.
#include "support/sha1.hpp"

#include <bit>
#include <string>

namespace kusabi::support {
namespace {

using detail::Sha1Block;

constexpr Sha1Digest initial{0x67452301U, 0xEFCDAB89U, 0x98BADCFEU, 0x10325476U, 0xC3D2E1F0U};

constexpr std::uint32_t choose(std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return d ^ (b & (c ^ d));
}
constexpr std::uint32_t parity(std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return b ^ c ^ d;
}
constexpr std::uint32_t majority(std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return (b & c) | (d & (b | c));
}

// One round. Instead of rotating the five words, each round is called with rotated names.
template <auto Function>
inline void round(std::uint32_t a, std::uint32_t& b, std::uint32_t c, std::uint32_t d,
                  std::uint32_t& e, std::uint32_t addend) {
  e += std::rotl(a, 5) + Function(b, c, d) + addend;
  b = std::rotl(b, 30);
}

// Rounds `From` to `From` + 19, unrolled: most of the schedule and the words stay in registers,
// which is three to four times as fast.
template <std::size_t From, auto Function, std::uint32_t Constant>
inline void rounds(Sha1Digest& words, Sha1Block& schedule) {
  auto& [a, b, c, d, e] = words;
  // Each of the schedule's words 16 to 79 replaces the word 16 before it.
  const auto addend = [&](std::size_t t) {
    auto& word = schedule[t % 16];
    if (t >= 16) {
      word ^= schedule[(t - 3) % 16] ^ schedule[(t - 8) % 16] ^ schedule[(t - 14) % 16];
      word = std::rotl(word, 1);
    }
    return word + Constant;
  };
#pragma GCC unroll 4
  for (std::size_t t = From; t < From + 20; t += 5) {
    round<Function>(a, b, c, d, e, addend(t));
    round<Function>(e, a, b, c, d, addend(t + 1));
    round<Function>(d, e, a, b, c, addend(t + 2));
    round<Function>(c, d, e, a, b, addend(t + 3));
    round<Function>(b, c, d, e, a, addend(t + 4));
  }
}

// Updates the chaining value by one block.
inline void compress(Sha1Digest& chain, const Sha1Block& block) {
  Sha1Block schedule = block;  // a private copy, which the compiler can keep in registers
  auto words = chain;
  rounds<0, choose, 0x5A827999U>(words, schedule);
  rounds<20, parity, 0x6ED9EBA1U>(words, schedule);
  rounds<40, majority, 0x8F1BBCDCU>(words, schedule);
  rounds<60, parity, 0xCA62C1D6U>(words, schedule);
  for (std::size_t i = 0; i < chain.size(); ++i) chain[i] += words[i];
}

constexpr std::size_t block_bytes = 64;

// First 64 bytes of a text.
Sha1Block block_of(std::string_view text) {
  Sha1Block block{};
  for (std::size_t i = 0; i < block_bytes; ++i) {
    block[i / 4] = (block[i / 4] << 8U) | static_cast<unsigned char>(text[i]);
  }
  return block;
}

}  // namespace

Sha1Digest detail::sha1_of_block(const Sha1Block& block) {
  auto digest = initial;
  compress(digest, block);
  return digest;
}

Sha1Digest sha1(std::string_view message) {
  Sha1Stream stream;
  stream.add(message);
  return stream.digest();
}

void Sha1Stream::add(std::string_view piece) {
  bytes_ += piece.size();
  if (!rest_.empty()) {
    const auto missing = piece.substr(0, block_bytes - rest_.size());
    rest_ += missing;
    piece.remove_prefix(missing.size());
    if (rest_.size() < block_bytes) return;
    compress(chain_, block_of(rest_));
    rest_.clear();
  }
  for (; piece.size() >= block_bytes; piece.remove_prefix(block_bytes)) {
    compress(chain_, block_of(piece));
  }
  rest_ = piece;
}

Sha1Digest Sha1Stream::digest() const {
  constexpr std::size_t length_bytes = 8;
  // A one bit, then zeros, then the length in bits at the end of a block.
  std::string padded = rest_ + '\x80';
  while (padded.size() % block_bytes != block_bytes - length_bytes) padded += '\0';
  const auto bits = 8 * bytes_;
  for (unsigned shift = 64; shift > 0; shift -= 8) {
    padded += static_cast<char>((bits >> (shift - 8)) & 0xFFU);
  }
  auto digest = chain_;
  for (std::string_view left = padded; !left.empty(); left.remove_prefix(block_bytes)) {
    compress(digest, block_of(left));
  }
  return digest;
}

std::string hexadecimal(const Sha1Digest& digest) {
  std::string text;
  for (const auto word : digest) {
    for (unsigned shift = 32; shift > 0; shift -= 4) {
      text += "0123456789abcdef"[(word >> (shift - 4)) & 0xFU];
    }
  }
  return text;
}

}  // namespace kusabi::support
