// MpsLines: the lines of an MPS file, split into fields at blanks (free MPS), or at the columns of
// punched cards (fixed MPS, where a name may contain blanks).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kusabi::linear {

enum class MpsLayout { free, fixed };

/// Section of a line, which determines its fields.
enum class MpsSection { none, sense, objective_name, rows, columns, rhs, ranges, bounds, end };

/// One line that is not empty.
struct MpsLine {
  std::size_t number = 0;  ///< counted from 1
  bool header = false;     ///< true if it begins a section
  /// Free MPS, and headers: the words. Fixed MPS: the six fields, empty where blank.
  std::vector<std::string_view> fields;
  std::string_view text;  ///< without leading and trailing blanks
};

/// Reads the lines; skips blank lines, comments and a byte order mark.
class MpsLines {
 public:
  MpsLines(std::string_view text, MpsLayout layout);

  /// False at the end.
  bool next(MpsLine& line);
  /// Number of the last line read.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// True if the last line has text where fixed MPS has gaps.
  [[nodiscard]] bool off_the_columns() const { return off_the_columns_; }

 private:
  std::string_view rest_;
  MpsLayout layout_;
  std::size_t number_ = 0;
  bool off_the_columns_ = false;
};

/// `word` in upper case.
std::string capitals(std::string_view word);

}  // namespace kusabi::linear
