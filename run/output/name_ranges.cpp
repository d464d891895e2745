// A range of names is determined by its first two.
#include "run/output/name_ranges.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace kusabi::run {
namespace {

constexpr std::size_t min_names = 3;

// A name split at one of its numbers.
struct Numbered {
  std::string_view before;
  long number = 0;
  std::string_view after;

  [[nodiscard]] bool precedes(std::string_view name) const {
    return name == fmt::format("{}{}{}", before, number + 1, after);
  }
};

// The split at which `next` counts up from `name`, if there is one. Numbers with leading zeros are
// not counted.
std::optional<Numbered> counted_up(std::string_view name, std::string_view next) {
  for (std::size_t at = 0; at < name.size();) {
    if (!is_digit(name[at])) {
      ++at;
      continue;
    }
    const auto end = static_cast<std::size_t>(
        std::find_if_not(name.begin() + static_cast<std::ptrdiff_t>(at), name.end(), is_digit) -
        name.begin());
    Numbered cut{.before = name.substr(0, at), .after = name.substr(end)};
    const auto read = std::from_chars(name.data() + at, name.data() + end, cut.number);
    const bool plain = name[at] != '0' || end == at + 1;
    if (read.ec == std::errc() && plain && cut.precedes(next)) return cut;
    at = end;
  }
  return std::nullopt;
}

}  // namespace

std::string with_ranges(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t at = 0; at < names.size();) {
    std::size_t count = 1;
    std::optional<Numbered> cut;
    if (at + 1 < names.size()) cut = counted_up(names[at], names[at + 1]);
    for (auto last = cut; last && at + count < names.size() && last->precedes(names[at + count]);
         ++count) {
      ++last->number;
    }
    if (!text.empty()) text += ' ';
    if (count < min_names) {
      text += names[at++];
      continue;
    }
    text += fmt::format("{}{}…{}{}", cut->before, cut->number,
                        cut->number + static_cast<long>(count) - 1, cut->after);
    at += count;
  }
  return text.empty() ? "-" : text;
}

std::size_t shown_width(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace kusabi::run
