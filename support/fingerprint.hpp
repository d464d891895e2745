// Fingerprint: 64-bit hash that identifies a problem; a checkpoint or a result of another problem
// is refused by it. FNV-1a over bytes in a fixed order, hence the same on every machine.
#pragma once

#include <cstdint>
#include <string_view>

namespace kusabi::support {

/// Accumulates values in sequence.
class Fingerprint {
 public:
  void add(std::uint64_t value);
  void add(int value);
  /// Adds the bits of the number; -0 counts as 0.
  void add(double value);
  /// Adds the length first, so that "a", "bc" differs from "ab", "c".
  void add(std::string_view text);

  std::uint64_t value() const { return hash_; }

 private:
  void add_byte(unsigned char byte);

  std::uint64_t hash_ = 0xCBF29CE484222325U;  // offset basis of FNV-1a, 64 bits
};

}  // namespace kusabi::support
