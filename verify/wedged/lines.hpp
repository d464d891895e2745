// Lines of a certificate and words of a line, with errors that state the place and the expected
// text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "support/index_set.hpp"

namespace kusabi::verify {

/// The beginning of a faulty line for messages, without control characters.
std::string shown(std::string_view text);

/// The lines of a text and their words.
class Lines {
 public:
  /// @pre text and file outlive this object @param file for messages
  Lines(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  /// @throws CertificateError
  [[noreturn]] void refuse(const std::string& expected) const;

  void next();

  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] bool done() const { return rest_.empty(); }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }  ///< bytes after this line
  [[nodiscard]] std::string_view text() const { return line_; }

  /// The next word of the line, separated by one space; empty if there is none.
  std::string_view word();

  /// The unread rest of the line.
  [[nodiscard]] std::string_view remainder() const { return words_; }

  /// The same as a name, which has no control characters: names are printed.
  [[nodiscard]] std::string_view name() const;

  void expect(std::string_view text);
  void expect_word(std::string_view text, const std::string& what);
  std::uint64_t integer(int base, const std::string& what);
  /// An integer below `size`.
  std::size_t below(std::size_t size, const std::string& what);

  /// Reads the next line, 'keyword N' with N items of at least one character in the rest of the
  /// file. @param minimum, maximum of N
  std::size_t count(const std::string& keyword, std::size_t minimum = 0,
                    std::size_t maximum = std::numeric_limits<std::size_t>::max());
  /// A set of candidates as a hexadecimal number whose binary ones are the candidates' numbers.
  support::IndexSet set(const std::string& what);

  /// One finite number such as -0x1.8p+3.
  double number(const std::string& what);

  /// The rest of the line as `count` such numbers.
  void numbers(std::size_t count, std::vector<double>& values, const std::string& what);

  /// Requires that the line has no further word.
  void end_of_line(const std::string& what) const;

  /// Requires that the rest of the line 'end N' is the number of nodes above.
  void expect_node_count(std::size_t nodes);

  /// Requires that no line follows but the digest.
  void expect_end();

 private:
  std::string_view rest_;
  const std::string& file_;
  std::string_view line_;
  std::string_view words_;
  std::size_t number_ = 0;
  bool ended_ = false;
};

/// The lines of a certificate after its first one, without the digest.
/// @throws CertificateError if the first line is another one, or the digest is not that of the text
Lines lines_after(std::string_view first_line, std::string_view text, const std::string& file);

}  // namespace kusabi::verify
