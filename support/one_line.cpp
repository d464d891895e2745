// Control characters of one byte, and of two in UTF-8, by the first of their bytes.
#include "support/one_line.hpp"

#include <fmt/format.h>

namespace kusabi::support {

bool is_control(std::string_view text, std::size_t place) {
  const auto byte = static_cast<unsigned char>(text[place]);
  const bool of_two = place > 0 && text[place - 1] == '\xc2' && byte >= 0x80 && byte < 0xa0;
  return byte < ' ' || byte == 0x7f || of_two;
}

std::string on_one_line(std::string_view text) {
  std::string line;
  for (std::size_t i = 0; i < text.size(); ++i)
    line += is_control(text, i) ? fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i]))
                                : std::string(1, text[i]);
  return line;
}

}  // namespace kusabi::support
