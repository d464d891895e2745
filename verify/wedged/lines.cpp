// Reader of lines and words.
#include "verify/wedged/lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "support/one_line.hpp"
#include "support/sha1.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {
namespace {

// True if the digits of a hexadecimal number, such as 1.8p+3, are at most those of a double, so that
// it is read without rounding.
bool has_digits_of_a_double(std::string_view text) {
  constexpr std::size_t most = 14;  // the first 0 or 1, then 52 bits
  constexpr int least_exponent = -1074;
  const auto mark = text.find('p');
  const auto digits = text.substr(0, mark);
  const auto point = digits.find('.');
  const bool has_point = point != std::string_view::npos;
  const auto count = digits.size() - (has_point ? 1 : 0);
  if (count > most || (count == most && digits.front() > '1')) return false;
  if (mark == std::string_view::npos) return true;
  const auto after = has_point ? digits.size() - point - 1 : 0;
  auto power = text.substr(mark + 1);
  if (power.starts_with('+')) power.remove_prefix(1);
  int exponent = 0;
  std::from_chars(power.data(), power.data() + power.size(), exponent);
  return exponent - 4 * static_cast<int>(after) >= least_exponent;
}

std::optional<double> number_in(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  if (!text.starts_with("0x")) return {};
  text.remove_prefix(2);
  if (text.starts_with('-') || !has_digits_of_a_double(text)) return {};
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value, std::chars_format::hex);
  if (error != std::errc{} || end != last || !std::isfinite(value)) return {};
  return negative ? -value : value;
}

}  // namespace

std::string shown(std::string_view text) {
  constexpr std::size_t enough = 40;
  std::string part = "'";
  for (const char c : text.substr(0, enough)) part += c < ' ' || c > '~' ? '?' : c;
  part += text.size() > enough ? "…'" : "'";
  return part;
}

std::string_view Lines::name() const {
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if (support::is_control(words_, i)) refuse("a name without control characters");
  }
  return words_;
}

void Lines::refuse(const std::string& expected) const {
  const std::string what = ended_ ? "the file ends here" : shown(line_);
  throw CertificateError(file_ + ":" + std::to_string(number_) + ": " + what + ", expected " +
                         expected);
}

void Lines::next() {
  ++number_;
  const auto end = rest_.find('\n');
  ended_ = end == std::string_view::npos;  // an unterminated line does not count
  line_ = words_ = ended_ ? std::string_view{} : rest_.substr(0, end);
  rest_.remove_prefix(ended_ ? rest_.size() : end + 1);
}

std::string_view Lines::word() {
  const auto end = words_.find(' ');
  const auto found = words_.substr(0, end);
  words_ = end == std::string_view::npos ? std::string_view{} : words_.substr(end + 1);
  return found;
}

void Lines::expect(std::string_view text) {
  next();
  if (ended_ || line_ != text) refuse(std::string("'").append(text).append("'"));
}

void Lines::expect_word(std::string_view text, const std::string& what) {
  if (ended_ || word() != text) refuse(what);
}

std::uint64_t Lines::integer(int base, const std::string& what) {
  const auto text = word();
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) refuse(what);
  return value;
}

std::size_t Lines::below(std::size_t size, const std::string& what) {
  const auto value = integer(10, what);
  if (value >= size) refuse(what + " below " + std::to_string(size));
  return value;
}

std::size_t Lines::count(const std::string& keyword, std::size_t minimum, std::size_t maximum) {
  const auto what = "'" + keyword + "' and a number";
  next();
  expect_word(keyword, what);
  const auto number = integer(10, what);
  if (number < minimum || number > maximum)
    refuse(what + " from " + std::to_string(minimum) + " to " + std::to_string(maximum));
  if (number > left()) refuse(what + " that the rest of the file holds");
  end_of_line(what);
  return number;
}

support::IndexSet Lines::set(const std::string& what) {
  auto text = word();
  if (text.empty()) refuse(what);
  support::IndexSet set;
  constexpr std::size_t digits = 16;  // of a word
  for (std::size_t k = 0; !text.empty(); ++k) {
    const auto part = text.substr(text.size() - std::min(digits, text.size()));
    text.remove_suffix(part.size());
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value, 16);
    if (error != std::errc{} || end != part.data() + part.size()) refuse(what);
    set.set_word(k, value);
  }
  return set;
}

double Lines::number(const std::string& what) {
  const auto value = number_in(word());
  if (!value) refuse(what + ", like 0x1.8p+3");
  return *value;
}

void Lines::numbers(std::size_t count, std::vector<double>& values, const std::string& what) {
  const auto expected = [&] { return std::to_string(count) + " " + what + ", each like 0x1.8p+3"; };
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = number_in(word());
    if (!value) refuse(expected());
    values.push_back(*value);
  }
  if (!words_.empty() || line_.ends_with(' ')) refuse(expected());
}

void Lines::end_of_line(const std::string& what) const {
  if (!words_.empty() || line_.ends_with(' ')) refuse(what);
}

void Lines::expect_node_count(std::size_t nodes) {
  const auto expected = "'end " + std::to_string(nodes) + "', the number of nodes above";
  if (integer(10, expected) != nodes || !words_.empty()) refuse(expected);
}

void Lines::expect_end() {
  if (done()) return;
  next();
  refuse("the line 'digest …', the last one");
}

namespace {

// Removes the last line and compares its digest with that of the text.
std::string_view without_digest(std::string_view text, const std::string& file) {
  const auto incomplete = [&] {
    return CertificateError(
        file + ": is not complete: expected 'digest' and 40 hexadecimal digits as its last line");
  };
  if (!text.ends_with('\n')) throw incomplete();
  const auto before = text.substr(0, text.size() - 1).rfind('\n');
  if (before == std::string_view::npos) throw incomplete();
  const auto last = text.substr(before + 1);
  text = text.substr(0, before + 1);
  constexpr std::string_view keyword = "digest ";
  constexpr std::size_t digits = 40;
  if (!last.starts_with(keyword) || last.size() != keyword.size() + digits + 1) throw incomplete();
  const auto found = last.substr(keyword.size(), digits);
  const auto expected = support::hexadecimal(support::sha1(text));
  if (found != expected) {
    throw CertificateError(file + ": was altered: digest " + shown(found) + ", expected '" +
                           expected + "'");
  }
  return text;
}

}  // namespace

Lines lines_after(std::string_view first_line, std::string_view text, const std::string& file) {
  // Compared first, since a file of another kind is not to be reported as damaged.
  Lines beginning(text, file);
  beginning.next();
  if (beginning.text() != first_line) beginning.refuse("'" + std::string(first_line) + "'");
  Lines lines(without_digest(text, file), file);
  lines.next();
  return lines;
}

}  // namespace kusabi::verify
