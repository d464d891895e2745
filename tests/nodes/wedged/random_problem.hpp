// Random wedged problem without a structure, for tests of solvers and proofs.
#pragma once

#include <cstdint>
#include <random>

#include <fmt/format.h>

#include "dense.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// A random positive definite stiffness, full, with a condition number of about ten.
inline problems::WedgedProblem random_problem(int dimension, int candidates, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  const int size = dimension * candidates;
  Eigen::MatrixXd factor(size, size);
  for (auto& entry : factor.reshaped()) entry = normal(generator);
  problems::WedgedProblem problem;
  problem.dimension = dimension;
  for (int i = 0; i < candidates; ++i) problem.contact_names.push_back(fmt::format("c{}", i));
  const Eigen::MatrixXd product =
      factor * factor.transpose() + 0.1 * size * Eigen::MatrixXd::Identity(size, size);
  problem.compliance.stiffness = (product + product.transpose()) / 2;
  const Eigen::MatrixXd inverse = dense::inverse(problem.compliance.stiffness);
  problem.compliance.matrix = (inverse + inverse.transpose()) / 2;
  return problem;
}

}  // namespace kusabi::wedged
