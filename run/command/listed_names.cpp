// Names are compared with the beginning of what is left of the text.
#include "run/command/listed_names.hpp"

#include <algorithm>

namespace kusabi::run {
namespace {

constexpr std::string_view separators = ", ";

void skip_separators(std::string_view& text) {
  text.remove_prefix(std::min(text.size(), text.find_first_not_of(separators)));
}

}  // namespace

ListedNames names_in_list(std::string_view text, std::span<const std::string> known) {
  ListedNames names;
  const auto begins = [&](const std::string& name) {
    return !name.empty() && text.starts_with(name) &&
           (text.size() == name.size() ||
            separators.find(text[name.size()]) != std::string_view::npos);
  };
  const auto whole = text;
  for (bool first = true; !text.empty(); first = false) {
    // A name may begin with a blank.
    if (!first || std::ranges::none_of(known, begins)) skip_separators(text);
    if (text.empty()) break;
    auto longest = known.size();
    for (std::size_t i = 0; i < known.size(); ++i) {
      const bool longer = longest == known.size() || known[i].size() > known[longest].size();
      if (longer && begins(known[i])) longest = i;
    }
    if (longest == known.size()) {
      names.unknown = text.substr(0, text.find_first_of(separators));
      return names;
    }
    names.found.push_back(longest);
    text.remove_prefix(known[longest].size());
  }
  if (names.found.empty()) names.unknown = whole;
  return names;
}

}  // namespace kusabi::run
