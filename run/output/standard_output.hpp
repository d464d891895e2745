// What the command prints: its answer and the heading above it on standard output, everything else
// on standard error.
//
// Nothing computed may be lost because nobody reads what is printed: a closed pipe is an error that
// is told, not a signal that kills; a message that cannot be shown is dropped; and the answer is
// printed when all files are in their places.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace kusabi::run {

/// To be called first of all. From then on a closed pipe (SIGPIPE) and a file that has reached its
/// permitted size (SIGXFSZ) are errors of the call that writes; and the descriptors 0, 1 and 2 are
/// open, so that no file that is opened later becomes standard output by mistake. What is written
/// to a standard output that was closed fails, as it should; standard error takes anything.
void secure_standard_streams();

/// Prints the answer and flushes it. Call it when all files are in their places.
/// @throws std::runtime_error if not all of it has got through: the disk is full, nobody reads
void print_answer(std::string_view text);

/// Prints what stands above the answer, before the work begins: that nobody reads it is told when
/// the answer is printed, and keeps no work from being done.
void show_heading(std::string_view text) noexcept;

/// @throws std::runtime_error if not all that was printed has got through
void flush_standard_output();

/// Writes to standard error; never throws. A message that cannot be written is lost.
void tell_text(std::string_view text) noexcept;

/// The same of a format and its arguments, like fmt::print(stderr, …), which throws.
template <class... Arguments>
void tell(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  tell_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// A line that warns, or says what is left open: marked as such on a terminal.
void tell_doubt(std::string_view line) noexcept;

/// One line for each of `files`, but those without a name, on standard error.
void tell_written(std::initializer_list<std::string> files);

}  // namespace kusabi::run
