// Contact problems for the tests of the cone solver, and their node program in its original
// variables. It shares nothing with the solver.
#pragma once

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "dense.hpp"
#include "support/index_set.hpp"

namespace kusabi::conic::testing {

using Masks = std::pair<support::IndexSet, support::IndexSet>;  // U, R

inline bool contains(const support::IndexSet& set, int i) {
  return set.contains(i);
}

/// A compliance (dm x dm, node-major, normal first) and a friction coefficient for each candidate.
struct ContactProblem {
  int d = 2;
  Eigen::MatrixXd compliance;
  std::vector<double> friction;

  int candidates() const { return static_cast<int>(friction.size()); }
};

/// Scales to mean diagonal 1 of the normal block, the units of the solver's tolerances.
inline Eigen::MatrixXd scaled(Eigen::MatrixXd compliance, int d) {
  double sum = 0;
  for (Eigen::Index i = 0; i < compliance.rows(); i += d) sum += compliance(i, i);
  return compliance * (static_cast<double>(compliance.rows()) / (d * sum));
}

/// The inverse of a random positive definite stiffness, with friction within the given range.
inline ContactProblem random_problem(int d, int m, double minimum, double maximum,
                                     std::mt19937_64& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const int size = d * m;
  const Eigen::MatrixXd factor =
      Eigen::MatrixXd::NullaryExpr(size, size, [&] { return uniform(generator); });
  const Eigen::MatrixXd stiffness =
      factor * factor.transpose() + 0.2 * Eigen::MatrixXd::Identity(size, size);
  const Eigen::MatrixXd inverse = dense::inverse(stiffness);
  ContactProblem problem{d, scaled((inverse + inverse.transpose()) / 2, d), {}};
  std::uniform_real_distribution<double> exponent(std::log(minimum), std::log(maximum));
  for (int i = 0; i < m; ++i) problem.friction.push_back(std::exp(exponent(generator)));
  return problem;
}

/// Random disjoint U and R; R does not contain all candidates.
inline Masks random_masks(int m, std::mt19937_64& generator) {
  for (;;) {
    Masks masks{0, 0};
    for (int i = 0; i < m; ++i) {
      const auto draw = generator() % 3;
      if (draw == 0) masks.first.insert(i);
      if (draw == 1) masks.second.insert(i);
    }
    if (masks.second != support::IndexSet::below(m)) return masks;
  }
}

/// The largest t for which (r, t) satisfies the inequalities of the node program, a concave
/// function.
/// @param slope if not null, receives a supergradient of it at r
inline double level(const ContactProblem& problem, const Masks& masks, const Eigen::VectorXd& r,
                    Eigen::VectorXd* slope = nullptr) {
  const Eigen::VectorXd u = problem.compliance * r;
  double t = std::numeric_limits<double>::infinity();
  for (int i = 0; i < problem.candidates(); ++i) {
    const int at = problem.d * i;
    if (!contains(masks.first, i) && u[at] < t) {
      t = u[at];
      if (slope != nullptr) *slope = problem.compliance.row(at);
    }
    const double friction = problem.friction[static_cast<std::size_t>(i)];
    const Eigen::VectorXd tangential = r.segment(at + 1, problem.d - 1);
    const double margin = friction * r[at] - tangential.norm();
    if (!contains(masks.second, i) && margin < t) {
      t = margin;
      if (slope == nullptr) continue;
      slope->setZero(r.size());
      (*slope)[at] = friction;
      slope->segment(at + 1, problem.d - 1) = -tangential.normalized();
    }
  }
  return t;
}

/// Equations of the node program: u_n = 0 on U, r = 0 on R, sum r_n = 1; their right-hand side is
/// zero except for the one of the sum.
inline Eigen::MatrixXd equations(const ContactProblem& problem, const Masks& masks) {
  const int d = problem.d, m = problem.candidates();
  std::vector<Eigen::RowVectorXd> rows;
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(d * m);
  for (int i = 0; i < m; ++i) {
    sum[d * i] = 1;
    if (contains(masks.first, i)) rows.emplace_back(problem.compliance.row(d * i));
    if (contains(masks.second, i))
      for (int c = 0; c < d; ++c) rows.emplace_back(Eigen::RowVectorXd::Unit(d * m, d * i + c));
  }
  rows.push_back(sum);
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), d * m);
  for (std::size_t row = 0; row < rows.size(); ++row)
    matrix.row(static_cast<Eigen::Index>(row)) = rows[row];
  return matrix;
}

}  // namespace kusabi::conic::testing
