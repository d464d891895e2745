// InputError: message of one line, whatever bytes the input contains.
#include "support/input_error.hpp"

#include <cstddef>

#include <fmt/format.h>

namespace kusabi::support {
namespace {

/// Maximum length of quoted input, in bytes, so that two names and the advice fit on one line of
/// a terminal.
constexpr std::size_t longest_quotation = 40;

bool is_control(char character) {
  const auto byte = static_cast<unsigned char>(character);
  return byte < 0x20U || byte == 0x7FU;
}

bool continues_a_character(char character) {
  return (static_cast<unsigned char>(character) & 0xC0U) == 0x80U;
}

/// `text` without line breaks and other control characters.
std::string one_line(std::string_view text) {
  std::string line;
  for (const char character : text) {
    if (is_control(character)) {
      line += fmt::format("\\x{:02X}", static_cast<unsigned char>(character));
    } else {
      line += character;
    }
  }
  return line;
}

std::string located(std::string_view file, SourcePosition position, std::string_view message) {
  if (position.line == 0) return fmt::format("{}: {}", one_line(file), one_line(message));
  return fmt::format("{}:{}:{}: {}", one_line(file), position.line, position.column,
                     one_line(message));
}

}  // namespace

InputError::InputError(std::string_view file, SourcePosition position, std::string_view message)
    : std::runtime_error(located(file, position, message)) {}

std::string in_quotes(std::string_view text) {
  std::string_view shown = text;
  if (text.size() > longest_quotation) {
    std::size_t end = longest_quotation;
    while (end > 0 && continues_a_character(text[end])) --end;  // keeps UTF-8 characters whole
    shown = text.substr(0, end);
  }
  std::string result = "\"";
  for (const char character : shown) {
    if (character == '"' || character == '\\') result += '\\';
    result += character;
  }
  if (shown.size() < text.size()) result += "...";
  return one_line(result + "\"");
}

}  // namespace kusabi::support
