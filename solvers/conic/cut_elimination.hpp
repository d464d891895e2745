// The rows of cuts, eliminated from the normal equations: cuts then cost next to nothing.
//
// A step of the iteration asks for M (y, eta) = (r, rho) of m + f numbers, where
// M = [A; C] W^2 [A; C]' + diag(w^2). A row of C is one of A, an entry and a sum
// (node_program.hpp): C_i = -a A_i - c e_i0' + gamma_i 1', a its displacement and c its reaction.
// In y^_i = y_i - a eta_i, nu = sum_i gamma_i eta_i and sigma = 1'x, x = W^2 (A'y + C'eta), each
// eta_i stands alone:
//
//   delta_i eta_i = rho_i + a r_i + p_i'(y^, nu) - gamma_i sigma,
//   delta_i = w_cut^2 + a^2 w_i^2 + c^2 (W_i^2)_00,     p_i = c A^ W_i^2 e_0 - a w_i^2 e_i,
//
// A^ = [A; 1']. Then sigma is eliminated, and what is left has one row more than M without cuts:
//
//   (A^ W^2 A^' + diag(w^2, 0) - sum_i p_i p_i' / delta_i + q q' / kappa) (y^, nu)
//     = (r, 0) + sum_i p_i (rho_i + a r_i) / delta_i - q phi / kappa,
//   q = sum_i gamma_i p_i / delta_i - e_nu,    kappa = sum_i gamma_i^2 / delta_i,
//   phi = sum_i gamma_i (rho_i + a r_i) / delta_i,    sigma = (phi + q'(y^, nu)) / kappa.
//
// The subtraction stays within the block diag(W_i^2, w_i^2) of a candidate, of which it leaves a
// root in closed form: nothing cancels, and A^ times these roots has as many columns as A W.
// docs/theory/wedged.md, "Cuts in the normal equations", derives it.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "solvers/conic/columns.hpp"
#include "solvers/conic/node_program.hpp"
#include "solvers/conic/normal_equations.hpp"

namespace kusabi::conic {

/// The elimination at one point of the iteration, on storage for the largest node. Call in this
/// order: start() for a node; begin(), share() and border() at a point; then the others.
template <int D>
class CutElimination {
 public:
  /// Columns of a D x D matrix.
  using Square = Eigen::Matrix<double, D, D>;
  using Vector = Eigen::Matrix<double, D, 1>;

  /// @param most_rows m + p
  CutElimination(int most_rows, int most_cuts, int most_cones);

  /// Takes the cuts of a node.
  void start(const NodeProgram<D>& program);
  /// Whether there are any.
  [[nodiscard]] bool is_needed() const { return !cuts_.empty(); }
  /// Those of the equations that are left: one more than without cuts.
  [[nodiscard]] int rows() const { return rows_; }

  /// @param w by row, sqrt(v / y); 0 without a slack
  void begin(const Eigen::VectorXd& w);

  /// What a cone's columns of A^ are multiplied with instead of W, and what is added to them.
  struct Share {
    Square root;
    int row = 0;                     ///< of the candidate
    Vector in_row = Vector::Zero();  ///< added there
  };
  [[nodiscard]] Share share(int cone, const Square& scaling);

  /// The scaling of all cones is known.
  /// @return false when rounding has used up the digits
  [[nodiscard]] bool border(const NodeProgram<D>& program);

  /// What the slacks are on the diagonal of what is left, from w^2; adds the border to that.
  void complete(Eigen::VectorXd& weights, NormalEquations& equations) const;

  /// The right side that is left of rows() numbers (r, rho).
  void reduce(const Eigen::VectorXd& whole, Eigen::VectorXd& reduced) const;
  /// The solution (y, eta) in the place of (r, rho), from (y^, nu).
  void expand(const Eigen::VectorXd& solution, Eigen::VectorXd& whole) const;

  /// What a cut adds to b'M^-1 b of the columns b of its candidate in [A; C] W, and of that of its
  /// slack: b'M^-1 b = g'(what is left)^-1 g + weight h^2.
  struct Part {
    Vector cone = Vector::Zero();  ///< f: g = A^ W e_d - f_d along, h = f_d
    double slack = 0;              ///< a w: g = w e_i + a w along, h = a w
    double weight = 0;
  };
  /// @param candidate which may have no cut  @param along rows() numbers, padded
  [[nodiscard]] Part part_of(int candidate, Eigen::VectorXd& along) const;

 private:
  // A cut, by the symbols of the header; f = c W e_0, `first` = W f.
  struct Own {
    CutRow row;
    double cut_weight = 0, gap_weight = 0;  // w_cut^2, w_i^2
    Vector f = Vector::Zero(), first = Vector::Zero();
    double delta = 0;
  };

  [[nodiscard]] Columns outer() const;

  int rows_ = 0, first_cut_ = 0;
  std::vector<Own> cuts_;
  std::vector<int> cut_of_cone_;  // -1: none
  Eigen::VectorXd outer_;         // p_i, by columns
  Eigen::VectorXd border_;        // q
  double kappa_ = 0;
  mutable Eigen::VectorXd shares_;  // a number for each cut
};

extern template class CutElimination<2>;
extern template class CutElimination<3>;

}  // namespace kusabi::conic
