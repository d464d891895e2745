// IndexSet as hexadecimal text, of any length.
#include "support/index_set.hpp"

#include <iterator>

#include <fmt/format.h>

namespace kusabi::support {

std::string hexadecimal(const IndexSet& set) {
  std::string text;
  auto out = std::back_inserter(text);
  const auto last = set.words() - 1;
  fmt::format_to(out, "{:x}", set.word(last));
  for (std::size_t k = last; k-- > 0;) fmt::format_to(out, "{:016x}", set.word(k));
  return text;
}

}  // namespace kusabi::support
