// Messages of errors that end a run.
#include "engine/transport/reason.hpp"

#include <new>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/search.hpp"

namespace kusabi::engine {
namespace {

using testing::StartsWith;

/// A problem whose root needs more memory than there is.
struct Huge {
  using Node = int;
  using Solution = int;
  Node root() const { return 0; }
  void expand(Node&& /*node*/, Expansion<Huge>& /*out*/) { throw std::bad_alloc(); }
};

TEST(ReasonOf, ExhaustedMemoryIsASentence) {
  Huge huge;
  try {
    search(huge);
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_THAT(reason_of(error.what()), StartsWith("node root: out of memory; expected"));
  }
  EXPECT_THAT(reason_of(std::bad_alloc().what()), StartsWith("out of memory; expected"));
}

TEST(ReasonOf, OfOtherErrorsIsTheirMessage) {
  EXPECT_EQ(reason_of("disk full"), "disk full");
  EXPECT_EQ(reason_of(""), "");
}

}  // namespace
}  // namespace kusabi::engine
