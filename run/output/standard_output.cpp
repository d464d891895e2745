// Descriptors, signals and flushing.
#include "run/output/standard_output.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

#include "run/output/terminal_page.hpp"

namespace kusabi::run {
namespace {

[[noreturn]] void fail() {
  throw std::runtime_error(
      fmt::format("standard output cannot be written: {}", std::strerror(errno)));
}

}  // namespace

void secure_standard_streams() {
  // Each stream is opened in the wrong mode, except for standard error, so that output to a closed
  // standard output is an error. open() takes the least free descriptor.
  struct Stream {
    int descriptor;
    int mode;
  };
  for (const auto [descriptor, mode] :
       {Stream{STDIN_FILENO, O_WRONLY}, {STDOUT_FILENO, O_RDONLY}, {STDERR_FILENO, O_WRONLY}}) {
    if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) {
      static_cast<void>(open("/dev/null", mode));
    }
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void print_answer(std::string_view text) {
  // Text that fills the buffer is written before the flush, and stdio forgets an error then.
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail();
  flush_standard_output();
}

void show_heading(std::string_view text) noexcept {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stdout));
  static_cast<void>(std::fflush(stdout));
}

void flush_standard_output() {
  if (std::fflush(stdout) != 0) fail();
}

void print_text(std::string_view text) noexcept {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

void print_warning(std::string_view line) noexcept {
  try {
    print_text(page_of(STDERR_FILENO).warning(line) + '\n');
  } catch (const std::bad_alloc&) {
    print_text(line);
  }
}

void print_written(std::initializer_list<std::string> files) {
  for (const auto& file : files) {
    if (!file.empty()) print_message("wrote {}\n", file);
  }
}

}  // namespace kusabi::run
