// A name ends at the first equals sign that is followed by a number and the end of its entry, so that
// names may contain commas and equals signs.
#include "run/command/group_half_widths.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "run/output/number_in.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {

namespace {

struct HalfWidth {
  std::string name;
  double half_width;
  std::size_t end;  ///< of the entry, in the text
};

// The entry that begins at this place.
std::optional<HalfWidth> half_width_at(const std::string& text, std::size_t from) {
  for (auto equals = text.find('=', from + 1); equals != std::string::npos;
       equals = text.find('=', equals + 1)) {
    const auto end = std::min(text.find(',', equals), text.size());
    const auto value = number_in(text.substr(equals + 1, end - equals - 1));
    if (value && *value >= 0) return HalfWidth{text.substr(from, equals - from), *value, end};
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::pair<std::string, double>> group_half_widths(const std::string& text) {
  std::vector<std::pair<std::string, double>> groups;
  for (std::size_t from = 0; from < text.size();) {
    from = std::min(text.find_first_not_of(' ', from), text.size() - 1);
    auto entry = half_width_at(text, from);
    if (!entry) {
      throw WrongInput(
          fmt::format("--group-alpha '{}': expected NAME=NUMBER,NAME=NUMBER,... with numbers that "
                      "are not negative",
                      text));
    }
    groups.emplace_back(std::move(entry->name), entry->half_width);
    from = entry->end + 1;
  }
  return groups;
}

}  // namespace kusabi::run
