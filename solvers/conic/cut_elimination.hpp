// CutElimination: elimination of the rows of cuts from the normal equations, which makes cuts
// cheap.
//
// A step of the iteration solves M (y, eta) = (r, rho) of m + f numbers, where M = [A; C] W^2 [A;
// C]' + diag(w^2). A row of C is a combination of one of A, an entry and a sum (node_program.hpp):
// C_i = -a A_i - c e_i0' + gamma_i 1', a its displacement and c its reaction. In y^_i = y_i - a
// eta_i, nu = sum_i gamma_i eta_i and sigma = 1'x, x = W^2 (A'y + C'eta), each eta_i has an
// equation of its own:
//
//   delta_i eta_i = rho_i + a r_i + p_i'(y^, nu) - gamma_i sigma,
//   delta_i = w_cut^2 + a^2 w_i^2 + c^2 (W_i^2)_00,     p_i = c A^ W_i^2 e_0 - a w_i^2 e_i,
//
// A^ = [A; 1']. Then sigma is eliminated, and the reduced system has one row more than M without
// cuts:
//
//   (A^ W^2 A^' + diag(w^2, 0) - sum_i p_i p_i' / delta_i + q q' / kappa) (y^, nu)
//     = (r, 0) + sum_i p_i (rho_i + a r_i) / delta_i - q phi / kappa,
//   q = sum_i gamma_i p_i / delta_i - e_nu,    kappa = sum_i gamma_i^2 / delta_i,
//   phi = sum_i gamma_i (rho_i + a r_i) / delta_i,    sigma = (phi + q'(y^, nu)) / kappa.
//
// The subtraction acts within the block diag(W_i^2, w_i^2) of a candidate, whose remainder has a
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

/// Elimination at one point of the iteration, on storage for the largest node. Call in this order:
/// start() for a node; begin(), share() and border() at a point; then the others.
template <int D, class Real = double>
class CutElimination {
 public:
  /// Scaling matrix of a cone, D x D.
  using Square = Eigen::Matrix<Real, D, D>;
  using Vector = Eigen::Matrix<Real, D, 1>;

  /// @param max_rows m + p
  CutElimination(int max_rows, int max_cuts, int max_cones);

  /// Sets the cuts of a node.
  void start(const NodeProgram<D, Real>& program);
  /// True if there are cuts.
  [[nodiscard]] bool is_needed() const { return !cuts_.empty(); }
  /// Number of equations of the reduced system: one more than without cuts.
  [[nodiscard]] int rows() const { return rows_; }

  /// @param w by row, sqrt(v / y); 0 without a slack
  void begin(const VectorOf<Real>& w);

  /// Factor of a cone's columns of A^ in place of W, and the addend to them.
  struct Share {
    Square root;
    int row = 0;                     ///< row of the candidate
    Vector in_row = Vector::Zero();  ///< addend in this row
  };
  [[nodiscard]] Share share(int cone, const Square& scaling);

  /// Computes the border, when share() was called for all cones.
  /// @return false if rounding has used up the digits
  [[nodiscard]] bool border(const NodeProgram<D, Real>& program);

  /// Sets the diagonal contribution of the slacks in the reduced system, from w^2, and adds the
  /// border to `equations`.
  void complete(VectorOf<Real>& weights, NormalEquations<Real>& equations) const;

  /// Reduces the right side (r, rho) to the rows() equations.
  void reduce(const VectorOf<Real>& whole, VectorOf<Real>& reduced) const;
  /// Replaces (r, rho) by the solution (y, eta), from (y^, nu).
  void expand(const VectorOf<Real>& solution, VectorOf<Real>& whole) const;

  /// Contribution of a cut to b'M^-1 b for the columns b of its candidate in [A; C] W, and for that
  /// of its slack: b'M^-1 b = g'(reduced system)^-1 g + weight h^2.
  struct Part {
    Vector cone = Vector::Zero();  ///< f: g = A^ W e_d - f_d along, h = f_d
    Real slack = 0;                ///< a w: g = w e_i + a w along, h = a w
    Real weight = 0;
  };
  /// @param candidate with or without a cut  @param along rows() numbers, padded
  [[nodiscard]] Part part_of(int candidate, VectorOf<Real>& along) const;

 private:
  // A cut, in the symbols of the header; f = c W e_0, `first` = W f.
  struct Own {
    CutRow<Real> row;
    Real cut_weight = 0, gap_weight = 0;  // w_cut^2, w_i^2
    Vector f = Vector::Zero(), first = Vector::Zero();
    Real delta = 0;
  };

  [[nodiscard]] PackedColumns<Real> outer() const;

  int rows_ = 0, first_cut_ = 0;
  std::vector<Own> cuts_;
  std::vector<int> cut_of_cone_;  // -1: no cut
  VectorOf<Real> outer_;          // p_i, by columns
  VectorOf<Real> border_;         // q
  Real kappa_ = 0;
  mutable VectorOf<Real> shares_;  // one number per cut
};

}  // namespace kusabi::conic
