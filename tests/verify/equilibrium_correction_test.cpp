// Equilibrium defects beyond all doubles.
#include "verify/limit/equilibrium_correction.hpp"

#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "verify/limit/limit_proof.hpp"

namespace {

using namespace kusabi::verify;

// Members that reach one displacement each: `at[i]` is that of member i.
std::vector<Sparse> upright(const std::vector<std::size_t>& at) {
  std::vector<Sparse> columns;
  for (const auto e : at) columns.push_back({{e, 1.0}});
  return columns;
}

TEST(ForcesAgainstDefects, BalanceDefectsWithinTheSlackOfMembers) {
  const auto columns = upright({0, 1});
  const MemberColumns members{2, columns, {}};
  const auto found = forces_against_defects(members, {1, 1}, {1e-9, 2e-9});
  const auto& forces = std::get<std::vector<double>>(found);
  EXPECT_GE(forces[0], 1e-9);
  EXPECT_GE(forces[1], 2e-9);
  EXPECT_LE(forces[1], 3e-9);
}

// Infinity times zero is not a number, and comparisons with it are false.
TEST(ForcesAgainstDefects, AreNotFoundForDefectsBeyondAllDoubles) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto columns = upright({0, 1});
  const MemberColumns members{2, columns, {}};
  EXPECT_TRUE(std::holds_alternative<std::string>(
      forces_against_defects(members, {1, 1}, {infinity, infinity})));
}

// Three members at each of two displacements with forces of 1e308: the defect exceeds all doubles.
TEST(LimitProof, RefusesForcesWhoseDefectIsBeyondAllDoubles) {
  LimitTruss truss;
  for (const auto& column : upright({0, 0, 0, 1, 1, 1}))
    truss.columns.push_back({{column[0].first, {Dyadic(column[0].second), {}}}});
  const std::vector<double> strong(6, 1.7e308);
  truss.below = truss.above = {strong, strong};
  truss.dead.resize(2);
  truss.reference.assign(2, Dyadic(1.0));
  truss.names.resize(6);
  LimitNode node;
  node.factor = 1000;
  node.forces.assign(6, 1e308);
  EXPECT_TRUE(std::holds_alternative<std::string>(LimitProof(truss).lower(node)));
}

}  // namespace
