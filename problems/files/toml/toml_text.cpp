// Texts by the formatter of the library.
#include "problems/files/toml/toml_text.hpp"

#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

namespace kusabi::problems {

std::string toml_text(const std::string& text) {
  const toml::value<std::string> value(text);
  std::ostringstream out;
  out << toml::toml_formatter(value, toml::format_flags::none);
  return out.str();
}

std::string toml_list(const std::vector<std::string>& entries) {
  constexpr std::size_t longest = 96;
  std::string text = "[";
  std::string line;
  for (const auto& entry : entries) {
    if (line.size() + entry.size() > longest) {
      text += fmt::format("\n {}", line);
      line.clear();
    }
    line += fmt::format(" {},", entry);
  }
  if (text.size() == 1) return fmt::format("[{}]", line.substr(1, line.size() - 2));
  return fmt::format("{}\n {}\n]", text, line);
}

std::string toml_texts(const std::vector<std::string>& texts) {
  std::vector<std::string> entries;
  entries.reserve(texts.size());
  for (const std::string& text : texts) entries.push_back(toml_text(text));
  return toml_list(entries);
}

}  // namespace kusabi::problems
