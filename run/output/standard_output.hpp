// Printing: the answer and its heading on standard output, everything else on standard error. No
// result is lost because output cannot be printed: a closed pipe is an error, not a signal;
// messages that cannot be printed are dropped; the answer is printed after all files are written.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace kusabi::run {

/// Prepares the standard streams; to be called first in main. Afterwards a closed pipe (SIGPIPE)
/// and a file at its size limit (SIGXFSZ) are errors of the write, and descriptors 0, 1 and 2 are
/// open, so that no file opened later becomes standard output. Writes to a standard output that was
/// closed fail; standard error accepts everything.
void secure_standard_streams();

/// Prints the answer and flushes it, after all files are written.
/// @throws std::runtime_error if it was not written completely: disk full, pipe closed
void print_answer(std::string_view text);

/// Prints the heading of the answer before the search. An error is reported with the answer, not
/// here.
void show_heading(std::string_view text) noexcept;

/// @throws std::runtime_error if earlier output was not written completely
void flush_standard_output();

/// Writes to standard error; never throws. Messages that cannot be written are dropped.
void print_text(std::string_view text) noexcept;

/// Formats and writes to standard error; unlike fmt::print(stderr, …), never throws.
template <class... Arguments>
void print_message(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  print_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// A warning or a line about open parts, highlighted on a terminal.
void print_warning(std::string_view line) noexcept;

/// One line on standard error for each of `files` with a name.
void print_written(std::initializer_list<std::string> files);

}  // namespace kusabi::run
