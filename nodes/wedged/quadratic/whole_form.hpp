// Quadratic form in all reactions and in the rigid-body motions alpha that open or close a
// candidate, u_n = U x with x = (r_n, r_t, alpha) and U = [F_n, H]. With N >= 0 it contains the
// products u_n'N u_n, which bound alpha, and is considered for G'r = 0 only.
#pragma once

#include "nodes/wedged/quadratic/quadratic_form.hpp"

namespace kusabi::wedged {

/// Rigid-body modes of a block, component by component as in normal_rows().
struct FormMotions {
  /// H, m x k: normal displacements by the modes that have any. No columns: bodies are constrained,
  /// or slide only.
  Eigen::MatrixXd lifting;
  Eigen::MatrixXd equilibrium;  ///< G, dm x p
  double error = 0;             ///< bound of the error of an entry of both
};

FormMotions form_motions(const problems::WedgedProblem& block);

/// N >= 0 such that H'N H is negative definite, from pairs of candidates that a motion moves in
/// opposite ways; m x m. Zero without motions.
/// @return no rows: none was found, as for bodies that a motion lifts off all candidates
Eigen::MatrixXd opposite_pairs(const Eigen::MatrixXd& lifting);

/// Adds terms (G C + C'G')/2, zero for G'r = 0, to a symmetric form in x such that its part outside
/// G'r = 0 becomes -level I, with no coupling to the rest. @return C, p x n
Eigen::MatrixXd restrict_to_equilibrium(const Eigen::MatrixXd& equilibrium, double level,
                                        Eigen::MatrixXd& form);

class WholeForm final : public QuadraticForm {
 public:
  /// @param pairs opposite_pairs(), with rows
  WholeForm(const problems::WedgedProblem& block, FormMotions motions, Eigen::MatrixXd pairs);

  [[nodiscard]] QuadraticPoint first_point() const override;
  [[nodiscard]] double potential(double factor, double weight) override;
  [[nodiscard]] double largest_factor(double above) override;

 private:
  void assemble(QuadraticPoint& point) override;
  [[nodiscard]] Slopes slopes() override;
  [[nodiscard]] Eigen::MatrixXd normal_inverse() const override {
    return inverse_.topLeftCorner(candidates(), candidates());
  }
  [[nodiscard]] Eigen::VectorXd row_sizes() const override;
  // Minus the form at a coefficient.
  [[nodiscard]] Eigen::MatrixXd opposite(double factor) const;

  Eigen::MatrixXd all_rows_;  // U, m x n
  Eigen::MatrixXd basis_;     // n x p, orthonormal: G without its dependence on alpha
  Eigen::MatrixXd first_pairs_;
  Eigen::MatrixXd fixed_;    // the part of the form that does not depend on f
  Eigen::MatrixXd inverse_;  // of minus the form, for G'r = 0
};

}  // namespace kusabi::wedged
