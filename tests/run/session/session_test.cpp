// Session of one process: no MPI, rank 0 prints, and input errors keep their type. Several
// processes are in mpi_tests.
#include "run/session/session.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace kusabi::run {
namespace {

using testing::ThrowsMessage;

// The call `kusabi patterns x.toml --serial`, independent of the launcher of this test.
class SessionOfOne : public testing::Test {
 private:
  std::vector<std::string> words_{"kusabi", "patterns", "x.toml", "--serial"};
  std::vector<char*> pointers_ = [this] {
    std::vector<char*> all;
    for (auto& word : words_) all.push_back(word.data());
    return all;
  }();
  int count_ = static_cast<int>(pointers_.size());
  char** arguments_ = pointers_.data();

 protected:
  Session session_{count_, arguments_};
  [[nodiscard]] int count() const { return count_; }
};

TEST_F(SessionOfOne, IsRankZeroAndPrints) {
  EXPECT_EQ(session_.ranks(), 1);
  EXPECT_EQ(session_.transport().rank(), 0);
  EXPECT_TRUE(session_.is_first());
  EXPECT_EQ(count(), 4);  // --serial is read by the command as well
}

TEST_F(SessionOfOne, ReceivesItsOwnResult) {
  int calls = 0;
  EXPECT_EQ(session_.from_first_rank([&] { return ++calls; }), 1);
  session_.from_first_rank([&] { ++calls; });
  EXPECT_EQ(calls, 2);
}

// A move-only value reaches the caller.
TEST_F(SessionOfOne, DoesNotCopyThePreparedValue) {
  const std::string text(100, 'x');
  std::string own = text;
  const char* const place = own.data();
  const auto got = session_.from_first_rank([&] { return std::move(own); });
  EXPECT_EQ(got, text);
  EXPECT_EQ(got.data(), place);
}

TEST_F(SessionOfOne, ThrowsInputErrorsAsOneType) {
  EXPECT_THAT([&] { session_.from_first_rank([] { throw WrongInput("--mu: missing"); }); },
              ThrowsMessage<WrongInput>("--mu: missing"));
  const support::InputError error("x.toml", {.line = 3, .column = 7}, "EA is -3; expected more");
  EXPECT_THAT([&] { session_.from_first_rank([&]() -> int { throw error; }); },
              ThrowsMessage<WrongInput>("x.toml:3:7: EA is -3; expected more"));
}

TEST_F(SessionOfOne, DoesNotChangeOtherErrors) {
  EXPECT_THAT([&] { session_.from_first_rank([] { throw std::logic_error("a defect"); }); },
              ThrowsMessage<std::logic_error>("a defect"));
}

}  // namespace
}  // namespace kusabi::run
