// OutputFile: destinations, errors at the start, and a full disk. Several processes are in
// files_test.cpp.
#include "run/output/output_file.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "run/output/wrong_input.hpp"
#include "tests/run/folder.hpp"

namespace kusabi::run {
namespace {

namespace fs = std::filesystem;
using test::content;
using testing::HasSubstr;
using testing::ThrowsMessage;

class OutputFiles : public test::InFolder {
 protected:
  static auto opened(const std::string& name, const std::string& input = "") {
    return [=] { OutputFile("--output", name, input); };
  }
};

TEST_F(OutputFiles, WithoutANameAreNotWanted) {
  EXPECT_FALSE(OutputFile("--output", "", "").wanted());
  EXPECT_TRUE(OutputFile("--output", in_folder("result"), "").wanted());
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(OutputFiles, AreRefusedWithTheirOptionAndTheReason) {
  fs::create_directory(in_folder("folder"));
  EXPECT_THAT(opened(in_folder("folder")),
              ThrowsMessage<WrongInput>("--output " + in_folder("folder") +
                                        ": is a folder; expected a file name"));
  EXPECT_THAT(opened(in_folder("none/result")),
              ThrowsMessage<WrongInput>("--output " + in_folder("none/result") +
                                        ": cannot be written: No such file or directory"));
  const auto problem = in_folder("problem.toml");
  std::ofstream(problem) << "name = \"x\"\n";
  fs::create_hard_link(problem, in_folder("twin.toml"));
  for (const auto& same : {problem, in_folder("folder/../problem.toml"), in_folder("twin.toml")}) {
    EXPECT_THAT(opened(same, problem),
                ThrowsMessage<WrongInput>(fmt::format(
                    "--output {}: would overwrite the problem file; expected another name", same)));
  }
  EXPECT_EQ(content(problem), "name = \"x\"\n");
}

TEST_F(OutputFiles, HaveThePermissionsOfTheFileThatTheyReplace) {
  const auto name = in_folder("result");
  std::ofstream(name) << "old";
  constexpr auto own = fs::perms::owner_read | fs::perms::owner_write;
  for (const auto kept : {own, own | fs::perms::group_read | fs::perms::group_write}) {
    fs::permissions(name, kept);
    OutputFile file("--output", name, "");
    file.stream() << "new";
    file.put_in_place();
    EXPECT_EQ(fs::status(name).permissions(), kept);
    EXPECT_EQ(content(name), "new");
  }
}

TEST_F(OutputFiles, FollowALinkAndKeepIt) {
  std::ofstream(in_folder("old")) << "old";
  fs::create_symlink("old", in_folder("link"));
  OutputFile file("--output", in_folder("link"), "");
  file.stream() << "new";
  file.put_in_place();
  EXPECT_TRUE(fs::is_symlink(in_folder("link")));
  EXPECT_EQ(content(in_folder("old")), "new");
}

TEST_F(OutputFiles, WriteToPipesDirectly) {
  const auto pipe = in_folder("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = content(pipe); });
  {
    OutputFile file("--output", pipe, "");
    file.stream() << "through";
    file.put_in_place();
  }
  reader.join();
  EXPECT_EQ(received, "through");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(OutputFiles, ReportAFullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no device that is always full";
  OutputFile file("--output", "/dev/full", "");
  file.stream() << "text";
  EXPECT_THAT(
      [&] { file.put_in_place(); },
      ThrowsMessage<std::runtime_error>("/dev/full: the file is incomplete; the disk may be full"));
}

TEST_F(OutputFiles, ReportAMissingFolder) {
  fs::create_directory(in_folder("folder"));
  OutputFile file("--output", in_folder("folder/result"), "");
  file.stream() << "text";
  fs::remove_all(in_folder("folder"));
  EXPECT_THAT([&] { file.put_in_place(); },
              ThrowsMessage<std::runtime_error>(HasSubstr("folder/result: cannot be renamed")));
}

}  // namespace
}  // namespace kusabi::run
