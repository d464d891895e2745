// Page: width and colours of the output, and the text of a verdict on it. Files and pipes have unlimited width and no colours, since
// programs that read them expect one line per pattern.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "answer/verdict.hpp"

namespace kusabi::run {

struct Page {
  static constexpr std::size_t endless = static_cast<std::size_t>(-1);

  std::size_t width = endless;  ///< characters per line
  bool colours = false;

  /// Bold: the answer.
  [[nodiscard]] std::string strong(std::string_view text) const;
  /// Yellow: open, not proved or stopped.
  [[nodiscard]] std::string warning(std::string_view text) const;
};

/// Page of a descriptor. The width of a terminal is COLUMNS if set, otherwise its own, otherwise
/// 80. Colours are off if NO_COLOR is not empty (no-color.org) or TERM is `dumb`.
Page page_of(int descriptor);

/// Text folded to `width` where spaces allow it. Continuations are indented to the beginning of the
/// last column (text after two or more spaces), or of the line.
std::string folded(std::string_view text, std::size_t width);

/// Last lines of a table; empty if there is neither an answer nor a warning.
std::string conclusion_text(const answer::Verdict& verdict, const Page& page);

}  // namespace kusabi::run
