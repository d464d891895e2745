// Products of inequalities that hold in every wedged configuration, added up with multipliers: a
// quadratic form in the normal reactions. If it is negative definite at a friction coefficient,
// nothing is wedged there or below (docs/theory/wedged.md, "Lower bound by one matrix").
//
// With B = sym(P'F_nn), E = P'F_nt + S and sigma = s / f, the form at the coefficient f is
//
//   B + f M,   M = sym|S| + diag(s) + E diag(1/(4 s)) E'.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Multipliers of the products.
struct QuadraticMultipliers {
  /// P, m x m, of u_ni r_nj: >= 0 off the diagonal, of any sign on it.
  Eigen::MatrixXd products;
  /// S, m x (d-1)m, length/force, of r_nj (mu_k |S_jk| r_nk + S_jk'r_tk); component by component.
  Eigen::MatrixXd slips;
  /// sigma, m, > 0, length/force, of mu_k^2 r_nk^2 - |r_tk|^2.
  Eigen::VectorXd squares;

  [[nodiscard]] bool is_known() const { return squares.size() > 0; }

  /// As in certificates: P by rows, S of each pair (j, k), sigma.
  [[nodiscard]] std::vector<double> numbers() const;
};

/// Rows of normal displacements of F, m x dm: F_nn, then F_nt component by component.
Eigen::MatrixXd normal_rows(const problems::WedgedProblem& block);

/// Variables of the optimisation: logarithms of -P_ii and of s, S, and square roots of P_ij.
class QuadraticPoint {
 public:
  QuadraticPoint(Eigen::Index candidates, Eigen::Index tangents)
      : values(
            Eigen::VectorXd::Zero(2 * candidates + (tangents + 1) * candidates * candidates + 1)),
        m_(candidates),
        e_(tangents) {}

  using List = Eigen::Map<Eigen::VectorXd>;
  using Matrix = Eigen::Map<Eigen::MatrixXd>;

  List log_weights() { return {values.data(), m_}; }
  List log_squares() { return {values.data() + m_, m_}; }
  Matrix slips() { return {values.data() + 2 * m_, m_, e_ * m_}; }
  Matrix roots() { return {values.data() + 2 * m_ + e_ * m_ * m_, m_, m_}; }
  double& log_factor() { return values[values.size() - 1]; }

  Eigen::VectorXd values;

 private:
  Eigen::Index m_;
  Eigen::Index e_;
};

/// -B and M at a point, and intermediate results for their derivatives.
class QuadraticForm {
 public:
  /// @param block a problem of one block whose bodies are constrained
  explicit QuadraticForm(const problems::WedgedProblem& block);

  [[nodiscard]] Eigen::Index candidates() const { return rows_.rows(); }
  [[nodiscard]] Eigen::Index tangents() const { return tangents_; }
  /// F_nn and F_nt in units of the mean of the diagonal of F_nn, F_nt times the candidates' own
  /// friction.
  [[nodiscard]] const Eigen::MatrixXd& rows() const { return rows_; }

  /// @param rounded_off |S_jk| is smooth below this, in units of the mean of F_nn's diagonal
  void set(QuadraticPoint& point, double rounded_off);

  /// -log det(-B - f M) - weight log f; infinity if the form is not negative definite.
  [[nodiscard]] double potential(double factor, double weight);
  /// Its derivatives at the point and coefficient last given. @pre the potential was finite
  void derivatives(QuadraticPoint& point, double weight, QuadraticPoint& result);
  /// Inverses of estimated second derivatives there.
  void scales(QuadraticPoint& point, double weight, QuadraticPoint& result);

  /// The largest coefficient at which the form of the point last set is not positive.
  [[nodiscard]] double largest_factor() const;

  /// The multipliers of the point last set at a coefficient, in units of the block.
  [[nodiscard]] QuadraticMultipliers multipliers(QuadraticPoint& point, double factor) const;

 private:
  [[nodiscard]] auto component(const Eigen::MatrixXd& matrix, Eigen::Index k) const {
    return matrix.middleCols(k * candidates(), candidates());
  }

  Eigen::Index tangents_;
  double unit_;
  Eigen::VectorXd friction_;
  Eigen::MatrixXd rows_;
  Eigen::VectorXd weights_, squares_;             // -P_ii and s
  Eigen::MatrixXd products_, responses_;          // P, P'[F_nn, F_nt]
  Eigen::MatrixXd sums_, shares_, sizes_;         // E, E diag(1/s), |S|
  Eigen::MatrixXd minus_linear_, friction_part_;  // -B, M
  Eigen::MatrixXd inverse_;                       // of -B - f M
  double factor_ = 0;
};

}  // namespace kusabi::wedged
