// The lines of an MPS file, split into fields: at blanks (free MPS), or at the columns of the old
// punched cards (fixed MPS, where a name may have blanks).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kusabi::linear {

enum class MpsLayout { free, fixed };

/// What the line belongs to says how many fields it has.
enum class MpsSection { none, sense, objective_name, rows, columns, rhs, ranges, bounds, end };

/// One line with something on it.
struct MpsLine {
  std::size_t number = 0;  ///< counted from 1
  bool header = false;     ///< it begins a section
  /// In free MPS (and of a header): the words. In fixed MPS: the six fields, empty where blank.
  std::vector<std::string_view> fields;
  std::string_view text;  ///< without blanks at its ends
};

/// Lines that are blank or a comment are left out, and so is a byte order mark.
class MpsLines {
 public:
  MpsLines(std::string_view text, MpsLayout layout);

  /// False at the end.
  bool next(MpsLine& line);
  /// The number of the last line read.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Whether the last line has something where fixed MPS has gaps.
  [[nodiscard]] bool off_the_columns() const { return off_the_columns_; }

 private:
  std::string_view rest_;
  MpsLayout layout_;
  std::size_t number_ = 0;
  bool off_the_columns_ = false;
};

/// `word` in capitals.
std::string capitals(std::string_view word);

}  // namespace kusabi::linear
