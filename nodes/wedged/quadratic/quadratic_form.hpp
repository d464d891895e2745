// Products of inequalities that hold in every wedged configuration, added up with multipliers: a
// quadratic form in reactions and rigid-body motions. If it is negative definite at a friction
// coefficient, nothing is wedged there or below (docs/theory/wedged.md, "Lower bound by one
// matrix"). Two kinds of forms share their multipliers and the potential -log det(-form) - w log f:
// ReducedForm and WholeForm.
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
  /// N, m x m, >= 0, symmetric, force/length, of u_ni u_nj; no rows: zero.
  Eigen::MatrixXd pairs{};

  [[nodiscard]] bool is_known() const { return squares.size() > 0; }

  /// As in certificates: P by rows, S of each pair (j, k), sigma, and N by rows unless it is zero.
  [[nodiscard]] std::vector<double> numbers() const;
};

/// Rows of normal displacements of F, m x dm: F_nn, then F_nt component by component.
Eigen::MatrixXd normal_rows(const problems::WedgedProblem& block);

enum class PairProducts { none, all };

/// Variables of the optimisation: logarithms of -P_ii and of s, S, square roots of P_ij and, with
/// products of displacements, of N_ij.
class QuadraticPoint {
 public:
  QuadraticPoint(Eigen::Index candidates, Eigen::Index tangents, PairProducts pairs)
      : m_(candidates), e_(tangents), with_pairs_(pairs == PairProducts::all) {
    values.setZero(2 * m_ + (e_ + (with_pairs_ ? 2 : 1)) * m_ * m_ + 1);
  }

  using List = Eigen::Map<Eigen::VectorXd>;
  using Matrix = Eigen::Map<Eigen::MatrixXd>;

  [[nodiscard]] bool has_pairs() const { return with_pairs_; }
  List log_weights() { return {values.data(), m_}; }
  List log_squares() { return {values.data() + m_, m_}; }
  Matrix slips() { return {values.data() + 2 * m_, m_, e_ * m_}; }
  Matrix roots() { return {values.data() + 2 * m_ + e_ * m_ * m_, m_, m_}; }
  /// @pre has_pairs()
  Matrix pair_roots() { return {values.data() + 2 * m_ + (e_ + 1) * m_ * m_, m_, m_}; }
  double& log_factor() { return values[values.size() - 1]; }

  Eigen::VectorXd values;

 private:
  Eigen::Index m_;
  Eigen::Index e_;
  bool with_pairs_;
};

class QuadraticForm {
 public:
  /// @param block a problem of one block
  explicit QuadraticForm(const problems::WedgedProblem& block);
  QuadraticForm(const QuadraticForm&) = delete;
  QuadraticForm& operator=(const QuadraticForm&) = delete;
  virtual ~QuadraticForm() = default;

  [[nodiscard]] Eigen::Index candidates() const { return rows_.rows(); }
  [[nodiscard]] Eigen::Index tangents() const { return tangents_; }
  /// F_nn and F_nt in units of the mean of the diagonal of F_nn, F_nt times the candidates' own
  /// friction.
  [[nodiscard]] const Eigen::MatrixXd& rows() const { return rows_; }

  /// P = -I, S = 0 and s = 1; N, if any, such that the form is negative in the motions.
  [[nodiscard]] virtual QuadraticPoint first_point() const = 0;

  /// @param rounded_off |S_jk| is smooth below this, in units of the mean of F_nn's diagonal
  void set(QuadraticPoint& point, double rounded_off);

  /// -log det(-form) - weight log f; infinity if the form is not negative definite.
  [[nodiscard]] virtual double potential(double factor, double weight) = 0;
  /// Its derivatives at the point and coefficient last given. @pre the potential was finite
  void derivatives(QuadraticPoint& point, double weight, QuadraticPoint& result);
  /// Inverses of estimated second derivatives there.
  void scales(QuadraticPoint& point, double weight, QuadraticPoint& result);

  /// The largest coefficient up to which the form of the point last set is negative definite; 0 if
  /// that is not above a given one.
  [[nodiscard]] virtual double largest_factor(double above) = 0;

  /// The multipliers of the point last set at a coefficient, in units of the block.
  [[nodiscard]] QuadraticMultipliers multipliers(QuadraticPoint& point, double factor) const;

 protected:
  /// Derivatives of -log det(-form).
  struct Slopes {
    Eigen::MatrixXd by_products;  ///< by P
    Eigen::MatrixXd by_slips;     ///< by S, without its sizes
    Eigen::VectorXd by_squares;   ///< by s
    Eigen::MatrixXd by_pairs;     ///< by N; no rows without
    double by_log_factor = 0;
  };
  [[nodiscard]] virtual Slopes slopes() = 0;
  /// Block of the inverse of -form of the normal reactions, m x m.
  [[nodiscard]] virtual Eigen::MatrixXd normal_inverse() const = 0;
  /// Products u'W u of the rows u of u_n and the inverse W of -form; m.
  [[nodiscard]] virtual Eigen::VectorXd row_sizes() const = 0;
  virtual void assemble(QuadraticPoint& point) = 0;

  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] const Eigen::VectorXd& friction() const { return friction_; }

  Eigen::VectorXd weights_, squares_;  // -P_ii and s
  Eigen::MatrixXd products_, sizes_;   // P, |S|
  double factor_ = 0;

 private:
  Eigen::Index tangents_;
  double unit_;
  Eigen::VectorXd friction_;
  Eigen::MatrixXd rows_;
};

/// N of a point, symmetric.
Eigen::MatrixXd pairs_of(QuadraticPoint& point);

}  // namespace kusabi::wedged
