// Tests of the cut elimination against the normal equations with all rows.
#include "solvers/conic/cut_elimination.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "solvers/conic/pack.hpp"
#include "tests/solvers/conic/contact_problem.hpp"

namespace kusabi::conic {
namespace {

// Both are solved by Cholesky factorisation, with a condition below 1e8.
constexpr double accuracy = 1e-6;

template <int D>
struct Iterate {
  Iterate(const testing::ContactProblem& problem, const testing::Masks& node,
          const std::vector<Cut>& cuts, std::mt19937_64& generator)
      : program(problem.compliance, problem.friction) {
    program.make_room(static_cast<int>(cuts.size()));
    program.select(node.first, node.second, {}, cuts);
    std::uniform_real_distribution<double> exponent(-2, 2);
    w.setZero(padded(program.rows()));
    for (int i = 0; i < program.rows(); ++i)
      if (program.slack()[i] > 0) w[i] = std::pow(10, exponent(generator));
    for (std::size_t c = 0; c < program.cones().size(); ++c) {
      const Eigen::MatrixXd root = Eigen::MatrixXd::Random(D, D);
      scalings.push_back(std::pow(10, exponent(generator)) *
                         (root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(D, D)));
    }
  }

  // [A; C] W, every entry by a product with a unit vector.
  [[nodiscard]] Eigen::MatrixXd all_columns() const {
    const auto cones = static_cast<Eigen::Index>(program.cones().size());
    Eigen::MatrixXd columns(program.rows(), D * cones);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(padded(program.rows()));
    for (Eigen::Index c = 0; c < cones; ++c)
      for (int d = 0; d < D; ++d) {
        ConePoints<D> x = ConePoints<D>::Zero(padded(program.max_cones()), D);
        x.row(c) = scalings[static_cast<std::size_t>(c)].col(d).transpose();
        program.multiply(x, sum);
        columns.col(D * c + d) = sum.head(program.rows());
      }
    return columns;
  }

  NodeProgram<D> program;
  Eigen::VectorXd w;
  std::vector<Eigen::Matrix<double, D, D>> scalings;
};

// The reduced system, factorised.
template <int D>
struct Eliminated {
  explicit Eliminated(const Iterate<D>& at)
      : elimination(at.program.first_cut(), at.program.max_cuts(), at.program.max_cones()),
        equations(at.program.first_cut() + 1),
        reduced(Eigen::VectorXd::Zero(padded(at.program.first_cut() + 1))) {
    elimination.start(at.program);
    elimination.begin(at.w);
    const PackedColumns<> matrix = at.program.matrix();
    const int height = padded(elimination.rows());
    columns.setZero(height, D * matrix.stride);
    for (int c = 0; c < matrix.count; ++c) {
      const auto share = elimination.share(c, at.scalings[static_cast<std::size_t>(c)]);
      for (int d = 0; d < D; ++d) {
        auto own = columns.col(d * matrix.stride + c);
        for (int e = 0; e < D; ++e)
          own.head(matrix.rows) +=
              share.root(e, d) *
              Eigen::Map<const Eigen::VectorXd>(matrix.data + (e * matrix.stride + c) * matrix.rows,
                                                matrix.rows);
        own[elimination.rows() - 1] = share.root(0, d);
        own[share.row] += share.in_row[d];
      }
    }
    EXPECT_TRUE(elimination.border(at.program));
    equations.resize(elimination.rows());
    equations.assemble({columns.data(), height, D, matrix.count, matrix.stride});
    Eigen::VectorXd weights = at.w.cwiseAbs2();
    elimination.complete(weights, equations);
    for (int i = 0; i < at.program.first_cut(); ++i) equations.add_to_diagonal(i, weights[i]);
    Eigen::VectorXd other = reduced;
    EXPECT_TRUE(equations.factorise(reduced.data(), other.data()));
  }

  Eigen::VectorXd solve(Eigen::VectorXd right_side) {
    elimination.reduce(right_side, reduced);
    equations.solve(reduced.data());
    elimination.expand(reduced, right_side);
    return right_side;
  }

  CutElimination<D> elimination;
  NormalEquations<> equations;
  Eigen::MatrixXd columns;
  Eigen::VectorXd reduced;
};

std::vector<Cut> some_cuts(const testing::Masks& node, int m, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> number(0.2, 1.5);
  std::vector<Cut> cuts;
  for (int i = 0; i < m; ++i) {
    if (number(generator) < 0.5) continue;  // for some candidates, with or without a sign
    cuts.push_back({.candidate = i,
                    .share = number(generator) - 0.5,
                    .displacement = number(generator) - 0.7,
                    .reaction = node.second.contains(i) ? 0 : number(generator) - 0.7,
                    .level = number(generator)});
  }
  return cuts;
}

template <int D>
void expect_the_solution_of_all_rows() {
  std::mt19937_64 generator(41 + D);
  for (int repetition = 0; repetition < 40; ++repetition) {
    const int m = 2 + repetition % 8;
    const auto problem = testing::random_problem(D, m, 0.3, 3, generator);
    const auto node = testing::random_masks(m, generator);
    const auto cuts = some_cuts(node, m, generator);
    const Iterate<D> at(problem, node, cuts, generator);
    if (cuts.empty() || at.program.cones().empty()) continue;
    const Eigen::MatrixXd columns = at.all_columns();
    const int rows = at.program.rows();
    Eigen::MatrixXd whole = columns * columns.transpose();
    whole.diagonal() += at.w.head(rows).cwiseAbs2();
    Eliminated<D> eliminated(at);
    Eigen::VectorXd right_side = Eigen::VectorXd::Zero(padded(rows));
    right_side.head(rows).setRandom();
    const Eigen::VectorXd expected = dense::solve(whole, right_side.head(rows));
    const Eigen::VectorXd found = eliminated.solve(right_side);
    EXPECT_LE((found.head(rows) - expected).norm(), accuracy * expected.norm()) << repetition;
  }
}

TEST(CutElimination, HasTheSolutionOfAllRowsInThePlane) {
  expect_the_solution_of_all_rows<2>();
}
TEST(CutElimination, HasTheSolutionOfAllRowsInSpace) {
  expect_the_solution_of_all_rows<3>();
}

// b'M^-1 b of the columns of each candidate and of its slack, by g and the contribution of the cut.
template <int D>
void expect_the_squares_of_all_rows() {
  std::mt19937_64 generator(53 + D);
  for (int repetition = 0; repetition < 40; ++repetition) {
    const int m = 2 + repetition % 8;
    const auto problem = testing::random_problem(D, m, 0.3, 3, generator);
    const auto cuts = some_cuts({}, m, generator);
    const Iterate<D> at(problem, {}, cuts, generator);
    if (cuts.empty()) continue;
    const Eigen::MatrixXd columns = at.all_columns();
    const int rows = at.program.rows();
    Eigen::MatrixXd whole = columns * columns.transpose();
    whole.diagonal() += at.w.head(rows).cwiseAbs2();
    Eliminated<D> eliminated(at);
    const int left = eliminated.elimination.rows();
    Eigen::VectorXd along(padded(left));
    const auto square = [&](const Eigen::VectorXd& g) {
      Eigen::VectorXd solution = g;
      eliminated.equations.solve(solution.data());
      return g.dot(solution);
    };
    for (int i = 0; i < m; ++i) {
      const auto part = eliminated.elimination.part_of(i, along);
      for (int d = 0; d < D; ++d) {
        Eigen::VectorXd g = Eigen::VectorXd::Zero(padded(left));
        g.head(m) = columns.col(D * i + d).head(m);
        g[left - 1] = at.scalings[static_cast<std::size_t>(i)](0, d);
        g -= part.cone[d] * along;
        const Eigen::VectorXd b = columns.col(D * i + d);
        const double expected = b.dot(dense::solve(whole, b).col(0));
        EXPECT_NEAR(square(g) + part.weight * part.cone[d] * part.cone[d], expected, accuracy);
      }
      Eigen::VectorXd g = part.slack * along;
      g[i] += at.w[i];
      const Eigen::VectorXd b = at.w[i] * Eigen::VectorXd::Unit(rows, i);
      EXPECT_NEAR(square(g) + part.weight * part.slack * part.slack,
                  b.dot(dense::solve(whole, b).col(0)), accuracy);
    }
  }
}

TEST(CutElimination, HasTheSquaresOfAllRowsInThePlane) {
  expect_the_squares_of_all_rows<2>();
}
TEST(CutElimination, HasTheSquaresOfAllRowsInSpace) {
  expect_the_squares_of_all_rows<3>();
}

// A cut that is nearly an equation, beside an inactive one.
TEST(CutElimination, HasTheSolutionWithActiveCuts) {
  std::mt19937_64 generator(7);
  const auto problem = testing::random_problem(3, 5, 0.3, 3, generator);
  std::vector<Cut> cuts;
  for (int i = 0; i < 5; ++i)
    cuts.push_back({.candidate = i, .share = 1, .displacement = 0.5, .reaction = 2, .level = 1});
  Iterate<3> at(problem, {}, cuts, generator);
  for (int i = 0; i < 5; ++i) at.w[at.program.first_cut() + i] = i % 2 == 0 ? 1e-6 : 1e6;
  const Eigen::MatrixXd columns = at.all_columns();
  const int rows = at.program.rows();
  Eigen::MatrixXd whole = columns * columns.transpose();
  whole.diagonal() += at.w.head(rows).cwiseAbs2();
  Eliminated<3> eliminated(at);
  Eigen::VectorXd right_side = Eigen::VectorXd::Zero(padded(rows));
  right_side.head(rows).setRandom();
  const Eigen::VectorXd missing =
      whole * eliminated.solve(right_side).head(rows) - right_side.head(rows);
  EXPECT_LE(missing.norm(), accuracy);
}

}  // namespace
}  // namespace kusabi::conic
