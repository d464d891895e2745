// Lines, fields and numbers.
#include "problems/files/meshes/mesh_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

constexpr std::string_view blanks = " \t\r";

/// The whole of `text` as a number.
template <class Number>
std::optional<Number> parsed(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Accepts Fortran exponents: 1.5D+03.
std::optional<double> parsed_real(std::string_view text) {
  if (const auto value = parsed<double>(text)) return value;
  std::string other(text);
  std::ranges::replace_if(
      other, [](char character) { return character == 'd' || character == 'D'; }, 'e');
  return parsed<double>(other);
}

}  // namespace

std::optional<double> number_in(std::string_view text) {
  const auto value = parsed_real(trimmed(text));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

MeshText::MeshText(std::string_view text, std::string file, std::string_view separators)
    : text_(text), file_(std::move(file)), separators_(separators) {}

bool MeshText::next_line() {
  if (put_back_) {
    put_back_ = false;
    return true;
  }
  if (at_ >= text_.size()) {
    line_ = {};
    fields_.clear();
    return false;
  }
  const auto end = std::min(text_.find('\n', at_), text_.size());
  line_ = text_.substr(at_, end - at_);
  at_ = std::min(end + 1, text_.size());
  ++number_;
  split();
  return true;
}

// Fields separated by commas may be empty, those separated by blanks may not.
void MeshText::split() {
  fields_.clear();
  const bool by_blanks = separators_ == " ";
  std::string_view rest = trimmed(line_);
  while (!rest.empty()) {
    const auto end =
        std::min(by_blanks ? rest.find_first_of(blanks) : rest.find(separators_), rest.size());
    fields_.push_back(trimmed(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + (by_blanks ? 0 : 1), rest.size()));
    rest = trimmed(rest);
  }
}

int MeshText::whole(std::size_t index, std::string_view called, int minimum) const {
  if (index >= fields_.size()) {
    fail(index, fmt::format("the line ends; expected {}", called));
  }
  const auto value = parsed<std::int64_t>(fields_[index]);
  if (!value || *value < minimum || *value > largest_tag) {
    fail(index, fmt::format("{} is {}; expected a whole number from {} to {}", called,
                            support::in_quotes(fields_[index]), minimum, largest_tag));
  }
  return static_cast<int>(*value);
}

double MeshText::real(std::size_t index, std::string_view called) const {
  if (index >= fields_.size()) {
    fail(index, fmt::format("the line ends; expected {}", called));
  }
  const auto value = number_in(fields_[index]);
  if (!value) {
    fail(index, fmt::format("{} is {}; expected a finite number", called,
                            support::in_quotes(fields_[index])));
  }
  return *value;
}

support::SourcePosition MeshText::position(int column) const {
  return has_lines_ ? support::SourcePosition{std::max(number_, 1), column}
                    : support::SourcePosition{};
}

void MeshText::fail(std::size_t index, std::string_view message) const {
  const char* place = index < fields_.size() && !fields_[index].empty()
                          ? fields_[index].data()
                          : line_.data() + trimmed(line_).size();
  const int column = line_.empty() ? 1 : static_cast<int>(place - line_.data()) + 1;
  throw support::InputError(file_, position(column), message);
}

void MeshText::fail(std::string_view message) const {
  throw support::InputError(file_, position(1), message);
}

}  // namespace kusabi::problems
