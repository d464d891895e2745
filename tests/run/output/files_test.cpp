// Output files in all parts: destinations, files left by killed processes, streamed JSON, last
// steps, launchers.
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include "run/output/json_writer.hpp"
#include "run/output/output_file.hpp"
#include "run/session/launch.hpp"
#include "run/session/session.hpp"
#include "tests/run/folder.hpp"

namespace kusabi::run {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;
using testing::UnorderedElementsAre;

class Files : public test::InFolder {
 protected:
  void make(const std::string& name) const { std::ofstream(in_folder(name)) << "old"; }
  [[nodiscard]] std::string content(const std::string& name) const {
    return test::content(in_folder(name));
  }
};

TEST_F(Files, AreWrittenCompletelyOrNotAtAll) {
  make("result");
  {
    OutputFile file("--output", in_folder("result"), "");
    file.stream() << "half";
  }
  EXPECT_EQ(content("result"), "old");
  {
    OutputFile file("--output", in_folder("result"), "");
    file.stream() << "whole";
    file.put_in_place();
  }
  EXPECT_EQ(content("result"), "whole");
  EXPECT_THAT(files(), ElementsAre("result"));
}

TEST_F(Files, OfTwoConcurrentProcessesDoNotMix) {
  OutputFile one("--output", in_folder("result"), "");
  OutputFile other("--output", in_folder("result"), "");
  one.stream() << "one";
  other.stream() << "other";
  one.put_in_place();
  EXPECT_EQ(content("result"), "one");
  other.put_in_place();
  EXPECT_EQ(content("result"), "other");
}

// Process that opens a file, exits to report it, and is killed by SIGKILL.
pid_t killed_while_it_writes(const std::string& name) {
  const pid_t child = fork();
  if (child == 0) {
    OutputFile file("--output", name, "");
    file.stream() << "half";
    file.stream().flush();
    raise(SIGKILL);
  }
  waitpid(child, nullptr, 0);
  return child;
}

TEST_F(Files, LeftByAKilledProcessAreRemovedByTheNextOne) {
  killed_while_it_writes(in_folder("result"));
  ASSERT_EQ(files().size(), 1U);  // otherwise the test shows nothing
  {
    OutputFile file("--output", in_folder("result"), "");
    EXPECT_EQ(files().size(), 1U);
    file.put_in_place();
  }
  EXPECT_THAT(files(), ElementsAre("result"));
}

TEST_F(Files, OfARunningProcessOrAUserAreKept) {
  const pid_t child = killed_while_it_writes(in_folder("result"));
  const auto beside = files().front();
  // A process of another machine with the same name and number: its file is locked.
  std::ofstream locked(in_folder(beside));
  const int descriptor = open(in_folder(beside).c_str(), O_WRONLY);
  ASSERT_EQ(flock(descriptor, LOCK_EX), 0);
  make("result.5.tmp");
  make(fmt::format("other.{}.tmp", child));
  OutputFile("--output", in_folder("result"), "");
  EXPECT_THAT(files(),
              UnorderedElementsAre(beside, "result.5.tmp", fmt::format("other.{}.tmp", child)));
  close(descriptor);
}

TEST_F(Files, LeftUnderTheSameProcessNumberAreReplaced) {
  std::string beside;
  {
    OutputFile file("--output", in_folder("result"), "");
    beside = files().front();
  }
  make(beside);  // same process number, as in a restarted container
  OutputFile file("--output", in_folder("result"), "");
  file.put_in_place();
  EXPECT_THAT(files(), UnorderedElementsAre(beside, "result"));
}

TEST_F(Files, OfOneCallMustDiffer) {
  fs::create_directory(in_folder("folder"));
  fs::create_directory_symlink("folder", in_folder("way"));
  make("problem");
  make("old");
  fs::create_symlink("old", in_folder("link"));
  fs::create_hard_link(in_folder("old"), in_folder("twin"));
  const auto refused = [&](const std::string& one, const std::string& other, const char* why) {
    EXPECT_THAT(
        [&] {
          check_outputs(in_folder("problem"),
                        {{"--output", in_folder(one)}, {"--trace", in_folder(other)}});
        },
        ThrowsMessage<WrongInput>(HasSubstr(why)))
        << one << " and " << other;
  };
  const auto* const twice = "is also the file of --output";
  refused("new", "new", twice);
  refused("new", "folder/../new", twice);
  refused("folder/new", "way/new", twice);
  refused("old", "link", twice);
  refused("old", "twin", twice);
  refused("new", "problem", "would overwrite the problem file");
  refused("new", "nowhere/new", "cannot be written");
  refused("new", "folder", "is a folder");
  check_outputs(in_folder("problem"), {{"--output", in_folder("old")},
                                       {"--trace", in_folder("folder/old")},
                                       {"--certificate", ""},
                                       {"--csv", ""}});
  EXPECT_THROW(check_outputs(in_folder("problem"), {{"--output", in_folder("state")}},
                             {{"--resume", in_folder("state")}}),
               WrongInput);
  EXPECT_EQ(content("old"), "old");
  EXPECT_THAT(files(), UnorderedElementsAre("folder", "way", "problem", "old", "link", "twin"));
}

TEST(JsonWriter, WritesAnyDocumentUnchanged) {
  // Names and texts of all kinds of characters, including marks of earlier versions.
  const ordered_json document = {{"name", "the rays"},
                                 {"the cones", {"the rays", "\"quoted\" \\ \n \t", "\x01", "節点"}},
                                 {"empty", ordered_json::object()},
                                 {"nothing", ordered_json::array()},
                                 {"null", nullptr},
                                 {"numbers", {1, -2.5, 1e-300}},
                                 {"nested", {{{"a", {{1, 2}, {3, 4}}}}, {{"b", true}}}}};
  std::ostringstream whole;
  JsonWriter(whole).value(document);
  EXPECT_EQ(ordered_json::parse(whole.str()), document);

  std::ostringstream pieces;
  JsonWriter json(pieces);
  json.begin_object();
  for (const auto& [name, value] : document.items()) {
    json.key(name);
    if (name != "nested") {
      json.value(value);
      continue;
    }
    json.begin_list();
    for (const auto& element : value) json.value(element);
    json.end_list();
  }
  json.end_object();
  EXPECT_EQ(pieces.str(), whole.str());
}

TEST(JsonWriter, WritesOneMemberPerLineAndSimpleListsOnOneLine) {
  std::ostringstream out;
  JsonWriter json(out);
  json.begin_object();
  json.member("count", 2);
  json.key("rays");
  json.begin_list();
  json.value({{"number", 1}, {"reaction", {{1, 2}, {3, 4}}}});
  json.end_list();
  json.key("cones");
  json.begin_list();
  json.end_list();
  json.end_object();
  EXPECT_EQ(out.str(), R"({
  "count": 2,
  "rays": [
    {
      "number": 1,
      "reaction": [[1,2],[3,4]]
    }
  ],
  "cones": []
})");
}

TEST(DoAll, RunsAllStepsAndThrowsTheFirstError) {
  std::string done;
  EXPECT_THAT(
      [&] {
        do_all({[&] { done += 'a'; },
                [&] {
                  done += 'b';
                  throw std::runtime_error("the disk is full");
                },
                [&] {
                  done += 'c';
                  throw std::runtime_error("nobody reads");
                },
                [&] { done += 'd'; }});
      },
      ThrowsMessage<std::runtime_error>("the disk is full"));
  EXPECT_EQ(done, "abcd");
}

class LaunchOf {
 public:
  using Variables = std::map<std::string, std::string>;
  explicit LaunchOf(Variables variables) : variables_(std::move(variables)) {}

  [[nodiscard]] bool refused(unsigned ranks, bool serial = false) const {
    const auto launch = launch_from([this](const char* name) {
      const auto found = variables_.find(name);
      return found == variables_.end() ? nullptr : found->second.c_str();
    });
    return fault_of_launch(launch, ranks, serial).has_value();
  }

 private:
  Variables variables_;
};

TEST(Launch, OfSeveralUnconnectedProcessesIsRefused) {
  // srun without PMIx; mpirun of MPICH with a command of Open MPI, and the reverse.
  const LaunchOf srun({{"SLURM_NTASKS", "4"},
                       {"SLURM_STEP_NUM_TASKS", "4"},
                       {"SLURM_STEP_ID", "0"},
                       {"SLURM_PROCID", "2"}});
  const LaunchOf old_srun({{"SLURM_NTASKS", "4"}, {"SLURM_STEP_ID", "0"}, {"SLURM_PROCID", "2"}});
  const LaunchOf mpich({{"PMI_SIZE", "4"}, {"PMI_RANK", "1"}});
  const LaunchOf open_mpi({{"OMPI_COMM_WORLD_SIZE", "4"}, {"OMPI_COMM_WORLD_RANK", "1"}});
  for (const auto* launch : {&srun, &old_srun, &mpich, &open_mpi}) {
    EXPECT_TRUE(launch->refused(1));
    EXPECT_FALSE(launch->refused(4));
  }
  // Tasks of a batch system may be independent searches; processes of mpirun may not.
  EXPECT_FALSE(srun.refused(1, true));
  EXPECT_TRUE(mpich.refused(1, true));
  EXPECT_TRUE(open_mpi.refused(1, true));
}

TEST(Launch, OfOneProcessIsAccepted) {
  EXPECT_FALSE(LaunchOf(LaunchOf::Variables()).refused(1));
  EXPECT_FALSE(LaunchOf(LaunchOf::Variables()).refused(1, true));
  // A shell of salloc, with and without an interactive step, and a batch script.
  EXPECT_FALSE(
      LaunchOf(LaunchOf::Variables{{"SLURM_NTASKS", "4"}, {"SLURM_JOB_ID", "7"}}).refused(1));
  EXPECT_FALSE(
      LaunchOf(LaunchOf::Variables{{"SLURM_NTASKS", "4"}, {"SLURM_PROCID", "0"}}).refused(1));
  EXPECT_FALSE(LaunchOf({{"SLURM_NTASKS", "4"},
                         {"SLURM_STEP_NUM_TASKS", "1"},
                         {"SLURM_STEP_ID", "4294967290"},
                         {"SLURM_PROCID", "0"}})
                   .refused(1));
  // One process of mpirun in an allocation for four, with a daemon started by srun.
  EXPECT_FALSE(LaunchOf({{"OMPI_COMM_WORLD_SIZE", "1"},
                         {"SLURM_STEP_NUM_TASKS", "4"},
                         {"SLURM_STEP_ID", "0"},
                         {"SLURM_PROCID", "0"}})
                   .refused(1));
  EXPECT_FALSE(LaunchOf(LaunchOf::Variables{{"PMI_SIZE", "many"}}).refused(1));
}

}  // namespace
}  // namespace kusabi::run
