// Margins of unconstrained bodies depend neither on the axes nor on the order or units of the file.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "engine/analysis/analysis.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "problems/files/structure_file.hpp"

namespace kusabi::wedged {
namespace {

using problems::Structure;

Structure unconstrained(const std::string& place) {
  const std::string path = KUSABI_SOURCE_DIR "/" + place;
  const auto structure = problems::load_structure(path);
  EXPECT_FALSE(structure.unconstrained_bodies().empty());
  // Nodes of the ground may be turned as well.
  for (const auto& axes : structure->fixed) {
    const auto fixed = std::count(axes.begin(), axes.begin() + structure->dimension, true);
    EXPECT_TRUE(fixed == 0 || fixed == structure->dimension);
  }
  EXPECT_TRUE(structure->springs.empty());
  return structure;
}

Structure turned(Structure structure, const Eigen::MatrixXd& rotation) {
  structure.coordinates = (rotation * structure.coordinates).eval();
  structure.coordinates.colwise() += Eigen::VectorXd::LinSpaced(structure.dimension, 0.3, 1.1);
  for (auto& candidate : structure.contact) {
    candidate.direction = rotation * candidate.direction.value_or(candidate.normal);
    candidate.normal = candidate.direction->normalized();
    if (candidate.tangent) candidate.tangent = (rotation * *candidate.tangent).eval();
  }
  return structure;
}

// Nodes, members, elements and candidates in reverse order.
Structure reversed(Structure structure) {
  const auto last = static_cast<int>(structure.node_names.size()) - 1;
  structure.coordinates = structure.coordinates.rowwise().reverse().eval();
  std::ranges::reverse(structure.node_names);
  std::ranges::reverse(structure.members);
  std::ranges::reverse(structure.elements);
  std::ranges::reverse(structure.contact);
  std::ranges::reverse(structure.fixed);
  structure.more_names.clear();
  for (auto& member : structure.members) {
    member.first = last - member.first;
    member.second = last - member.second;
  }
  for (auto& element : structure.elements)
    for (int& node : element.nodes) node = last - node;
  for (auto& candidate : structure.contact) {
    candidate.node = last - candidate.node;
    for (auto& share : candidate.against) share.node = last - share.node;
  }
  for (auto& load : structure.loads) load.node = last - load.node;
  return structure;
}

Structure in_units(Structure structure, double length, double force) {
  structure.coordinates *= length;
  for (auto& member : structure.members) member.axial_stiffness *= force;
  for (auto& element : structure.elements) {
    element.modulus *= force / (length * length);
    element.thickness *= length;
  }
  for (auto& candidate : structure.contact) candidate.clearance *= length;
  return structure;
}

using Names = std::set<std::string>;

// By the names of the candidates in contact and separated.
std::map<std::pair<Names, Names>, double> margins(const Structure& given, double mu) {
  const auto structure = problems::checked(given);
  engine::SingleProcess transport;
  engine::Analysis analysis(transport, {});
  const auto problem = problems::wedged_problem(structure);
  const auto found =
      find_patterns(analysis, problem, candidate_friction(problem, mu), PatternParameters{});
  std::map<std::pair<Names, Names>, double> margins;
  const auto names = [&](const support::IndexSet& candidates) {
    Names set;
    for (const int candidate : candidates)
      set.insert(problem.contact_names[static_cast<std::size_t>(candidate)]);
    return set;
  };
  for (const auto& leaf : found.leaves)
    margins[{names(leaf.pattern.contact), names(leaf.pattern.separated)}] = leaf.lower;
  return margins;
}

struct Body {
  std::string file;
  double mu;
};

class MarginUnit : public testing::TestWithParam<Body> {};

TEST_P(MarginUnit, DependsNeitherOnAxesNorOnOrderNorOnUnits) {
  const auto structure = unconstrained(GetParam().file);
  const auto unit = [](const Structure& each) {
    return problems::margin_unit(problems::wedged_problem(problems::checked(each)));
  };
  const double own = unit(structure);
  const Eigen::MatrixXd rotation =
      structure.dimension == 2
          ? Eigen::MatrixXd(Eigen::Rotation2Dd(0.7).toRotationMatrix())
          : Eigen::MatrixXd(
                Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix());
  const auto other = reversed(turned(structure, rotation));
  EXPECT_NEAR(unit(other) / own, 1, 1e-9);
  EXPECT_NEAR(unit(in_units(structure, 1e3, 0.02)) / own, 1e3 / 0.02, 1e-5);
  if (structure.dimension == 3) return;
  const auto expected = margins(structure, GetParam().mu);
  EXPECT_FALSE(expected.empty());
  for (const auto& changed : {other, in_units(other, 1e3, 0.02)}) {
    const auto found = margins(changed, GetParam().mu);
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [names, margin] : expected) {
      ASSERT_TRUE(found.contains(names));
      EXPECT_NEAR(found.at(names) / margin, 1, 2e-3);  // three digits are computed
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, MarginUnit,
                         testing::Values(Body{"examples/wedge-in-groove.toml", 0.3},
                                         Body{"tests/cases/pair_on_edges.toml", 1.25},
                                         Body{"tests/cases/wedge_margins.toml", 2.2},
                                         Body{"tests/cases/loose_with_cuts.toml", 1},
                                         Body{"examples/morse-taper.toml", 0}));

}  // namespace
}  // namespace kusabi::wedged
