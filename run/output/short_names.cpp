// Natural order: numbers within names are compared as numbers.
#include "run/output/short_names.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "run/output/name_ranges.hpp"

namespace kusabi::run {
namespace {

// The number at the start of a text, without leading zeros.
std::string_view number_of(std::string_view text) {
  std::size_t zeros = 0;
  while (zeros + 1 < text.size() && text[zeros] == '0' && is_digit(text[zeros + 1])) ++zeros;
  std::size_t end = zeros;
  while (end < text.size() && is_digit(text[end])) ++end;
  return text.substr(zeros, end - zeros);
}

bool comes_before(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const auto first = number_of(a);
      const auto second = number_of(b);
      if (first.size() != second.size()) return first.size() < second.size();
      if (first != second) return first < second;
      a.remove_prefix(static_cast<std::size_t>(first.data() + first.size() - a.data()));
      b.remove_prefix(static_cast<std::size_t>(second.data() + second.size() - b.data()));
      continue;
    }
    if (a.front() != b.front()) return a.front() < b.front();
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  return a.size() < b.size();
}

}  // namespace

ShortNames::ShortNames(const std::vector<std::string>& candidates) {
  std::vector<std::pair<std::string, std::string>> names;  // short, full
  std::map<std::string, int> uses;
  for (const auto& full : candidates) {
    names.emplace_back(full.substr(0, full.find('|')), full);
    ++uses[names.back().first];
  }
  for (auto& [name, full] : names) {
    if (uses[name] > 1 || name.empty()) name = full;
  }
  std::ranges::stable_sort(
      names, [](const auto& a, const auto& b) { return comes_before(a.first, b.first); });
  for (auto& [name, full] : names) {
    place_[full] = order_.size();
    order_.push_back(std::move(name));
  }
}

std::vector<std::string> ShortNames::in_order(const std::vector<std::string>& names,
                                              bool others) const {
  std::vector<bool> is_in(order_.size());
  std::vector<std::string> chosen;
  for (const auto& name : names) {
    const auto place = place_.find(name);
    if (place != place_.end()) {
      is_in[place->second] = true;
    } else if (!others) {
      chosen.push_back(name);
    }
  }
  for (std::size_t i = 0; i < order_.size(); ++i) {
    if (is_in[i] != others) chosen.push_back(order_[i]);
  }
  return chosen;
}

std::string ShortNames::of(const std::vector<std::string>& names) const {
  if (names.empty()) return "none";
  if (names.size() == order_.size() && order_.size() > 1)
    return fmt::format("all {}", order_.size());
  auto direct = with_ranges(in_order(names, false));
  auto but = "all but " + with_ranges(in_order(names, true));
  return names.size() > 2 && shown_width(but) < shown_width(direct) ? but : direct;
}

std::string ShortNames::of(const std::vector<std::string>& names, std::size_t maximum) const {
  auto text = of(names);
  if (shown_width(text) <= maximum) return text;
  return fmt::format("{} of {} candidates", names.size(), order_.size());
}

}  // namespace kusabi::run
