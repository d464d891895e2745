// The command on a pseudo-terminal with a given number of columns.
#pragma once

#include <array>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

namespace kusabi::test {

/// Both streams as the terminal receives them, with plain line ends.
/// @param line for the shell, which may set variables in front of the command
inline std::string on_terminal(const std::string& line, unsigned short columns) {
  winsize size{.ws_row = 50, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
  int master = -1;
  const pid_t child = forkpty(&master, nullptr, nullptr, &size);
  if (child == 0) {
    setenv("TERM", "xterm", 1);
    unsetenv("NO_COLOR");
    unsetenv("COLUMNS");
    execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    _exit(127);
  }
  EXPECT_GT(child, 0);
  std::string shown;
  std::array<char, 4096> piece{};
  for (;;) {
    const auto count = read(master, piece.data(), piece.size());
    if (count <= 0) break;  // EIO: no writer is left
    for (const char c : std::string(piece.data(), static_cast<std::size_t>(count)))
      if (c != '\r') shown += c;
  }
  close(master);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 0) << shown;
  return shown;
}

}  // namespace kusabi::test
