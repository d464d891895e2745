// Products by Boost.Multiprecision; a count is stored as its decimal digits.
#include "support/exact_count.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>

namespace kusabi::support {
namespace {

// Conversion by 18 digits at a time, since GCC 12 gives a false warning about str().
std::string decimal(boost::multiprecision::cpp_int value) {
  constexpr std::uint64_t part = 1'000'000'000'000'000'000;
  std::string digits;
  for (; value >= part; value /= part)
    digits.insert(0, fmt::format("{:018}", static_cast<std::uint64_t>(value % part)));
  return std::to_string(static_cast<std::uint64_t>(value)) + digits;
}

}  // namespace

ExactCount ExactCount::product(std::span<const std::uint64_t> factors) {
  boost::multiprecision::cpp_int product = 1;
  for (const auto factor : factors) product *= factor;
  return ExactCount(decimal(std::move(product)));
}

std::optional<ExactCount> ExactCount::read(std::string_view text) {
  constexpr std::size_t max_digits = 1'000'000;
  if (text.empty() || text.size() > max_digits ||
      text.find_first_not_of("0123456789") != std::string_view::npos)
    return {};
  const auto first = text.find_first_not_of('0');
  return ExactCount(std::string(first == std::string_view::npos ? "0" : text.substr(first)));
}

std::optional<std::uint64_t> ExactCount::number() const {
  constexpr std::uint64_t maximum = std::uint64_t{1} << 53U;
  std::uint64_t number = 0;
  const auto* const end = digits_.data() + digits_.size();
  if (std::from_chars(digits_.data(), end, number).ec != std::errc() || number > maximum) return {};
  return number;
}

double ExactCount::log10() const {
  constexpr std::size_t enough = 18;
  const auto size = std::min(digits_.size(), enough);
  std::uint64_t first = 0;
  std::from_chars(digits_.data(), digits_.data() + size, first);
  return std::log10(static_cast<double>(first)) + static_cast<double>(digits_.size() - size);
}

std::string ExactCount::text() const {
  constexpr std::size_t max_readable_digits = 21;
  if (digits_.size() <= max_readable_digits) return digits_;
  return fmt::format("{}.{}e+{}", digits_.front(), digits_.substr(1, 4), digits_.size() - 1);
}

}  // namespace kusabi::support
