// Checkpoints to resume from, and errors.
#include "run/session/restart.hpp"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "run/session/session.hpp"
#include "tests/engine/queens.hpp"

namespace kusabi::run {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::uint64_t this_tree = 0x7EE;

class Restart : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "kusabi test-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    file_ = (folder_ / "state").string();
  }
  void TearDown() override { fs::remove_all(folder_); }

  // A search that stops early and leaves its state.
  void leave_a_checkpoint(std::uint64_t tree) const {
    examples::Queens queens(8);
    engine::Options options;
    options.limits.nodes = 100;
    options.nodes_per_step = 10;
    options.reduction_interval = 0;
    options.checkpoint.file = file_;
    options.checkpoint.problem = tree;
    ASSERT_EQ(engine::search(queens, options).status, engine::Status::node_limit);
    ASSERT_TRUE(fs::exists(file_));
  }

  [[nodiscard]] std::string from(const std::string& checkpoint, const std::string& restart,
                                 std::optional<std::uint64_t> tree = this_tree) {
    return restart_from(alone_, checkpoint, restart, tree);
  }
  [[nodiscard]] auto refused(const std::string& checkpoint, const std::string& restart) {
    return [=, this] { static_cast<void>(from(checkpoint, restart)); };
  }

  // Text on standard error.
  template <class Speaker>
  [[nodiscard]] static std::string said(Speaker speak) {
    testing::internal::CaptureStderr();
    speak();
    return testing::internal::GetCapturedStderr();
  }

  fs::path folder_;
  std::string file_;

 private:
  int count_ = 2;
  std::string name_ = "kusabi", serial_ = "--serial";
  std::vector<char*> words_{name_.data(), serial_.data()};
  char** arguments_ = words_.data();
  Session alone_{count_, arguments_};
};

TEST_F(Restart, IsFromNowhereUnlessAskedFor) {
  EXPECT_EQ(from("", "", std::nullopt), "");
  EXPECT_EQ(from(file_, ""), "");
}

TEST_F(Restart, IsFromTheCheckpointThatIsNamed) {
  leave_a_checkpoint(this_tree);
  EXPECT_EQ(from("", file_), file_);
  EXPECT_EQ(from(file_, file_), file_);
  const auto elsewhere = (folder_ / "other").string();
  EXPECT_EQ(from(elsewhere, file_), file_);
}

TEST_F(Restart, IsFromTheOneBeforeADamagedOneAndSaysSo) {
  leave_a_checkpoint(this_tree);
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const auto name = entry.path().filename().string();
    if (name == "state") fs::copy(entry.path(), folder_ / "state.previous");
  }
  std::ofstream(file_) << "damaged";
  std::string found;
  const auto line = said([&] { found = from("", file_); });
  EXPECT_EQ(found, file_ + ".previous");
  EXPECT_THAT(line, HasSubstr("kusabi: "));
  EXPECT_THAT(line, HasSubstr("state"));
}

TEST_F(Restart, RefusesTheCheckpointOfAnotherTree) {
  leave_a_checkpoint(this_tree + 1);
  EXPECT_THAT(
      refused("", file_),
      ThrowsMessage<WrongInput>("--restart " + file_ + ": is the checkpoint of another problem"));
}

TEST_F(Restart, RefusesWhatIsNotThere) {
  EXPECT_THAT(refused("", file_), ThrowsMessage<WrongInput>(HasSubstr("--restart " + file_)));
}

TEST_F(Restart, RefusesToTakeThePlaceOfACheckpoint) {
  leave_a_checkpoint(this_tree);
  const auto message = fmt::format(
      "--checkpoint {0}: exists already; expected --restart {0} to resume from it, its "
      "removal, or another name",
      file_);
  EXPECT_THAT(refused(file_, ""), ThrowsMessage<WrongInput>(message));
  EXPECT_THAT(refused(file_, "another"), ThrowsMessage<WrongInput>(message));
}

TEST_F(Restart, RefusesAFolderThatCannotBeWrittenTo) {
  const auto nowhere = (folder_ / "none" / "state").string();
  EXPECT_THAT(refused(nowhere, ""),
              ThrowsMessage<WrongInput>(
                  fmt::format("--checkpoint {}: cannot be written: {}: No such file or directory",
                              nowhere, (folder_ / "none").string())));
}

}  // namespace
}  // namespace kusabi::run
