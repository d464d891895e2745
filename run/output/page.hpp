// What text is printed on: how wide it is, and whether it shows colours.
//
// A file and a pipe are endless and have no colours, whatever the environment says: what reads
// them counts on a line a pattern.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kusabi::run {

struct Page {
  static constexpr std::size_t endless = static_cast<std::size_t>(-1);

  std::size_t width = endless;  ///< so many characters in a line
  bool colours = false;

  /// The answer: bold.
  [[nodiscard]] std::string strong(std::string_view text) const;
  /// What is open, not proved or was stopped: yellow.
  [[nodiscard]] std::string doubtful(std::string_view text) const;
};

/// The page behind a descriptor. A terminal is as wide as COLUMNS says, if it is set, else as it
/// says itself, else 80; it has colours unless NO_COLOR is set to anything (no-color.org) or TERM
/// is `dumb`.
Page page_of(int descriptor);

/// Text whose lines are no longer than `width` where words allow it: longer ones are broken at
/// spaces, and go on below the beginning of their last column (what follows two spaces or more), or
/// of the line itself.
std::string folded(std::string_view text, std::size_t width);

}  // namespace kusabi::run
