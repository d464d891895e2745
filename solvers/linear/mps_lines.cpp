// Fields of MPS lines, by blanks or by columns.
#include "solvers/linear/mps_lines.hpp"

#include <algorithm>
#include <array>

namespace kusabi::linear {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> list;
  for (;;) {
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return list;
    text.remove_prefix(first);
    const auto end = std::min(text.find_first_of(blanks), text.size());
    list.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

// Begin and end of the six fields of a card, counted from 0.
struct CardField {
  std::size_t begin;
  std::size_t end;
};
constexpr std::array<CardField, 6> card{{{1, 3}, {4, 12}, {14, 22}, {24, 36}, {39, 47}, {49, 61}}};

// False if there is text between the fields.
bool split_card(std::string_view text, std::vector<std::string_view>& fields) {
  if (text.find('\t') != std::string_view::npos) return false;
  std::size_t at = 0;
  for (const auto& [begin, end] : card) {
    const auto gap = text.substr(std::min(at, text.size()), begin - std::min(at, begin));
    if (!trimmed(gap).empty()) return false;
    fields.push_back(trimmed(text.substr(std::min(begin, text.size()), end - begin)));
    at = end;
  }
  return trimmed(text.substr(std::min(at, text.size()))).empty();
}

}  // namespace

MpsLines::MpsLines(std::string_view text, MpsLayout layout) : rest_(text), layout_(layout) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

bool MpsLines::next(MpsLine& line) {
  while (!rest_.empty()) {
    const auto end = std::min(rest_.find('\n'), rest_.size());
    const auto whole = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    if (whole.starts_with('*') || trimmed(whole).empty()) continue;
    line.number = number_;
    line.header = blanks.find(whole.front()) == std::string_view::npos;
    line.text = trimmed(whole);
    line.fields.clear();
    off_the_columns_ = false;
    if (layout_ == MpsLayout::free || line.header) {
      line.fields = words(whole);
    } else {
      off_the_columns_ = !split_card(whole, line.fields);
    }
    return true;
  }
  return false;
}

std::string capitals(std::string_view word) {
  std::string result(word);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return result;
}

}  // namespace kusabi::linear
