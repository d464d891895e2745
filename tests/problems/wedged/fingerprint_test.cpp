// The fingerprint depends on all data of a problem, and on nothing else.
#include "support/fingerprint.hpp"

#include <functional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

TEST(Fingerprint, IsTheFnvHashOfItsBytes) {
  // The published value of FNV-1a, 64 bits, of no byte at all; and of eight zero bytes the basis
  // times the prime to the eighth.
  EXPECT_EQ(support::Fingerprint().value(), 0xCBF29CE484222325U);
  support::Fingerprint zero;
  zero.add(std::uint64_t{0});
  std::uint64_t expected = 0xCBF29CE484222325U;
  for (int byte = 0; byte < 8; ++byte) expected *= 0x100000001B3U;
  EXPECT_EQ(zero.value(), expected);
}

TEST(Fingerprint, TakesTheLeastSignificantByteFirst) {
  // Both hash the bytes 1, 0, 0, 0, 0, 0, 0, 0 and then 'a'.
  support::Fingerprint text;
  text.add(std::string_view("a"));
  support::Fingerprint number;
  number.add(std::uint64_t{1});
  EXPECT_EQ(text.value(), (number.value() ^ std::uint64_t{'a'}) * 0x100000001B3U);
}

TEST(Fingerprint, IgnoresTheSignOfZero) {
  support::Fingerprint positive;
  support::Fingerprint negative;
  positive.add(0.0);
  negative.add(-0.0);
  EXPECT_EQ(positive.value(), negative.value());
}

TEST(Fingerprint, ChangesWithAllDataOfTheProblem) {
  const std::vector<std::function<void(Structure&)>> changes = {
      [](Structure&) {},
      [](Structure& s) { s.units.length = std::string("cm"); },
      [](Structure& s) { s.units.force = std::string("N"); },
      [](Structure& s) { s.coordinates(1, 5) += 1e-9; },
      [](Structure& s) { s.members[0].axial_stiffness *= 1 + 1e-9; },
      [](Structure& s) { std::swap(s.members[0], s.members[1]); },
      [](Structure& s) { s.members[0].first = 1; },
      [](Structure& s) {
        s.members.push_back({1, 2, 1.0});
      },
      [](Structure& s) {
        s.fixed[2] = {true, false, false};
      },
      [](Structure& s) {
        s.fixed[2] = {false, true, false};
      },
      [](Structure& s) { s.contact[0].node = 5; },
      [](Structure& s) { s.contact[0].normal *= -1; },
      [](Structure& s) { s.contact[0].tangent = Eigen::Vector2d(-1, 0); },
      [](Structure& s) { s.contact[0].friction = 2; },
      [](Structure& s) {
        s.contact.push_back({5, Eigen::Vector2d(0, -1), std::nullopt, 1});
      },
      [](Structure& s) {
        test::add_node(s, Eigen::Vector2d(9, 9));
        test::fix(s, 8);
      },
  };
  std::set<std::uint64_t> seen;
  for (const auto& change : changes) {
    Structure structure = test::cantilever(3);
    change(structure);
    seen.insert(wedged_problem(checked(structure)).provenance.fingerprint);
  }
  EXPECT_EQ(seen.size(), changes.size());
}

constexpr const char* tidy = R"(name = "two bars"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
left = [0.0, 0.0]
top = [1.0, 1.0]
tip = [1.0, 0.0]
[[members]]
EA = 1.0
between = [["left", "tip"], ["top", "tip"]]
[[supports]]
nodes = ["left", "top"]
[[contact]]
nodes = ["tip"]
normal = [-1.0, 1.0]
)";

constexpr const char* untidy = R"(# another hand wrote the same problem, with other names
contact = [{ normal = [-2, 2], nodes = ["c"] }]
units.force = "kN"
units.length = "m"

dimension = 2
name = "the same"
[[supports]]
   fixed = ["y", "x"]
   nodes = ["b", "a"]   # the order of the list does not matter

[[members]]
between = [["a", "c"]]
EA = 1

[[members]]
between = [["b", "c"]]
EA = 1e0
[nodes]
a = [-0.0, 0]
b = [1, 1]
c = [1.000, 0]
)";

TEST(Fingerprint, DoesNotChangeWithTheSpelling) {
  EXPECT_EQ(wedged_problem(read_structure(tidy, "tidy")).provenance.fingerprint,
            wedged_problem(read_structure(untidy, "untidy")).provenance.fingerprint);
}

}  // namespace
}  // namespace kusabi::problems
