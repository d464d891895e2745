// Quadratic form of constrained bodies in the normal reactions alone, without products of
// displacements. With B = sym(P'F_nn), E = P'F_nt + S and sigma = s / f, the largest value over the
// tangential reactions at the coefficient f is r_n'(B + f M) r_n,
//
//   M = sym|S| + diag(s) + E diag(1/(4 s)) E'.
#pragma once

#include "nodes/wedged/quadratic/quadratic_form.hpp"

namespace kusabi::wedged {

class ReducedForm final : public QuadraticForm {
 public:
  using QuadraticForm::QuadraticForm;

  [[nodiscard]] QuadraticPoint first_point() const override;
  [[nodiscard]] double potential(double factor, double weight) override;
  [[nodiscard]] double largest_factor(double above) override;

 private:
  void assemble(QuadraticPoint& point) override;
  [[nodiscard]] Slopes slopes() override;
  [[nodiscard]] Eigen::MatrixXd normal_inverse() const override { return inverse_; }
  [[nodiscard]] Eigen::VectorXd row_sizes() const override;

  Eigen::MatrixXd responses_;                     // P'[F_nn, F_nt]
  Eigen::MatrixXd sums_, shares_;                 // E, E diag(1/s)
  Eigen::MatrixXd minus_linear_, friction_part_;  // -B, M
  Eigen::MatrixXd inverse_;                       // of -B - f M
};

}  // namespace kusabi::wedged
