// Properties of the terminal, line breaking, and the text of a verdict.
#include "run/output/terminal_page.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "answer/words.hpp"

namespace kusabi::run {
namespace {

/// Minimum width of a column in which lists are broken.
constexpr std::size_t narrowest_column = 16;
constexpr std::size_t usual_width = 80;

std::string_view environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view{} : std::string_view(value);
}

std::optional<std::size_t> columns_of_environment() {
  const auto text = environment("COLUMNS");
  std::size_t columns = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), columns);
  if (error != std::errc{} || end != text.data() + text.size() || columns == 0) return std::nullopt;
  return columns;
}

std::size_t terminal_columns(int descriptor) {
  if (const auto columns = columns_of_environment()) return *columns;
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual_width;
  return size.ws_col;
}

// Width on a terminal: UTF-8, without colours (ESC [ … m).
std::size_t visible(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\033') {
      at = std::min(text.find('m', at), text.size() - 1);
    } else if ((static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U) {
      ++count;
    }
  }
  return count;
}

// Indentation of the continuation of a long line.
std::size_t hanging_indent(std::string_view line, std::size_t width) {
  const auto indent = std::min(line.find_first_not_of(' '), line.size());
  const auto room = width > narrowest_column ? width - narrowest_column : 0;
  std::size_t hang = indent == 0 ? 0 : indent + 2;
  for (auto gap = line.find("  ", indent); gap != std::string_view::npos;
       gap = line.find("  ", gap)) {
    gap = line.find_first_not_of(' ', gap);
    if (gap == std::string_view::npos) break;
    const auto column = visible(line.substr(0, gap));
    if (column > room) break;
    hang = column;
  }
  return hang > room ? 0 : hang;
}

void fold_line(std::string& text, std::string_view line, std::size_t width) {
  const auto hang = hanging_indent(line, width);
  std::size_t column = 0;
  for (std::size_t at = 0; at < line.size();) {
    const auto word = std::min(line.find_first_not_of(' ', at), line.size());
    const auto end = std::min(line.find(' ', word), line.size());
    const auto shown = visible(line.substr(word, end - word));
    if (column > hang && column + (word - at) + shown > width) {
      text += fmt::format("\n{:{}}", "", hang);
      column = hang;
    } else {
      text += line.substr(at, word - at);
      column += word - at;
    }
    text += line.substr(word, end - word);
    column += shown;
    at = end;
  }
}

// The end of the last line is not padded.
std::string styled(bool colours, int style, std::string_view text) {
  if (!colours || text.empty()) return std::string(text);
  const auto end = text.find_last_not_of('\n') + 1;
  return fmt::format("\033[{}m{}\033[0m{}", style, text.substr(0, end), text.substr(end));
}

}  // namespace

std::string Page::strong(std::string_view text) const {
  return styled(colours, 1, text);
}

std::string Page::warning(std::string_view text) const {
  constexpr int yellow = 33;
  return styled(colours, yellow, text);
}

Page page_of(int descriptor) {
  if (isatty(descriptor) == 0) return {};
  return {.width = terminal_columns(descriptor),
          .colours = environment("NO_COLOR").empty() && environment("TERM") != "dumb"};
}

std::string folded(std::string_view text, std::size_t width) {
  if (width == Page::endless) return std::string(text);
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find('\n', at), text.size());
    const auto line = text.substr(at, end - at);
    if (visible(line) <= width) {
      result += line;
    } else {
      fold_line(result, line, width);
    }
    if (end < text.size()) result += '\n';
    at = end + 1;
  }
  return result;
}

std::string conclusion_text(const answer::Verdict& verdict, const Page& page) {
  std::string text;
  const auto sentence = answer::headline(verdict);
  if (!sentence.empty()) {
    text = '\n' + page.strong(sentence);
    for (const auto& each : verdict.details) text += ' ' + each;
    text += '\n';
  }
  for (const auto& each : answer::reservations(verdict)) text += page.warning(each.sentence) + '\n';
  for (const auto& each : verdict.warnings) text += page.warning("Warning: " + each) + '\n';
  return text;
}

}  // namespace kusabi::run
