// Errors of the environment: a closed pipe, a full disk, closed descriptors, and signals at any
// time. A file is complete or absent in all cases.
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/checkpoint.hpp"
#include "shell.hpp"
#include "tests/support/thorough.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;
using testing::UnorderedElementsAreArray;

using Words = std::vector<std::string>;

// Starts the command without a shell, after `prepare` in its process.
pid_t start(const Words& words, const std::function<void()>& prepare) {
  const pid_t child = fork();
  if (child != 0) return child;
  prepare();
  std::vector<char*> arguments;
  static std::string name = KUSABI_COMMAND;
  arguments.push_back(name.data());
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(name.c_str(), arguments.data());
  _exit(127);
}

constexpr int killed_by_a_signal = -1;

int end_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : killed_by_a_signal;
}

void open_as(int descriptor, const std::string& file) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(opened, descriptor);
  close(opened);
}

// Standard output is a pipe without a reader.
void let_nobody_read() {
  int ends[2];
  if (pipe(ends) != 0) _exit(126);
  close(ends[0]);
  dup2(ends[1], STDOUT_FILENO);
  close(ends[1]);
}

const std::string plane_truss = std::string(KUSABI_SOURCE_DIR) + "/examples/plane-truss.toml";
const std::string grid = std::string(KUSABI_SOURCE_DIR) + "/examples/paper/limit-3x3.toml";
const std::string coins = std::string(KUSABI_SOURCE_DIR) + "/tests/programs/coins.lp";

class EnvironmentFaults : public Command {
 protected:
  // Each subcommand with all its outputs.
  struct Call {
    Words words;
    Words files;
  };
  [[nodiscard]] std::vector<Call> calls() const {
    return {{{"rays", plane_truss, "--mu", "0.7", "--output", in_folder("r.json"), "--csv",
              in_folder("r.csv"), "--dot", in_folder("r.dot")},
             {"r.json", "r.csv", "r.dot"}},
            {{"patterns", truss_file, "--mu", "0.65", "--output", in_folder("p.json"), "--trace",
              in_folder("p.trace"), "--certificate", in_folder("p.cert")},
             {"p.json", "p.trace", "p.cert"}},
            {{"critical", plane_truss, "--output", in_folder("c.json"), "--certificate",
              in_folder("c.cert")},
             {"c.json", "c.cert.lower", "c.cert.upper"}},
            {{"limit", grid, "--alpha", "40", "--output", in_folder("l.json"), "--certificate",
              in_folder("l.cert")},
             {"l.json", "l.cert"}},
            {{"mip", coins, "--output", in_folder("m.json")}, {"m.json"}}};
  }

  // All files of the call exist and are complete; there are no others. Removes them.
  void expect_whole(const Call& call) {
    auto found = files();
    found.erase(std::remove(found.begin(), found.end(), "said"), found.end());
    EXPECT_THAT(found, UnorderedElementsAreArray(call.files)) << call.words.front();
    for (const auto& file : found) {
      EXPECT_TRUE(whole(file)) << file;
      fs::remove(in_folder(file));
    }
  }

  // The end of the file, where an incomplete file differs.
  [[nodiscard]] bool whole(const std::string& file) const {
    const auto text = content(in_folder(file));
    if (file.ends_with(".json") || file.ends_with(".trace")) return nlohmann::json::accept(text);
    if (file.ends_with(".csv")) return text.ends_with('\n');
    if (file.ends_with(".dot")) return text.ends_with("}\n");
    const auto digest = text.rfind("\ndigest ");
    constexpr std::size_t length = 49;  // of that line
    return digest != std::string::npos && digest + length == text.size();
  }

  [[nodiscard]] std::string said() const { return content(in_folder("said")); }
};

TEST_F(EnvironmentFaults, ClosedPipeLosesNoFile) {
  for (const auto& call : calls()) {
    const auto child = start(call.words, [&] {
      open_as(STDERR_FILENO, in_folder("said"));
      let_nobody_read();
    });
    EXPECT_EQ(end_of(child), 1) << call.words.front();
    EXPECT_THAT(said(), HasSubstr("standard output cannot be written: Broken pipe"));
    expect_whole(call);
  }
}

TEST_F(EnvironmentFaults, FullStandardOutputLosesNoFile) {
  // Files may have one mebibyte, and the file at standard output has that size already.
  constexpr rlim_t maximum = 1U << 20U;
  for (const auto& call : calls()) {
    const auto child = start(call.words, [&] {
      open_as(STDERR_FILENO, in_folder("said"));
      open_as(STDOUT_FILENO, in_folder("table"));
      lseek(STDOUT_FILENO, maximum, SEEK_SET);
      const rlimit limit{maximum, maximum};
      setrlimit(RLIMIT_FSIZE, &limit);
    });
    EXPECT_EQ(end_of(child), 1) << call.words.front();
    EXPECT_THAT(said(), HasSubstr("standard output cannot be written: File too large"));
    fs::remove(in_folder("table"));
    expect_whole(call);
  }
}

TEST_F(EnvironmentFaults, ClosedDescriptorsDoNotMixFiles) {
  for (const auto& call : calls()) {
    auto words = call.words;
    const auto child = start(words, [] {
      for (const int descriptor : {0, 1, 2}) close(descriptor);
    });
    EXPECT_EQ(end_of(child), 1) << call.words.front();  // the table was not printed completely
    expect_whole(call);
    words.emplace_back("--quiet");
    const auto quiet = start(words, [] {
      for (const int descriptor : {0, 1, 2}) close(descriptor);
    });
    EXPECT_EQ(end_of(quiet), 0) << call.words.front();
    expect_whole(call);
  }
}

TEST_F(EnvironmentFaults, UnreadMessagesLoseNoFile) {
  const auto call = calls().front();
  const auto child = start(call.words, [&] {
    open_as(STDOUT_FILENO, in_folder("said"));
    int ends[2];
    if (pipe(ends) != 0) _exit(126);
    close(ends[0]);
    dup2(ends[1], STDERR_FILENO);
  });
  EXPECT_EQ(end_of(child), 0);
  EXPECT_THAT(said(), HasSubstr("extremal rays in"));
  expect_whole(call);
}

TEST_F(EnvironmentFaults, FullDiskLosesNoCompleteFile) {
  // Space for the CSV file and the graph, but not for the JSON file.
  const auto call = calls().front();
  const auto child = start(call.words, [&] {
    open_as(STDERR_FILENO, in_folder("said"));
    open_as(STDOUT_FILENO, in_folder("table"));
    constexpr rlim_t maximum = 12'000;
    const rlimit limit{maximum, maximum};
    setrlimit(RLIMIT_FSIZE, &limit);
  });
  EXPECT_EQ(end_of(child), 1);
  EXPECT_THAT(said(), HasSubstr("r.json: the file is incomplete"));
  EXPECT_THAT(content(in_folder("table")), HasSubstr("extremal rays in"));
  EXPECT_TRUE(whole("r.csv"));
  EXPECT_TRUE(whole("r.dot"));
  EXPECT_FALSE(fs::exists(in_folder("r.json")));
}

// A search that takes minutes.
std::string long_search(const std::string& file) {
  const auto run =
      shell(command + " example space-truss --rows 8 --depth 5 --output " + quoted(file));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return file;
}

// Manifests of searches in a folder: "state.search3".
std::vector<std::string> states_of_searches(const fs::path& folder) {
  std::vector<std::string> states;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto name = entry.path().filename().string();
    constexpr std::string_view begin = "state.search";
    if (name.starts_with(begin) && name.find('.', begin.size()) == std::string::npos)
      states.push_back(entry.path().string());
  }
  return states;
}

TEST_F(EnvironmentFaults, SignalDuringASearchLeavesAPartialAnswer) {
  const auto problem = long_search(in_folder("truss.toml"));
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGXCPU, SIGUSR2}) {
    const auto child = start(
        {"patterns", problem, "--mu", "1", "--output", in_folder("p.json"), "--trace",
         in_folder("p.trace"), "--resume", in_folder("state"), "--checkpoint-interval", "0.01"},
        [&] {
          open_as(STDOUT_FILENO, in_folder("table"));
          open_as(STDERR_FILENO, in_folder("said"));
        });
    // A checkpoint shows that the search runs and handles signals.
    while (states_of_searches(folder_).empty() && kill(child, 0) == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const auto asked = std::chrono::steady_clock::now();
    kill(child, signal);
    EXPECT_EQ(end_of(child), 3) << strsignal(signal) << ": " << said();
    // A tenth of a second on an idle machine.
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(3));
    EXPECT_TRUE(whole("p.json") && whole("p.trace"));
    EXPECT_EQ(nlohmann::json::parse(content(in_folder("p.json")))["status"], "interrupted");
    EXPECT_THAT(content(in_folder("table")), HasSubstr("sign patterns"));
    for (const auto& file : files()) {
      if (file != "truss.toml") fs::remove(in_folder(file));
    }
  }
}

TEST_F(EnvironmentFaults, StopOfMpirunLeavesNoIncompleteFile) {
  const auto problem = long_search(in_folder("truss.toml"));
  // Spread over start, search and end by the golden ratio; five runs at once, since
  // mpirun takes two seconds to end.
  constexpr int moments = thorough ? 20 : 5;
  constexpr int at_a_time = 5;
  // Half of them count from the first checkpoint, on machines of any speed.
  const std::string await_search =
      "while ! ls state.search* >/dev/null 2>&1 && kill -0 $p; do sleep 0.02; done;";
  double place = 0;
  std::string script;
  for (int moment = 0; moment < moments; ++moment) {
    const auto folder = fmt::format("{}/{}", folder_.string(), moment);
    fs::create_directory(folder);
    place += 0.6180339887498949;
    place -= std::floor(place);
    // mpirun replaces the shell, so that it receives the signal.
    script += fmt::format(
        "(cd {}; exec {} {} patterns {} --mu 1 --output p.json --trace p.trace --certificate "
        "p.cert --resume state --checkpoint-interval 0.05 > said 2>&1) & p=$!;"
        " (cd {}; {} sleep {:.3f}; kill -{} $p) &\n",
        quoted(folder), ranks(2), command, quoted(problem), quoted(folder),
        moment % 4 < 2 ? await_search : std::string{}, 0.1 + place,
        moment % 2 == 0 ? "TERM" : "INT");
    if (moment % at_a_time == at_a_time - 1) script += "wait\n";
  }
  shell("bash -m -c " + test::quoted(script));  // -m: background processes handle SIGINT, too
  for (int moment = 0; moment < moments; ++moment) {
    SCOPED_TRACE(moment);
    const auto folder = std::to_string(moment);
    for (const auto* file : {"p.json", "p.trace", "p.cert"}) {
      const auto name = folder + "/" + file;
      if (!fs::exists(in_folder(name))) continue;
      EXPECT_TRUE(whole(name)) << name;
    }
    for (const auto& state : states_of_searches(in_folder(folder))) {
      const auto manifest = engine::read_manifest(state);
      std::string warning;
      EXPECT_EQ(engine::usable_checkpoint(state, manifest.problem, warning), state);
      EXPECT_EQ(warning, "");
    }
  }
}

}  // namespace
}  // namespace kusabi::test
