// FNV-1a hash, 64 bits, least significant byte first.
#include "support/fingerprint.hpp"

#include <bit>

namespace kusabi::support {
namespace {

constexpr std::uint64_t fnv_prime = 0x100000001B3U;
constexpr int bytes_in_word = 8;

}  // namespace

void Fingerprint::add_byte(unsigned char byte) {
  hash_ ^= byte;
  hash_ *= fnv_prime;
}

void Fingerprint::add(std::uint64_t value) {
  for (int byte = 0; byte < bytes_in_word; ++byte) {
    add_byte(static_cast<unsigned char>(value & 0xFFU));
    value >>= 8U;
  }
}

void Fingerprint::add(int value) {
  add(static_cast<std::uint64_t>(value));
}

void Fingerprint::add(double value) {
  add(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value));
}

void Fingerprint::add(std::string_view text) {
  add(static_cast<std::uint64_t>(text.size()));
  for (const char character : text) add_byte(static_cast<unsigned char>(character));
}

}  // namespace kusabi::support
