// Points of the grid by integer multiplication and one correctly rounded division.
#include "nodes/wedged/friction/friction_grid.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <string_view>

namespace kusabi::wedged {
namespace {

/// Larger integers and larger powers of ten are not all exact in a double.
constexpr std::int64_t max_exact = std::int64_t{1} << 53U;
constexpr int max_places = 22;

}  // namespace

FrictionGrid::FrictionGrid(double width) : width_(width) {
  // The shortest decimal of the same double, such as "1e-08" or "2.5e-07".
  std::array<char, 32> text{};
  const auto written =
      std::to_chars(text.data(), text.data() + text.size(), width, std::chars_format::scientific);
  std::int64_t numerator = 0;
  int places = 0;
  bool fraction = false;
  const char* at = text.data();
  for (; at != written.ptr && *at != 'e'; ++at) {
    if (*at == '.') {
      fraction = true;
      continue;
    }
    numerator = 10 * numerator + (*at - '0');
    if (fraction) ++places;
  }
  if (at == written.ptr) return;
  places -= std::atoi(at + 1);
  if (places < 0 || places > max_places || numerator > max_exact) return;
  numerator_ = numerator;
  for (int place = 0; place < places; ++place) denominator_ *= 10;
}

double FrictionGrid::at(std::int64_t multiple) const {
  const bool exact = numerator_ != 0 && std::abs(multiple) <= max_exact / numerator_;
  if (!exact) return width_ * static_cast<double>(multiple);
  return static_cast<double>(numerator_ * multiple) / denominator_;
}

}  // namespace kusabi::wedged
