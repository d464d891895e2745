// Lists of patterns of structures with very different scales: the exact test decides, or the result
// is undecided. The true results are those of bench/hostile, in 140 digits.
#include "nodes/wedged/exact_list.hpp"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/analysis/analysis.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/sweep/sweep_search.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/scale_ratio.hpp"

namespace kusabi::wedged {
namespace {

problems::CheckedStructure structure_in(const std::string& place) {
  const std::string path = KUSABI_SOURCE_DIR "/" + place;
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return problems::read_structure(text.str(), path);
}

PatternFindings listed(const problems::CheckedStructure& structure, double mu,
                       Proving proving = Proving::automatic) {
  engine::SingleProcess transport;
  engine::Analysis analysis(transport, {});
  const auto problem = problems::wedged_problem(structure);
  PatternParameters parameters;
  parameters.structure = &structure;
  parameters.proving = proving;
  return find_patterns(analysis, problem, candidate_friction(problem, mu), parameters);
}

TEST(ScaleRatio, IsThatOfLeversAndCouplings) {
  const auto ratio = [](const std::string& name) {
    const auto structure = structure_in(name);
    return problems::scale_ratio(structure, problems::wedged_problem(structure));
  };
  EXPECT_NEAR(ratio("tests/cases/lever_3e11.toml"), 3e11, 1e9);
  EXPECT_GT(ratio("tests/cases/weak_coupling_1e-11.toml"), 1e10);
  EXPECT_LT(ratio("examples/space-truss.toml"), 1e3);
  EXPECT_LT(ratio("examples/wedge-in-groove.toml"), 1e3);
}

TEST(ExactList, ExcludesTheSpuriousPatternsOfALongLever) {
  const auto found = listed(structure_in("tests/cases/lever_3e11.toml"), 0.5);
  EXPECT_TRUE(found.exact.done);
  EXPECT_EQ(found.count(), 0U);
}

TEST(ExactList, HasThePatternsOfAWeakCouplingOrIsUndecided) {
  const auto found = listed(structure_in("tests/cases/weak_coupling_1e-11.toml"), 1.83834805972901);
  EXPECT_TRUE(found.exact.done);
  EXPECT_TRUE(found.unresolved() > 0 || found.count() == 2) << found.count();
}

TEST(ExactList, AgreesWithTheSearchForWellScaledStructures) {
  const auto structure = structure_in("examples/plane-truss.toml");
  const auto plain = listed(structure, 0.8);
  const auto proved = listed(structure, 0.8, Proving::always);
  EXPECT_FALSE(plain.exact.done);
  EXPECT_TRUE(proved.exact.done);
  EXPECT_EQ(proved.exact.refused, 0U);
  EXPECT_EQ(plain.count(), proved.count());
}

TEST(ExactList, RefusesWrongCountsOfASweep) {
  engine::SingleProcess transport;
  engine::Analysis analysis(transport, {});
  const auto structure = structure_in("examples/plane-truss.toml");
  const auto problem = problems::wedged_problem(structure);
  auto found = sweep_friction(analysis, problem, {.maximum = 0.8});
  const std::vector<double> points{0.5};
  const ExactParameters parameters{structure, problem, Proving::always};
  EXPECT_EQ(tested_counts(analysis, parameters, points, found).unable, "");
  ASSERT_FALSE(found.cones.empty());
  found.cones.pop_back();
  EXPECT_NE(tested_counts(analysis, parameters, points, found).unable, "");
}

}  // namespace
}  // namespace kusabi::wedged
