// Certificates of trusses: proofs, consistency with the truss of a file, harmless faulty texts.
#include "verify/limit/truss_certificate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "searched.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/sign_cover.hpp"
#include "verify/limit/truss_consistency.hpp"
#include "verify/limit/truss_proof.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {
namespace {

using testing::HasSubstr;

// A tip on a level bar and one that rises by 45 degrees to the wall, both with yield force 1; the
// reference load is 1 downwards. With r along the wall uncertain by +-alpha the factor is
// min(1/sqrt 2, 1 - alpha).
Structure truss() {
  Structure structure;
  structure.dimension = 2;
  structure.names = {"low", "high", "tip"};
  structure.coordinates = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  structure.fixed = {{true, true, false}, {true, true, false}, {false, false, false}};
  structure.bars = {{0, 2, 1, 1, 1, 1}, {1, 2, 1, 1, 1, 1}};
  structure.reference = {{2, {0, -1, 0}}};
  return structure;
}

// Proof of the factor 1/2 for alpha = 1/2, from below up to 1e-9.
TrussTheorem theorem() {
  TrussTheorem result{.truss = truss()};
  result.truss.uncertain = {{{2, 0, 1}}};
  result.truss.half_widths = {0.5};
  result.truss.load_names = {""};
  result.collapse = {.load = {-0.5}, .motion = {-1, -1}};
  result.cuts = {{0, 0.0, {{0, 1.0}}}};
  LimitNode node;
  node.signs = {0};
  node.one_sided = {0};
  node.factor = 0.5 - 1e-9;
  node.forces = {-node.factor, node.factor / std::sqrt(0.5)};
  node.shares = {{0, 0.5}};
  result.nodes = {node};
  return result;
}

TEST(LimitProof, ProvesBothBoundsForTheTruss) {
  const auto given = theorem();
  const auto meant = limit_truss(given.truss).value();
  ASSERT_EQ(meant.columns.size(), 2U);
  for (const auto& [place, entry] : meant.columns[0]) {
    EXPECT_EQ(entry.error.sign(), 0);  // its cosines are 1 and 0
  }
  ASSERT_FALSE(meant.columns[1].empty());
  for (const auto& [place, entry] : meant.columns[1]) {
    EXPECT_GT(entry.error.nearest(), 0);  // the root of 1/2 is no double
    EXPECT_LT(entry.error.nearest(), 1e-90);
    EXPECT_NEAR(square(entry.value).nearest(), 0.5, 1e-15);
  }
  const LimitProof proof(meant, given.cuts);
  const auto upper = std::get<mpq_class>(proof.upper(given.collapse));
  EXPECT_GT(upper, mpq_class(0.5));  // the motion stretches the rising bar by a rounding error
  EXPECT_LT(upper.get_d(), 0.5 + 1e-14);
  EXPECT_EQ(std::get<mpq_class>(proof.lower(given.nodes[0])), mpq_class(0.5 - 1e-9));
}

// The proof includes the errors: with larger ones the same evidence proves less.
TEST(LimitProof, ErrorsRaiseTheUpperBoundAndPreventTheLower) {
  const auto given = theorem();
  const auto honest = limit_truss(given.truss).value();
  const Dyadic error(0x1p-20);
  const auto expect = [&](const LimitTruss& coarse, double above, const char* refusal) {
    const LimitProof proof(coarse, given.cuts);
    EXPECT_GE(std::get<mpq_class>(proof.upper(given.collapse)).get_d(), above);
    EXPECT_THAT(std::get<std::string>(proof.lower(given.nodes[0])), HasSubstr(refusal));
  };
  auto coarse = honest;
  for (auto& [place, entry] : coarse.columns[1]) entry.error = error;
  expect(coarse, 0.5 + 0x1p-20, "member low-tip yields");
  coarse = honest;
  for (auto& [place, entry] : coarse.columns[0]) entry.error = Dyadic(1.0);
  expect(coarse, 0.5, "no bound of motions");
}

TEST(TrussDifference, AnotherTrussIsRefused) {
  const auto refusal = [&](const auto& change) {
    auto other = truss();
    change(other);
    return truss_difference(theorem(), other).value_or("");
  };
  EXPECT_EQ(refusal([](Structure&) {}), "");
  EXPECT_EQ(refusal([](Structure& s) { s.bars[0].axial_stiffness = 7; }),
            "");  // not used by limit analysis
  EXPECT_THAT(refusal([](Structure& s) { s.coordinates[1][1] += 1e-12; }),
              HasSubstr("the recorded place or support of node high is not that of the truss"));
  EXPECT_THAT(refusal([](Structure& s) { s.bars[0].tension = 1 + 1e-15; }),
              HasSubstr("the recorded yield forces of member low-tip are not those of the truss"));
  EXPECT_THAT(refusal([](Structure& s) { s.bars[1].compression = 2; }), HasSubstr("yield forces"));
  EXPECT_THAT(refusal([](Structure& s) { s.bars[1].residual = 0.5; }), HasSubstr("yield forces"));
  EXPECT_THAT(refusal([](Structure& s) { s.dead = {{2, {0, 1e-9, 0}}}; }), HasSubstr("dead load"));
  EXPECT_THAT(refusal([](Structure& s) { s.reference[0].components[1] = -1.5; }),
              HasSubstr("reference load"));
  EXPECT_THAT(refusal([](Structure& s) { s.uncertain.emplace(); }), HasSubstr("uncertain loads"));
  EXPECT_THAT(refusal([](Structure& s) {
                s.uncertain = {{{2, 0, 0.5}}};
              }),
              HasSubstr("uncertain loads"));
  EXPECT_EQ(refusal([](Structure& s) { s.uncertain = {{{2, 0, 1}}}; }), "");
  EXPECT_THAT(refusal([](Structure& s) { s.fixed[2][0] = true; }), HasSubstr("displacements"));
  EXPECT_THAT(refusal([](Structure& s) { s.bars.pop_back(); }), HasSubstr("members"));
  // Fixed nodes have no displacements, but names, by which lost members are called.
  EXPECT_THAT(refusal([](Structure& s) {
                std::swap(s.coordinates[0], s.coordinates[1]);
                for (auto& bar : s.bars) bar.first = bar.first <= 1 ? 1 - bar.first : bar.first;
              }),
              HasSubstr("the recorded place or support of node "));
  EXPECT_THAT(refusal([](Structure& s) { std::swap(s.bars[0].first, s.bars[0].second); }),
              HasSubstr("the recorded nodes of member "));
  EXPECT_THAT(refusal([](Structure& s) {
                s.coordinates.push_back({9, 9, 0});
                s.fixed.push_back({true, true, true});
                s.names.emplace_back("far");
              }),
              HasSubstr("another number of nodes"));
}

std::string text_of(const TrussTheorem& given) {
  return truss_certificate_text({&given, 1});
}

std::string complaint(const std::string& text) {
  try {
    read_truss_certificate(text, "cert");
    return {};
  } catch (const CertificateError& error) {
    return error.what();
  }
}

TEST(TrussCertificate, AllocatesNoMoreThanItsFileCanContain) {
  const auto text = text_of(theorem());
  ASSERT_EQ(complaint(text), "");
  struct Wrong {
    const char* what;
    const char* with;
    const char* said;
  };
  const Wrong table[] = {
      {"nodes 3", "nodes 200000",
       "cert:3: 'nodes 200000', expected 'nodes' and a number that the rest"},
      {"members 2", "members 9000000", "expected 'members' and a number that the rest of the file"},
      {"member 0 2", "member 0 3", "below 3"},
      {"member 0 2", "member 2 2", "expected two nodes at different places"},
      {"node 0x1p+0 free", "node 0x0p+0 free", "expected two nodes at different places"},
      {"0 2 0x1p+0 0x1p+0 0x1p+0", "0 2 0x1p+0 0x1p+0 0x1p+1", "the last one at most the second"},
      {"uncertain 1", "uncertain 4000000", "expected 'uncertain' and a number that the rest"},
      {"column 0x1p-1 1 2 0 0x1p+0", "column 0x1p-1 1 2 0 0x0p+0", "components, not zero"},
      {"column 0x1p-1 1 2 0 0x1p+0", "column 0x1p-1 1 1 0 0x1p+0", "on free displacements"},
      {"column 0x1p-1 1 2 0 0x1p+0", "column 0x1p-1 9 2 0 0x1p+0", "that the line holds"},
      {"column 0x1p-1 1 2 0 0x1p+0", "column 0x1p-1 0", "components, not zero"},
      {"theorems 1", "theorems 2", "expected 'theorem' and its fields"},
      {"theorem 1 largest", "theorem 2 largest", "expected 'theorem' and its load case"},
      {"theorem 1 largest", "theorem 1 least", "expected 'theorem' and its load case"},
      {"theorem 1 largest strength", "theorem 1 largest residual", "'theorem' and its load case"},
      {"strength 0 0x1p+0 0", "strength 0 0x1p+1 0", "losses, none with factor 1"},
      {"strength 0 0x1p+0 0", "strength 4000000 0x1p+0 0", "below 3"},
      {"strength 0 0x1p+0 0", "strength 1 0x1p-1 0", "losses, none with factor 1"},
      {"strength 0 0x1p+0 0", "strength 1 0x1p+0 2 1 0", "ascending members"},
      {"lost 0", "lost 1 0", "at most as many as are lost"},
      {"cuts 1", "cuts 4000000", "expected 'cuts' and a number that the rest of the file holds"},
      {"nodes 1", "nodes 4000000", "expected 'nodes' and a number that the rest of the file holds"},
  };
  for (const auto& [what, with, said] : table) {
    auto wrong = text;
    ASSERT_NE(wrong.find(what), std::string::npos) << what;
    wrong.replace(wrong.find(what), std::string(what).size(), with);
    EXPECT_THAT(complaint(sealed(wrong)), HasSubstr(said)) << with;
  }
}

// More columns of T than displacements are harmless; nodes without signs for them would not be.
TEST(TrussCertificate, AllocatesNoSignsThatNoLineContains) {
  auto given = theorem();
  given.truss.uncertain->assign(5000, {{2, 0, 1.0}});
  given.truss.half_widths.assign(5000, 0.5);
  given.truss.load_names.assign(5000, "");
  given.collapse.load.assign(5000, 0.5);
  EXPECT_EQ(complaint(text_of(given)), "");
  given.nodes.assign(1000, given.nodes.front());
  EXPECT_THAT(complaint(text_of(given)), HasSubstr("expected a sign or a share for each column"));
}

// A motion with work 2^-1060 of the reference load: the upper bound is beyond all doubles.
TEST(TrussCertificate, RoundsABoundBeyondAllDoublesToInfinity) {
  const mpq_class far = Dyadic(mpz_class(3), 1060).rational();
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(rounded_up(far), std::numeric_limits<double>::infinity());
  EXPECT_EQ(rounded_down(far), largest);
  EXPECT_EQ(rounded_down(mpq_class(-far)), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(rounded_up(mpq_class(-far)), -largest);
  EXPECT_EQ(rounded_up(mpq_class(1, 4)), 0.25);
  EXPECT_EQ(rounded_down(mpq_class(1, 3)), std::nextafter(rounded_up(mpq_class(1, 3)), 0.0));
  auto given = theorem();
  given.collapse.motion = {-1, -0x1p-1060};
  double upper = 0;
  EXPECT_THAT(TrussProof(given).refusals(upper),
              testing::Contains(HasSubstr("exceeds the range of double precision")));
}

// The bounds that a theorem proves, an infinite one without a proof.
std::pair<double, double> bounds_of(const TrussTheorem& given) {
  const TrussProof proof(given);
  std::pair<double, double> bounds;
  auto& [lower, upper] = bounds;
  lower = upper = std::numeric_limits<double>::infinity();
  if (!proof.refusals(upper).empty())
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (std::size_t piece = 0; piece < proof.pieces(); ++piece) {
    const auto found = proof.lower(piece);
    const auto* const value = std::get_if<double>(&found);
    lower = std::min(lower, value == nullptr ? -std::numeric_limits<double>::infinity() : *value);
  }
  return bounds;
}

// Expects that bounds proved for truss() with alpha = 1/2, if any, contain its factor 1/2.
void expect_no_false_claim(const TrussTheorem& given) {
  const auto [lower, upper] = bounds_of(given);
  if (given.claim != LimitClaim::largest || given.losses > 0) return;
  auto structure = theorem().truss;
  if (truss_difference(given, structure)) return;
  EXPECT_GE(upper, 0.5);
  EXPECT_LE(lower, 0.5);
}

TEST(LimitProof, ShowsNoLoadWithoutFactorForNoReferenceLoad) {
  auto given = theorem();
  given.truss.reference.clear();
  const auto meant = limit_truss(given.truss).value();
  EXPECT_FALSE(LimitProof(meant).shows_no_factor(given.collapse));
  EXPECT_FALSE(LimitProof(LimitTruss()).shows_no_factor({}));
}

TEST(TrussCertificate, OneNodeWithManySignsCoversNoOthers) {
  constexpr std::size_t columns = 300000;
  std::vector<LimitNode> nodes(1);
  nodes.front().signs.assign(columns, 1);
  EXPECT_EQ(flaw_of_sign_cover(nodes, columns), "no node covers some combination of signs");
  EXPECT_TRUE(flaw_of_sign_cover({}, columns));
}

// 0.1 + 0.3 - 0.4 is 0 in double precision, and -2.8e-17 exactly: the displacement has no load, and
// is uncertain if the file does not say which are. The proof includes the load.
TEST(TrussDifference, AdmitsForcesOfTheSameSum) {
  auto structure = truss();
  for (const double force : {0.1, 0.3, -0.4}) structure.dead.push_back({2, {force, 0, 0}});
  auto recorded = theorem();
  EXPECT_THAT(truss_difference(recorded, structure).value_or(""), HasSubstr("dead load"));
  for (const double force : {-0.4, 0.3, 0.1}) recorded.truss.dead.push_back({2, {force, 0, 0}});
  EXPECT_EQ(truss_difference(recorded, structure), std::nullopt);
  EXPECT_LT(limit_truss(recorded.truss)->dead[0].nearest(), 0);
}

TEST(TrussCertificate, NoAlterationProvesAFalseClaim) {
  const auto text = text_of(theorem());
  std::mt19937_64 generator(5);
  const std::string likely = "0123456789abcdef-+xp \n";
  const std::string extremes[] = {"0x1p-1060",
                                  "0x0.0000000000001p-1022",
                                  "0x1.fffffffffffffp+1023",
                                  "-0x1.fffffffffffffp+1023",
                                  "0x1p-1000",
                                  "0x1p+99999999999",
                                  "0x0p+0",
                                  "4294967296",
                                  "18446744073709551615",
                                  "9999999"};
  int read = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    auto altered = text;
    for (auto changes = 1 + generator() % 4; changes > 0; --changes) {
      const auto place = generator() % altered.size();
      const auto start = altered.find(' ', place);
      if (generator() % 2 == 0 && start != std::string::npos) {
        const auto end = altered.find_first_of(" \n", start + 1);
        altered.replace(start + 1, end - start - 1, extremes[generator() % std::size(extremes)]);
      } else {
        altered[place] = likely[generator() % likely.size()];
      }
    }
    try {
      for (const auto& given : read_truss_certificate(sealed(altered), "cert"))
        expect_no_false_claim(given);
      ++read;
    } catch (const CertificateError& error) {
      EXPECT_THAT(error.what(), HasSubstr("cert"));
    }
  }
  EXPECT_GT(read, 1000);
}

}  // namespace
}  // namespace kusabi::verify
