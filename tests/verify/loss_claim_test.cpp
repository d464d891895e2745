// Claims about the loss of members: yield forces divided by a dynamic factor.
#include "verify/limit/loss_claim.hpp"

#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nodes/evidence/verified_structure.hpp"
#include "problems/files/structure_file.hpp"
#include "searched.hpp"
#include "verify/limit/loss_certificate.hpp"

namespace kusabi::verify {
namespace {

// Two bars in line on both sides of a load along them, each of strength 5: after the loss of one,
// with a dynamic factor of 3, the other one carries 5/3, which no double is.
constexpr double below = 0x1.aaaaaaaaaaaaap+0;
constexpr double above = 0x1.aaaaaaaaaaaabp+0;

std::string certificate(double lower, double force) {
  const auto states = [&](int member) {
    return fmt::format("state 1 {}\nforces {:a} 1 {} {}{:a}\n", member, lower, member,
                       member == 0 ? "" : "-", force);
  };
  return sealed(fmt::format(
      "kusabi certificate 5 loss\ndimension 2\nnodes 3\nnode 0x0p+0 fixed 0x0p+0 fixed\n"
      "node 0x1p+0 free 0x0p+0 fixed\nnode 0x1p+1 fixed 0x0p+0 fixed\nmembers 2\n"
      "member 0 1 {0:a} {0:a}\nmember 1 2 {0:a} {0:a}\ncase\ndead 0\nreference 1\n"
      "force 1 0x1p+0 0x0p+0\nuncertain 0\nlose 1 0x1.8p+1\nkept 0\nlost 1 0\nload\nmotion 0x1p+0\n"
      "lower {1:a}\nstates 2\n{2}{3}end\n",
      5.0 / 3, lower, states(0), states(1)));
}

struct Said {
  std::vector<std::string> refusals;
  double upper = 0;
};

Said said(double lower, double force) {
  const auto statements = read_loss_certificate(certificate(lower, force), "cert");
  const auto file = problems::load_structure(KUSABI_SOURCE_DIR "/tests/cases/bars_in_line.toml");
  const LossClaim claim(statements.front(), evidence::verified_structure(file));
  Said result;
  if (claim.difference()) return {.refusals = {*claim.difference()}};
  result.refusals = claim.check_loss(result.upper);
  for (std::size_t k = 0; k < statements.front().states.size(); ++k) {
    if (auto why = claim.refusal_of_state(k)) result.refusals.push_back(*why);
  }
  return result;
}

TEST(LossClaim, RoundsQuotientsOfYieldForcesToTheSafeSide) {
  const auto good = said(below, below);
  EXPECT_THAT(good.refusals, testing::IsEmpty());
  EXPECT_GE(good.upper, above);
  // The nearest double exceeds 5/3, as the factor and as the force that would carry it.
  EXPECT_EQ(said(above, above).refusals.size(), 2U);
}

TEST(LossClaim, RequiresForcesInEquilibrium) {
  EXPECT_EQ(said(0x1p+9, 0x1p+20).refusals.size(), 2U);
}

}  // namespace
}  // namespace kusabi::verify
