// ExactCount: a count of any size. The number of patterns of a structure is the product of those of
// its decoupled subproblems, which may exceed every integer type.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

namespace kusabi::support {

/// A whole number, not negative, of any size.
class ExactCount {
 public:
  ExactCount(std::uint64_t count = 0) : digits_(std::to_string(count)) {}

  /// 1 if there are no factors.
  static ExactCount product(std::span<const std::uint64_t> factors);

  /// Nothing if the text has other characters than decimal digits, or more than a million of them.
  static std::optional<ExactCount> read(std::string_view text);

  /// All decimal digits.
  [[nodiscard]] const std::string& digits() const { return digits_; }

  /// The number if it is at most 2^53, up to which every JSON reader represents it exactly.
  [[nodiscard]] std::optional<std::uint64_t> number() const;

  /// Decimal logarithm to 15 digits; minus infinity for 0.
  [[nodiscard]] double log10() const;

  /// All digits if there are at most 21, otherwise the first five: 1.7223e+361.
  [[nodiscard]] std::string text() const;

  friend bool operator==(const ExactCount&, const ExactCount&) = default;
  friend std::ostream& operator<<(std::ostream& out, const ExactCount& count) {
    return out << count.digits_;
  }

 private:
  explicit ExactCount(std::string digits) : digits_(std::move(digits)) {}

  std::string digits_;
};

}  // namespace kusabi::support
