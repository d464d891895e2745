// XML escaping of UTF-8, character by character.
#include "pictures/xml_text.hpp"

#include <cstddef>
#include <cstdint>

namespace kusabi::pictures {
namespace {

// Number of bytes of the first character; 0: not a character that XML permits.
std::size_t letter_size(std::string_view text) {
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const std::uint32_t first = byte(0);
  if (first < 0x80U) {
    const bool permitted = first >= 0x20U || first == '\t' || first == '\n' || first == '\r';
    return permitted ? 1 : 0;
  }
  const std::size_t size = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
  if (first < 0xC2U || first > 0xF4U) return 0;
  std::uint32_t code = first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = code << 6U | (byte(i) & 0x3FU);
  }
  // Overlong encoding, UTF-16 surrogate, beyond the last code point, or not permitted.
  if ((size == 3 && code < 0x800U) || (size == 4 && code < 0x10000U)) return 0;
  if ((code >= 0xD800U && code < 0xE000U) || code > 0x10FFFFU) return 0;
  return code == 0xFFFEU || code == 0xFFFFU ? 0 : size;
}

// The character as written in XML.
std::string_view written(std::string_view letter) {
  if (letter == "&") return "&amp;";
  if (letter == "<") return "&lt;";
  if (letter == ">") return "&gt;";
  if (letter == "\"") return "&quot;";
  return letter;
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto size = letter_size(text);
    result += size == 0 ? "\xEF\xBF\xBD" : written(text.substr(0, size));
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return result;
}

std::string xml_comment(std::string_view text) {
  if (text.empty()) return {};
  std::string inner;
  for (const char c : xml_text(text)) {
    if (c == '-' && inner.ends_with('-')) inner += ' ';
    inner += c;
  }
  return "<!-- " + inner + " -->\n";
}

}  // namespace kusabi::pictures
