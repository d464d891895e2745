// WeightedRelaxation: the least weighted sum of gaps and normal reactions over the relaxation of a
// contact problem without complementarity,
//
//   min a'u_n + b'r_n  s.t.  u = F r + G alpha,  u_n >= 0,  ||r_ti|| <= mu_i r_ni,  G'r = 0,
//                            sum_i r_ni = 1,
//
// in doubles and without proof: a search for wedged configurations linearises complementarity with
// it (docs/theory/wedged.md, "Primal heuristic"). The iteration is that of interior_point.hpp,
// with an infeasible dual start, since the weights may lie outside the dual cone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "solvers/conic/columns.hpp"
#include "solvers/conic/cone.hpp"
#include "solvers/conic/motions.hpp"
#include "solvers/conic/normal_equations.hpp"
#include "support/stop.hpp"

namespace kusabi::conic {

/// A point of the relaxation, by candidate.
struct RelaxedPoint {
  Eigen::VectorXd reaction;  ///< r_n, sum 1
  Eigen::VectorXd gap;       ///< u_n
};

/// Solves such programs of one contact problem in sequence; owns its workspace.
template <int D>
class WeightedRelaxation {
 public:
  /// @param compliance F, Dm x Dm, scaled to mean diagonal 1 of its normal block
  /// @param motions of an unconstrained body
  WeightedRelaxation(const Eigen::MatrixXd& compliance, const Motions<double>& motions);

  /// minimise() throws support::Stopped soon after this becomes true.
  void end_when(support::Stop stop) { stop_ = std::move(stop); }

  /// @param friction mu, m numbers  @param gap a, m numbers >= 0  @param reaction b, likewise
  /// @return nothing if the iteration does not converge, as where the relaxation is empty
  std::optional<RelaxedPoint> minimise(std::span<const double> friction, const Eigen::VectorXd& gap,
                                       const Eigen::VectorXd& reaction);

 private:
  using Vector = Eigen::VectorXd;
  using Point = ConePoint<D>;

  struct Steps {
    double primal, dual;
  };

  void start(const Vector& gap, const Vector& reaction);
  void set_residuals();
  [[nodiscard]] bool converged() const;
  bool factorise();
  void direct(double share, bool corrected, double centring, double damping);
  [[nodiscard]] Steps longest_steps() const;
  [[nodiscard]] Point at(const Vector& points, int cone) const;
  void put(Vector& points, int cone, const Point& point) const;
  [[nodiscard]] Vector times(const Vector& points) const;
  [[nodiscard]] Vector transposed_times(const Vector& weights) const;
  [[nodiscard]] PackedColumns<> columns(const Eigen::MatrixXd& matrix) const;

  int m_, rows_, stride_;
  Eigen::MatrixXd unit_matrix_;      // A at mu = 1: rows u_n, G'r and sum, padded
  Eigen::MatrixXd matrix_, scaled_;  // A, and A W
  Eigen::MatrixXd free_;             // H: rows of the unit matrix
  NormalEquations<> equations_;
  std::vector<NesterovToddScaling<D>> scaling_;
  Vector right_side_, cost_, gap_cost_;
  Vector x_, z_, v_, s_, y_, alpha_;  // cones by component; slacks; rows; motions
  Vector primal_residual_, dual_residual_, slack_residual_, balance_;
  Vector dx_, dz_, dv_, ds_, dy_, dalpha_, affine_x_, affine_z_, affine_v_, affine_s_;
  Eigen::MatrixXd moved_;  // M^-1 H
  Eigen::MatrixXd schur_inverse_;
  double hold_ = 0;             // weight of H H' in M
  double complementarity_ = 0;  // of an average pair
  support::Stop stop_;
};

extern template class WeightedRelaxation<2>;
extern template class WeightedRelaxation<3>;

}  // namespace kusabi::conic
