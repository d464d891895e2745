// The load model f_D + T zeta with columns of any direction: worst cases and certificates of random
// trusses compared with all vertices, which are solved independently. KUSABI_TRUSSES sets the
// number of trusses, KUSABI_SEED the first one.
#include "tests/nodes/limit/load_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "nodes/limit/guaranteed_interval.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/files/toml/structure_writer.hpp"

namespace kusabi::limit {
namespace {

using problems::LimitProblem;
using problems::Structure;
using test::findings;
using test::near;
using test::PlainTruss;
using test::problem_of;
using test::shown;

unsigned from_environment(const char* name, unsigned otherwise) {
  const char* const text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  return text == nullptr ? otherwise : static_cast<unsigned>(std::stoul(text));
}

// A certificate with another column of T is refused for the truss.
void expect_other_columns_refused(const verify::LimitCertificate& certificate,
                                  const Structure& truss) {
  const auto refused = [&](const auto& change) {
    for (std::size_t j = 0; j < certificate.uncertain.size(); ++j) {
      auto other = certificate;
      change(other.uncertain[j]);
      // If two columns are equal or opposite, the change may reproduce the original.
      if (shown(other, truss).why.find("uncertain loads") == std::string::npos) return false;
    }
    return true;
  };
  EXPECT_TRUE(refused([](verify::Sparse& t) { t[0].second = std::nextafter(t[0].second, 9); }));
  EXPECT_TRUE(refused([](verify::Sparse& t) { t[0].second = -t[0].second; }));
  EXPECT_TRUE(refused([](verify::Sparse& t) { t.emplace_back(t[0].first, 0.5); }));
  EXPECT_TRUE(refused([&](verify::Sparse& t) {
    t.back().first = (t.back().first + 1) % certificate.displacements;
  }));
  EXPECT_TRUE(refused([](verify::Sparse& t) { t.pop_back(); }));
}

std::vector<verify::Sparse> columns_of(const LimitProblem& problem) {
  std::vector<verify::Sparse> columns;
  for (const auto& column : problem.uncertain) {
    auto& load = columns.emplace_back();
    for (const auto& [degree, value] : column.direction) {
      load.emplace_back(static_cast<std::size_t>(degree), column.weight * value);
    }
  }
  return columns;
}

// Evidence of one T used for another in truss and certificate: its proved bounds must be valid.
void expect_nothing_wrong_is_shown(const verify::LimitCertificate& certificate,
                                   const Structure& truss) {
  for (std::size_t j = 0; j < certificate.uncertain.size(); ++j) {
    auto other = truss;
    for (auto& component : (*other.uncertain)[j].components) component.weight *= 1.25;
    auto moved = certificate;
    moved.uncertain = columns_of(limit_problem(checked(other)));
    const auto claim = shown(moved, other);
    const auto minimum = PlainTruss(other).min_over_corners(certificate.alpha.at(0));
    if (!minimum || !claim.why.empty()) continue;
    EXPECT_LE(claim.lower, *minimum + near);
    EXPECT_GE(claim.upper, *minimum - near);
  }
}

// The smallest guaranteed factor: of all vertices, with the opposite reference load.
void expect_least_factors(const Structure& truss, double alpha, const LimitAnswer& answer) {
  auto mirrored = truss;
  for (auto& load : mirrored.loads) {
    if (load.kind == problems::Load::Kind::reference) load.force = -load.force;
  }
  const auto minimum = PlainTruss(mirrored).min_over_corners(alpha);
  ASSERT_TRUE(minimum);
  const auto interval = guaranteed_interval(answer);
  EXPECT_NEAR(interval.minimum.at_least(), -*minimum, near);
  EXPECT_NEAR(interval.minimum.at_most(), -*minimum, near);
  EXPECT_TRUE(is_proved(interval.standing()));
}

TEST(LoadModel, ProvesTheWorstVertexForColumnsOfAnyDirection) {
  const unsigned first = from_environment("KUSABI_SEED", 1);
  const unsigned count = from_environment("KUSABI_TRUSSES", 150);
  unsigned compared = 0;
  unsigned not_carried = 0;
  unsigned trees = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto [truss, alpha] = test::correlated_truss(seed);
    const auto problem = problem_of(truss);
    if (!problem) continue;
    const auto written = problems::read_structure(problems::structure_text(truss), "written");
    EXPECT_EQ(limit_problem(written).fingerprint, problem->fingerprint);
    const PlainTruss plain(truss);
    const auto nominal = plain.factor(Eigen::VectorXd::Zero(plain.uncertain.cols()));
    const auto found = findings(truss, {.alpha = alpha});
    EXPECT_TRUE(found.answer.whole());
    ASSERT_EQ(found.answer.nominal.has_value(), nominal.has_value());
    if (!nominal) continue;
    EXPECT_NEAR(found.answer.nominal->factor, *nominal, near);
    const auto& worst = *found.answer.worst;
    const auto minimum = plain.min_over_corners(alpha);
    if (!minimum) {
      EXPECT_EQ(worst.status, RootStatus::not_carried);
      ++not_carried;
      continue;
    }
    EXPECT_NEAR(worst.ends.at_most(), *minimum, near);
    EXPECT_NEAR(worst.ends.at_least(), *minimum, near);
    expect_least_factors(truss, alpha, found.answer);
    trees += worst.nodes > 1 ? 1 : 0;
    ++compared;
    ASSERT_FALSE(found.statements.empty());
    const auto text = verify::limit_certificate_text(found.statements);
    const auto read = verify::read_limit_certificate(text, "certificate").front().evidence;
    const auto claim = shown(read, truss);
    EXPECT_EQ(claim.why, "");
    EXPECT_GE(claim.lower, worst.ends.at_least());
    EXPECT_EQ(claim.upper, worst.ends.at_most());
    expect_other_columns_refused(read, truss);
    expect_nothing_wrong_is_shown(read, truss);
  }
  RecordProperty("compared", static_cast<int>(compared));
  RecordProperty("not_carried", static_cast<int>(not_carried));
  RecordProperty("trees", static_cast<int>(trees));
  EXPECT_GE(compared, count / 2);
  EXPECT_GE(not_carried, count / 50);
}

// Found among random trusses: static cuts leave a gap, and the tree decides the signs of columns
// with several components, also common ones. In the plane and in space.
TEST(LoadModel, TheTreeClosesTheGapsOfStaticCuts) {
  for (const std::uint32_t seed : {1807U, 2041U, 2064U, 2685U, 3981U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto [truss, alpha] = test::correlated_truss(seed);
    const auto found = findings(truss, {.alpha = alpha});
    EXPECT_GT(found.answer.worst->nodes, 1U);
    EXPECT_NEAR(found.answer.worst->ends.at_most(),
                PlainTruss(truss).min_over_corners(alpha).value(), near);
    ASSERT_FALSE(found.statements.empty());
    const auto& certificate = found.statements.front().evidence;
    EXPECT_GT(certificate.nodes.size(), 1U);
    expect_other_columns_refused(certificate, truss);
    expect_nothing_wrong_is_shown(certificate, truss);
  }
}

}  // namespace
}  // namespace kusabi::limit
