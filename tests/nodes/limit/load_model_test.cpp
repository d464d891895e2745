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
#include "nodes/limit/search/limit_evidence.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/files/toml/structure_writer.hpp"

namespace kusabi::limit {
namespace {

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

// A theorem with another column of T is refused for the truss.
void expect_other_columns_refused(const verify::TrussTheorem& theorem, const Structure& truss) {
  using Column = std::vector<verify::UncertainForce>;
  const auto refused = [&](const auto& change) {
    for (std::size_t j = 0; j < theorem.truss.uncertain->size(); ++j) {
      auto other = theorem;
      change((*other.truss.uncertain)[j]);
      // If two columns are equal or opposite, the change may reproduce the original.
      if (shown(other, truss).why.find("uncertain loads") == std::string::npos) return false;
    }
    return true;
  };
  EXPECT_TRUE(refused([](Column& t) { t[0].weight = std::nextafter(t[0].weight, 9); }));
  EXPECT_TRUE(refused([](Column& t) { t[0].weight = -t[0].weight; }));
  EXPECT_TRUE(refused([](Column& t) { t.push_back({t[0].node, t[0].axis, 0.5}); }));
  EXPECT_TRUE(
      refused([&](Column& t) { t.back().axis = (t.back().axis + 1) % theorem.truss.dimension; }));
  EXPECT_TRUE(refused([](Column& t) { t.pop_back(); }));
}

// Evidence of one T used for another in truss and theorem: its proved bounds must be valid.
void expect_nothing_wrong_is_shown(const verify::TrussTheorem& theorem, const Structure& truss) {
  for (std::size_t j = 0; j < theorem.truss.uncertain->size(); ++j) {
    auto other = truss;
    for (auto& component : (*other.uncertain)[j].components) component.weight *= 1.25;
    auto moved = theorem;
    moved.truss = with_loads(evidence::verified_structure(other), limit_problem(checked(other)),
                             theorem.truss.half_widths.at(0).value())
                      .value();
    const auto claim = shown(moved, other);
    const auto minimum =
        PlainTruss(other).min_over_corners(theorem.truss.half_widths.at(0).value());
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
    ASSERT_FALSE(found.theorems.empty());
    const auto text = verify::truss_certificate_text(found.theorems);
    const auto read = verify::read_truss_certificate(text, "certificate").front();
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
    ASSERT_FALSE(found.theorems.empty());
    const auto& theorem = found.theorems.front();
    EXPECT_GT(theorem.nodes.size(), 1U);
    expect_other_columns_refused(theorem, truss);
    expect_nothing_wrong_is_shown(theorem, truss);
  }
}

}  // namespace
}  // namespace kusabi::limit
