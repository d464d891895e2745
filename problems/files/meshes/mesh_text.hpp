// Text of a mesh file by lines and fields; errors have file, line and column.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/input_error.hpp"

namespace kusabi::problems {

/// Largest number of a node, an element or a group.
inline constexpr int largest_tag = std::numeric_limits<int>::max();

class MeshText {
 public:
  /// @param separators between fields; blanks are always removed
  MeshText(std::string_view text, std::string file, std::string_view separators);

  /// Goes to the next line and splits it into fields. @return false at the end of the text
  bool next_line();
  /// Returns the line to the text: the next `next_line` reads it again.
  void put_back() { put_back_ = true; }

  std::string_view line() const { return line_; }
  int number() const { return has_lines_ ? number_ : 0; }
  /// Omits line numbers in errors from now on, for converted texts whose lines are not in the file.
  void leave_out_lines() { has_lines_ = false; }
  const std::string& file() const { return file_; }

  std::size_t fields() const { return fields_.size(); }
  std::string_view field(std::size_t index) const { return fields_[index]; }

  /// An integer from `minimum` to `largest_tag`.
  int whole(std::size_t index, std::string_view called, int minimum) const;
  /// A finite number.
  double real(std::size_t index, std::string_view called) const;

  /// @throws InputError at field `index`, or at the end of the line if it has fewer
  [[noreturn]] void fail(std::size_t index, std::string_view message) const;
  /// @throws InputError on the whole line
  [[noreturn]] void fail(std::string_view message) const;

 private:
  void split();
  support::SourcePosition position(int column) const;

  std::string_view text_;
  std::string file_;
  std::string_view separators_;
  std::size_t at_ = 0;
  std::string_view line_;
  int number_ = 0;
  bool put_back_ = false;
  bool has_lines_ = true;
  std::vector<std::string_view> fields_;
};

/// The whole of a text as a finite number; nothing if it is none.
std::optional<double> number_in(std::string_view text);

/// The text without leading and trailing blanks.
std::string_view trimmed(std::string_view text);

}  // namespace kusabi::problems
