// A count that may be beyond any machine word: the ways of a structure are the product of those of
// its decoupled subproblems.
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

  /// Nothing if the text is anything but decimal digits, or has more than a million of them.
  static std::optional<ExactCount> read(std::string_view text);

  /// In decimal digits, all of them.
  [[nodiscard]] const std::string& digits() const { return digits_; }

  /// The number itself, if it is at most 2^53: up to there every reader of numbers has it exactly.
  [[nodiscard]] std::optional<std::uint64_t> number() const;

  /// To 15 digits; minus infinity of 0.
  [[nodiscard]] double log10() const;

  /// All digits of a number that is read at a glance; of a longer one the first five: 1.7223e+361.
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
