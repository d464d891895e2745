// Consistency of limit-load certificates with the truss of a file; harmless faulty certificates.
#include "verify/limit/limit_consistency.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "searched.hpp"
#include "verify/limit/sign_cover.hpp"

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
  structure.bars = {{0, 2, 1, 1, 1}, {1, 2, 1, 1, 1}};
  structure.reference = {{2, {0, -1, 0}}};
  return structure;
}

// Proof of the factor 1/2 for alpha = 1/2, from below up to 1e-9.
LimitCertificate evidence() {
  const double half_root = std::sqrt(0.5);
  LimitCertificate certificate;
  certificate.displacements = 2;
  certificate.tension = certificate.compression = {1, 1};
  certificate.columns = {{{0, 1.0}}, {{0, half_root}, {1, -half_root}}};
  certificate.dead = {0, 0};
  certificate.reference = {0, -1};
  certificate.uncertain = {{{0, 1.0}}};
  certificate.alpha = {0.5};
  certificate.load = {-0.5};
  certificate.motion = {-1, -1};
  certificate.cuts = {{0, 0.0, {{0, 1.0}}}};
  LimitNode node;
  node.signs = {0};
  node.one_sided = {0};
  node.factor = 0.5 - 1e-9;
  node.forces = {-node.factor, node.factor / half_root};
  node.shares = {{0, 0.5}};
  certificate.nodes = {node};
  return certificate;
}

LimitTruss agreed(const LimitCertificate& certificate, const Structure& structure) {
  auto found = limit_consistency(certificate, structure);
  if (const auto* why = std::get_if<std::string>(&found)) {
    ADD_FAILURE() << *why;
    return {};
  }
  return std::get<LimitTruss>(found);
}

TEST(LimitConsistency, ProvesBothBoundsForTheTruss) {
  const auto certificate = evidence();
  const auto meant = agreed(certificate, truss());
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
  const LimitProof proof(certificate, meant);
  const auto upper = std::get<mpq_class>(proof.upper());
  EXPECT_GT(upper, mpq_class(0.5));  // the motion stretches the rising bar by a rounding error
  EXPECT_LT(upper.get_d(), 0.5 + 1e-14);
  EXPECT_EQ(std::get<mpq_class>(proof.lower(certificate.nodes[0])), mpq_class(0.5 - 1e-9));
}

// The proof includes the errors: with larger ones the same evidence proves less.
TEST(LimitConsistency, ErrorsRaiseTheUpperBoundAndPreventTheLower) {
  const auto certificate = evidence();
  const Dyadic error(0x1p-20);
  auto coarse = agreed(certificate, truss());
  for (auto& [place, entry] : coarse.columns[1]) entry.error = error;
  const LimitProof of_columns(certificate, coarse);
  EXPECT_GE(std::get<mpq_class>(of_columns.upper()).get_d(), 0.5 + 0x1p-20);
  EXPECT_THAT(std::get<std::string>(of_columns.lower(certificate.nodes[0])),
              HasSubstr("member low-tip yields"));
  coarse = agreed(certificate, truss());
  coarse.dead[0].error = error;
  const LimitProof of_dead(certificate, coarse);
  EXPECT_GE(std::get<mpq_class>(of_dead.upper()).get_d(), 0.5 + 0x1p-20);
  EXPECT_THAT(std::get<std::string>(of_dead.lower(certificate.nodes[0])), HasSubstr("yields"));
  coarse = agreed(certificate, truss());
  coarse.reference[1].error = error;
  const LimitProof of_reference(certificate, coarse);
  EXPECT_GE(std::get<mpq_class>(of_reference.upper()).get_d(), 0.5 + 0x1p-22);
  EXPECT_THAT(std::get<std::string>(of_reference.lower(certificate.nodes[0])), HasSubstr("yields"));
  coarse = agreed(certificate, truss());
  for (auto& [place, entry] : coarse.columns[0]) entry.error = Dyadic(1.0);
  EXPECT_THAT(std::get<std::string>(LimitProof(certificate, coarse).lower(certificate.nodes[0])),
              HasSubstr("no bound of motions"));
}

TEST(LimitConsistency, AnotherTrussIsRefused) {
  const auto refusal = [&](const auto& change) {
    auto other = truss();
    change(other);
    const auto found = limit_consistency(evidence(), other);
    const auto* const why = std::get_if<std::string>(&found);
    return why == nullptr ? std::string() : *why;
  };
  EXPECT_EQ(refusal([](Structure&) {}), "");
  EXPECT_EQ(refusal([](Structure& s) { s.bars[0].axial_stiffness = 7; }),
            "");  // not used by limit analysis
  EXPECT_THAT(refusal([](Structure& s) { s.coordinates[1][1] += 1e-12; }),
              HasSubstr("the recorded direction of member high-tip is not that of the truss"));
  EXPECT_THAT(refusal([](Structure& s) { s.bars[0].tension = 1 + 1e-15; }),
              HasSubstr("the recorded yield forces of member low-tip are not those of the truss"));
  EXPECT_THAT(refusal([](Structure& s) { s.bars[1].compression = 2; }), HasSubstr("yield forces"));
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
}

TEST(LimitConsistency, RefusesRepeatedAndMissingEntries) {
  auto certificate = evidence();
  certificate.columns[0] = {{0, 0.5}, {0, 0.5}};
  EXPECT_TRUE(std::holds_alternative<std::string>(limit_consistency(certificate, truss())));
  certificate = evidence();
  certificate.columns[0].clear();
  EXPECT_TRUE(std::holds_alternative<std::string>(limit_consistency(certificate, truss())));
  certificate = evidence();
  certificate.columns[0].emplace_back(1, 0x1p-60);
  const auto meant = agreed(certificate, truss());  // a rounding of 0
  for (const auto& [place, entry] : meant.columns[0]) EXPECT_EQ(entry.error.sign(), 0);
}

std::string text_of(const LimitCertificate& certificate) {
  const LimitStatement one{{}, LimitClaim::largest, certificate};
  return limit_certificate_text({&one, 1});
}

std::string complaint(const std::string& text) {
  try {
    read_limit_certificate(text, "cert");
    return {};
  } catch (const CertificateError& error) {
    return error.what();
  }
}

TEST(LimitCertificate, AllocatesNoMoreThanItsFileCanContain) {
  const auto text = text_of(evidence());
  ASSERT_EQ(complaint(text), "");
  struct Wrong {
    const char* what;
    const char* with;
    const char* said;
  };
  const Wrong table[] = {
      {"displacements 2", "displacements 200000",
       "cert:2: 'displacements 200000', expected 'displacements' and a number that the rest of"},
      {"members 2", "members 9000000",
       "cert:3: 'members 9000000', expected 'members' and a number"},
      {"members 2", "members 1", "expected as many members as displacements at least"},
      {"member 0x1p+0 0x1p+0 1 ", "member 0x1p+0 0x1p+0 2 ",
       "the place of one of the entries of B"},
      {"member 0x1p+0 0x1p+0 1 0 0x1p+0", "member 0x1p+0 0x1p+0 2 0", "that the line holds"},
      {"uncertain 1", "uncertain 4000000", "expected 'uncertain' and a number that the rest"},
      {"column 0 0x1p+0", "column 0 0x0p+0", "displacements with a number that is not 0"},
      {"column 0 0x1p+0", "column 0 0x1p+0 2 0x1p+0", "below 2"},
      {"column 0 0x1p+0", "column 0 0x1p+0 1", "a number that is not 0"},
      {"column 0 0x1p+0", "column", "displacements with a number"},
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
TEST(LimitCertificate, AllocatesNoSignsThatNoLineContains) {
  auto certificate = evidence();
  certificate.uncertain.assign(5000, {{0, 1.0}});
  certificate.load.assign(5000, 0.5);
  EXPECT_EQ(complaint(text_of(certificate)), "");
  certificate.nodes.assign(1000, certificate.nodes.front());
  EXPECT_THAT(complaint(text_of(certificate)),
              HasSubstr("expected a sign or a share for each column of T"));
}

// A motion with work 2^-1060 of the reference load: the upper bound is beyond all doubles.
TEST(LimitCertificate, RoundsABoundBeyondAllDoublesToInfinity) {
  const mpq_class far = Dyadic(mpz_class(3), 1060).rational();
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(rounded_up(far), std::numeric_limits<double>::infinity());
  EXPECT_EQ(rounded_down(far), largest);
  EXPECT_EQ(rounded_down(mpq_class(-far)), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(rounded_up(mpq_class(-far)), -largest);
  EXPECT_EQ(rounded_up(mpq_class(1, 4)), 0.25);
  EXPECT_EQ(rounded_down(mpq_class(1, 3)), std::nextafter(rounded_up(mpq_class(1, 3)), 0.0));
  auto certificate = evidence();
  certificate.motion = {-1, -0x1p-1060};
  const auto upper = LimitProof(certificate).upper();
  EXPECT_EQ(rounded_up(std::get<mpq_class>(upper)), std::numeric_limits<double>::infinity());
}

// Expects that bounds proved for truss() with alpha = 1/2, if any, contain its factor 1/2.
void expect_no_false_claim(const LimitCertificate& certificate) {
  auto structure = truss();
  structure.uncertain = {{{2, 0, 1}}};
  const auto found = limit_consistency(certificate, structure);
  const auto* const meant = std::get_if<LimitTruss>(&found);
  if (meant == nullptr || certificate.alpha != evidence().alpha) return;
  const LimitProof proof(certificate, *meant);
  const auto upper = proof.upper();
  if (const auto* value = std::get_if<mpq_class>(&upper)) {
    EXPECT_GE(*value, mpq_class(0.5));
  }
  if (flaw_of_sign_cover(certificate)) return;
  bool is_below = false;  // the least bound of all nodes, or one without a bound
  for (const auto& node : certificate.nodes) {
    const auto lower = proof.lower(node);
    const auto* const value = std::get_if<mpq_class>(&lower);
    is_below = is_below || value == nullptr || *value <= mpq_class(0.5);
  }
  EXPECT_TRUE(is_below);
}

TEST(LimitCertificate, ProvesNoLoadWithoutFactorForNoReferenceLoad) {
  auto certificate = evidence();
  certificate.reference = {0, 0};
  EXPECT_FALSE(LimitProof(certificate).shows_no_factor());
  EXPECT_FALSE(LimitProof(LimitCertificate{}).shows_no_factor());
}

TEST(LimitCertificate, OneNodeWithManySignsCoversNoOthers) {
  LimitCertificate certificate;
  certificate.uncertain.resize(300000);
  certificate.nodes.emplace_back().signs.assign(certificate.uncertain.size(), 1);
  EXPECT_EQ(flaw_of_sign_cover(certificate), "no node covers some combination of signs");
  certificate.nodes.clear();
  EXPECT_TRUE(flaw_of_sign_cover(certificate));
}

// 0.1 + 0.3 - 0.4 is 0 in double precision, and -2.8e-17 exactly: the displacement has no load, and
// is uncertain if the file does not say which are.
TEST(LimitConsistency, AdmitsRoundingErrorsOfLoadsThatCancel) {
  auto structure = truss();
  for (const double force : {0.1, 0.3, -0.4}) structure.dead.push_back({2, {force, 0, 0}});
  const auto meant = agreed(evidence(), structure);
  ASSERT_EQ(meant.dead.size(), 2U);
  EXPECT_LT(meant.dead[0].value.nearest(), 0);
  structure.dead.push_back({2, {1e-9, 0, 0}});
  EXPECT_THAT(std::get<std::string>(limit_consistency(evidence(), structure)),
              HasSubstr("the recorded dead load"));
}

TEST(LimitCertificate, NoAlterationProvesAFalseClaim) {
  const auto text = text_of(evidence());
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
      const auto statements = read_limit_certificate(sealed(altered), "cert");
      const auto& certificate = statements.front().evidence;
      ++read;
      const LimitProof proof(certificate);
      const auto upper = proof.upper();
      if (const auto* value = std::get_if<mpq_class>(&upper)) rounded_up(*value);
      flaw_of_sign_cover(certificate);
      static_cast<void>(proof.shows_no_factor());
      for (const auto& node : certificate.nodes) {
        const auto lower = proof.lower(node);
        if (const auto* value = std::get_if<mpq_class>(&lower)) rounded_down(*value);
      }
      expect_no_false_claim(certificate);
    } catch (const CertificateError& error) {
      EXPECT_THAT(error.what(), HasSubstr("cert"));
    }
  }
  EXPECT_GT(read, 1000);
}

}  // namespace
}  // namespace kusabi::verify
