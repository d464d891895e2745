// The lines of a certificate and the words of a line, with errors that say where and what was
// expected.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "support/index_set.hpp"

namespace kusabi::verify {

/// What to show of a line that is not as it should be: not all of a long one, and nothing that a
/// terminal would obey.
std::string shown(std::string_view text);

/// The lines of a text, and in each its words.
class Lines {
 public:
  /// Both must outlive this. @param file for messages
  Lines(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  /// @throws CertificateError
  [[noreturn]] void refuse(const std::string& expected) const;

  void next();

  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] bool done() const { return rest_.empty(); }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }  ///< bytes after this line
  [[nodiscard]] std::string_view text() const { return line_; }

  /// The next word of the line, words being separated by one space; empty if there is none.
  std::string_view word();

  /// All that is left of the line.
  [[nodiscard]] std::string_view remainder() const { return words_; }

  void expect(std::string_view text);
  void expect_word(std::string_view text, const std::string& what);
  std::uint64_t integer(int base, const std::string& what);
  /// A set of candidates as a hexadecimal number, whose ones are its numbers.
  support::IndexSet set(const std::string& what);

  /// One finite number like -0x1.8p+3.
  double number(const std::string& what);

  /// The rest of the line: `count` such numbers.
  void numbers(std::size_t count, std::vector<double>& values, const std::string& what);

  /// Nothing is left of the line.
  void end_of_line(const std::string& what) const;

 private:
  std::string_view rest_;
  const std::string& file_;
  std::string_view line_;
  std::string_view words_;
  std::size_t number_ = 0;
  bool ended_ = false;
};

/// Takes the last line off and compares it with what it speaks of.
/// @throws CertificateError
std::string_view without_digest(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
