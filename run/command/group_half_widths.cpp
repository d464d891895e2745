// Text is split at commas, and at the last equals sign.
#include "run/command/group_half_widths.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "run/output/number_in.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {

std::vector<std::pair<std::string, double>> group_half_widths(const std::string& text) {
  std::vector<std::pair<std::string, double>> groups;
  for (std::size_t from = 0; from < text.size();) {
    const auto to = std::min(text.find(',', from), text.size());
    const auto part = text.substr(from, to - from);
    const auto equals = std::min(part.rfind('='), part.size());
    const auto value = number_in(part.substr(std::min(equals + 1, part.size())));
    if (equals == 0 || !value || *value < 0) {
      throw WrongInput(
          fmt::format("--group-alpha '{}': expected NAME=NUMBER,NAME=NUMBER,... with numbers that "
                      "are not negative",
                      text));
    }
    groups.emplace_back(part.substr(0, equals), *value);
    from = to + 1;
  }
  return groups;
}

}  // namespace kusabi::run
