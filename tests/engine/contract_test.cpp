// Contract tests: a violated contract ends a search in every build, with the sentence and the
// source location.
#include "engine/detail/contract.hpp"

#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/detail/nodes/frontier.hpp"
#include "engine/detail/nodes/heap.hpp"
#include "engine/detail/protocol/lifelines.hpp"
#include "engine/detail/protocol/victims.hpp"
#include "engine/search.hpp"
#include "tests/engine/random_tree.hpp"

namespace kusabi::engine {
namespace {

using testing::MatchesRegex;

std::string complaint(auto&& act) {
  try {
    act();
    return "none";
  } catch (const ContractBroken& broken) {
    return broken.what();
  }
}

TEST(Contract, ViolationNamesFileLineAndCondition) {
  EXPECT_EQ(complaint([] { ensure(true, "the sun rises"); }), "none");
  EXPECT_THAT(complaint([] { ensure(false, "the sun rises"); }),
              MatchesRegex("engine/contract_test.cpp:[0-9]+: contract violated: the sun rises"));
}

TEST(Contract, IsCheckedByFrontierAndHeap) {
  Frontier<int> frontier;
  EXPECT_THROW(frontier.open(), ContractBroken);
  EXPECT_THAT(
      complaint([&] { frontier.give(100); }),
      MatchesRegex(
          "engine/detail/nodes/frontier.hpp:[0-9]+: contract violated: a frontier gives nodes "
          "only if one is left"));
  frontier.add_root(1);
  EXPECT_THROW(frontier.take({{}, {{1, 0, 0}}}), ContractBroken);
  Heap<int> heap;
  EXPECT_THROW(heap.give(100), ContractBroken);
}

TEST(Contract, IsCheckedByVictimsAndLifelines) {
  EXPECT_THROW(Victims(0, 1, 1), ContractBroken);
  Lifelines lifelines(0, 8);
  EXPECT_THROW(lifelines.take(), ContractBroken);
  EXPECT_THROW(lifelines.served_by(3), ContractBroken);
}

// One rank of two, whose other rank sends answers without a request.
class Babbling final : public Transport {
 public:
  explicit Babbling(MessageTag tag) : tag_(tag) {}
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int size() const override { return 2; }
  [[nodiscard]] double now() const override { return 0; }
  void send(int /*to*/, MessageTag /*tag*/, Bytes /*body*/) override {}
  std::optional<Message> receive() override { return Message{1, tag_, {}}; }
  void join_reduction(const Reduction& /*own*/) override {}
  std::optional<Reduction> reduction() override { return std::nullopt; }
  void broadcast(Bytes& /*bytes*/) override {}
  void abandon(const std::string& reason) override { abandoned = reason; }

  std::string abandoned;

 private:
  MessageTag tag_;
};

TEST(Contract, IsViolatedByAnswersWithoutARequest) {
  for (const auto tag : {MessageTag::transfer, MessageTag::refusal}) {
    Babbling transport(tag);
    examples::RandomTree tree(1, 5);
    EXPECT_THAT(
        complaint([&] { search(tree, transport); }),
        MatchesRegex("engine/.*: contract violated: a (transfer|refusal) comes from the rank "
                     "that was asked"));
    EXPECT_NE(transport.abandoned, "");
  }
}

}  // namespace
}  // namespace kusabi::engine
