// Theorems on the loss of members: yield forces divided by a dynamic factor.
#include "verify/limit/truss_proof.hpp"

#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nodes/evidence/verified_structure.hpp"
#include "problems/files/structure_file.hpp"
#include "searched.hpp"
#include "verify/limit/truss_certificate.hpp"
#include "verify/limit/truss_consistency.hpp"

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
      "kusabi certificate 5 truss\ndimension 2\nnodes 3\nnode 0x0p+0 fixed 0x0p+0 fixed\n"
      "node 0x1p+0 free 0x0p+0 fixed\nnode 0x1p+1 fixed 0x0p+0 fixed\nmembers 2\n"
      "member 0 1 {0:a} {0:a} {0:a}\nmember 1 2 {0:a} {0:a} {0:a}\ncases 1\ncase\ndead 0\n"
      "reference 1\nforce 1 0x1p+0 0x0p+0\nuncertain 0\ntheorems 1\n"
      "theorem 1 largest strength 1 0x1.8p+1 0\nlost 1 0\nload\nmotion 0x1p+0\n"
      "states 2 {1:a}\n{2}{3}end\n",
      5.0, lower, states(0), states(1)));
}

struct Said {
  std::vector<std::string> refusals;
  double upper = 0;
};

Said said(double lower, double force) {
  const auto theorems = read_truss_certificate(certificate(lower, force), "cert");
  const auto file = problems::load_structure(KUSABI_SOURCE_DIR "/tests/cases/bars_in_line.toml");
  const auto& theorem = theorems.front();
  if (const auto why = truss_difference(theorem, evidence::verified_structure(file)))
    return {.refusals = {*why}};
  const TrussProof proof(theorem);
  Said result;
  result.refusals = proof.refusals(result.upper);
  for (std::size_t k = 0; k < proof.pieces(); ++k) {
    const auto found = proof.lower(k);
    if (const auto* const why = std::get_if<std::string>(&found)) result.refusals.push_back(*why);
  }
  return result;
}

TEST(TrussProof, RoundsQuotientsOfYieldForcesToTheSafeSide) {
  const auto good = said(below, below);
  EXPECT_THAT(good.refusals, testing::IsEmpty());
  EXPECT_GE(good.upper, above);
  // The nearest double exceeds 5/3, as the factor and as the force that would carry it.
  EXPECT_EQ(said(above, above).refusals.size(), 2U);
}

TEST(TrussProof, RequiresForcesInEquilibrium) {
  EXPECT_EQ(said(0x1p+9, 0x1p+20).refusals.size(), 2U);
}

}  // namespace
}  // namespace kusabi::verify
