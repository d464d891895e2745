// Texts of subcommands, from which the list of all, help, manual pages and completion are made.
#pragma once

#include <string_view>

namespace kusabi::run {

/// Progress lines of a subcommand, which its help explains.
enum class ProgressLines {
  none,
  solutions,  ///< number of solutions found
  bounds,     ///< best value, bound and gap
};

struct SubcommandText {
  std::string_view name{};         ///< in a call: one word, or a group and a word
  std::string_view chapter{};      ///< of the list of all subcommands
  std::string_view purpose{};      ///< in a few words, for lists
  std::string_view description{};  ///< in sentences; empty: none besides the purpose
  /// A call that works from the top of the source tree, without `kusabi` and the name.
  std::string_view example{};
  ProgressLines progress = ProgressLines::none;
};

}  // namespace kusabi::run
