// Values in the notation of TOML.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace kusabi::problems {

/// Maximum length of a name, in bytes. Names are column headings of results.
inline constexpr std::size_t longest_text = 64;

/// True for the control characters of ASCII, which names may not contain.
inline bool is_control(char character) {
  const auto byte = static_cast<unsigned char>(character);
  return byte < 0x20U || byte == 0x7FU;
}

/// The text in quotes.
std::string toml_text(const std::string& text);

/// An array of `entries`, which are values, on lines of a readable length.
std::string toml_list(const std::vector<std::string>& entries);

/// An array of texts.
std::string toml_texts(const std::vector<std::string>& texts);

}  // namespace kusabi::problems
