// The command called by the shell as by a user, alone or under mpirun, in a temporary folder.
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/run/folder.hpp"

namespace kusabi::test {

// A word quoted for the shell.
inline std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

inline const std::string command = quoted(KUSABI_COMMAND);
inline const std::string truss_file = std::string(KUSABI_SOURCE_DIR) + "/examples/space-truss.toml";
inline const std::string truss = quoted(truss_file);

struct Run {
  int exit_code;
  std::string output;  // both streams
};

inline Run shell(const std::string& line) {
  FILE* pipe = popen((line + " 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> piece{};
  while (const auto count = std::fread(piece.data(), 1, piece.size(), pipe)) {
    output.append(piece.data(), count);
  }
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

// Settings of cmake/KusabiTest.cmake: root, more ranks than cores, no pinning.
inline const std::string any_machine =
    "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
    "OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none "
    "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe "
    "PRTE_MCA_hwloc_default_binding_policy=none "
    "OMPI_MCA_mpi_yield_when_idle=0 OMPI_MCA_btl_vader_single_copy_mechanism=none "
    "ASAN_OPTIONS=detect_leaks=0 ";

inline std::string ranks(int count) {
  return fmt::format("{}{} {} ", any_machine, KUSABI_MPIEXEC, count);
}

// Call for a shell in which `kusabi` is installed, with the mpirun of its MPI; -np is added by the
// caller.
inline std::string as_typed(const std::string& line) {
  const auto folder = fs::path(KUSABI_COMMAND).parent_path().string();
  const std::string launcher = "mpirun() { shift; " KUSABI_MPIEXEC " \"$@\"; }; ";
  return fmt::format("{}PATH={}:\"$PATH\" sh -c {}", any_machine, quoted(folder),
                     quoted(launcher + line));
}

// The call that resumes a search, copied from the output of the stopped run.
inline std::string call_to_go_on(const std::string& output) {
  const std::string before = "resume with: ";
  const auto at = output.find(before);
  EXPECT_NE(at, std::string::npos) << output;
  if (at == std::string::npos) return "false";
  const auto from = at + before.size();
  return output.substr(from, output.find('\n', from) - from);
}

// The text of a result file from "command" to "statistics", byte for byte.
inline std::string without_statistics(const std::string& file) {
  auto text = content(file);
  const auto cut = text.find("\"statistics\"");
  EXPECT_NE(cut, std::string::npos);
  return text.substr(0, cut);
}

// A node on a rod along its normal, beside one that it does not move (worked out by hand: r_t = r_n
// at c1, so it wedges from 1 on).
inline constexpr auto rod_along_normal = R"(name = "a rod along the normal"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
g1 = [0.0, -1.0]
g2 = [0.0, 1.0]
g3 = [2.0, 2.5]
c1 = [1.0, 0.0]
c2 = [1.0, 1.0]
[[members]]
EA = 1.0
between = [["g1","c1"],["g2","c2"],["c1","c2"],["g3","c2"]]
[[supports]]
nodes = ["g1","g2","g3"]
[[contact]]
nodes = ["c1"]
normal = [0.0, 1.0]
[[contact]]
nodes = ["c2"]
normal = [-1.0, 0.2]
)";

class Command : public InFolder {
 protected:
  // A path in the folder, quoted for the shell.
  [[nodiscard]] std::string argument(const std::string& name) const {
    return quoted(in_folder(name));
  }
};

}  // namespace kusabi::test
