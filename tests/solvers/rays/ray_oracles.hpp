// Independent methods for rays and cones: slow, and without code of solvers/rays.
#pragma once

#include <random>
#include <set>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace kusabi::rays::test {

/// A ray as its reaction, 2m, with normal parts that sum to 1.
using Reactions = std::vector<Eigen::VectorXd>;

/// All complementary extremal rays, by definition: for each sign pattern, each choice of additional
/// equalities that leaves one direction, if it satisfies the remaining inequalities. m <= 6 or so.
Reactions rays_by_brute_force(const Eigen::MatrixXd& compliance, std::span<const double> friction);

/// True if both lists have the same rays, in any order.
bool same_rays(const Reactions& a, const Reactions& b);

/// All maximal cliques (C. Bron and J. Kerbosch, Algorithm 457, with a pivot).
std::set<std::set<int>> maximal_cliques(const std::vector<std::set<int>>& neighbours);

/// A random symmetric positive definite 2m x 2m matrix.
Eigen::MatrixXd random_compliance(int m, std::mt19937& bits);

}  // namespace kusabi::rays::test
