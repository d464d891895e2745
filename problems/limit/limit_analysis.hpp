// The linear programs of plastic limit analysis as data: the static principle (5) and the kinematic
// one (15) of the limit paper, without units and with yield forces of their own in tension and
// compression, q^t and q^c.
//
// Every number is scaled to the order of one, because a simplex method
// has one tolerance for all. With F a force that is typical of the collapse, a member is measured
// in c_i = min(F, (q^t + q^c) / 2), the equilibrium of displacement e in Y_e = max_i |B_ei| c_i,
// and the reference load in R = max_e |f_R,e| / Y_e:
//
//   B~ = Y^-1 B C,  f~_D = Y^-1 f_D,  f~_R = Y^-1 f_R / R,  T~ = F Y^-1 T,  q~ = C^-1 q,
//   u~ = R Y u,  lambda~ = R lambda,  zeta~ = zeta / F.
//
// Column j of T~ is weight w~_j times a direction d~_j whose largest component is of size one. Its
// half-width is in the weight, so that one alpha goes for all.
// Units that differ by less than eight are one. A yield force of far more than F stands for
// "never"; it is cut off at `most_yield` c_i, which can only lower the load factor.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/limit/limit_problem.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::problems {

struct LimitModel {
  Eigen::SparseMatrix<double> equilibrium;  ///< B~, n^d x n^m
  Eigen::VectorXd dead;                     ///< f~_D
  Eigen::VectorXd reference;                ///< f~_R: its largest component is of the order of one
  Eigen::VectorXd tension;                  ///< q~^t, at most `most_yield`
  Eigen::VectorXd compression;              ///< q~^c, at most `most_yield`
  std::vector<UncertainColumn> uncertain;   ///< T~; its coefficients zeta are in force_unit
  Eigen::VectorXd direction_unit;           ///< m: a scaled load d~_j times this is d_j, force
  Eigen::VectorXd member_unit;              ///< c, n^m: a scaled force times this is in force
  Eigen::VectorXd displacement_unit;        ///< 1 / (R Y), n^d: u~ times this is u, f_R^T u = 1
  double force_unit = 1;                    ///< F, force
  double most_yield = 0;                    ///< scaled yield forces are cut off here
  double factor_unit = 1;                   ///< 1 / R: a scaled factor times this is the true one

  int free_count() const { return static_cast<int>(dead.size()); }
  int member_count() const { return static_cast<int>(tension.size()); }
  int uncertain_count() const { return static_cast<int>(uncertain.size()); }
  /// (q~^t + q~^c) / 2, 1/8 to `most_yield`: half of what a member can take in all, n^m.
  Eigen::VectorXd yield() const { return (tension + compression) / 2; }
  /// Y_e: a scaled load on displacement e times this is in force.
  double load_unit(int degree) const { return factor_unit / displacement_unit(degree); }
};

/// Where scaled yield forces are cut off, unless that is found to matter: what lies between, with
/// the fourteen digits that a simplex method has in its objective, still leaves ten.
inline constexpr double usual_most_yield = 0x1p14;

/// @param force_unit F
LimitModel limit_model(const LimitProblem& problem, double force_unit,
                       double most_yield = usual_most_yield);

/// With the median of the yield forces as F.
LimitModel limit_model(const LimitProblem& problem);

/// Without scaling: every number is in the units of the problem, and so are those of its programs.
/// For files that others read; what is solved here is scaled.
LimitModel unscaled_model(const LimitProblem& problem);

/// f_D + T zeta, scaled. @param zeta m, in force_unit
Eigen::VectorXd dead_load(const LimitModel& model, const Eigen::VectorXd& zeta);

/// q of scaled member forces, n^m, force.
Eigen::VectorXd forces_in_units(const LimitModel& model, const Eigen::VectorXd& forces);

/// u of a scaled motion, n^d, with f_R^T u = 1.
Eigen::VectorXd motion_in_units(const LimitModel& model, const Eigen::VectorXd& motion);

/// (5): minimise -lambda. Columns: q_1 ... q_nm, lambda. Rows: equilibrium, one a free
/// displacement; the duals of the rows are the collapse mode u with f_R^T u = 1.
linear::LinearProgram static_program(const LimitModel& model, const Eigen::VectorXd& dead);

/// (15), of the same optimum: minimise -(f_D - B (q^t - q^c) / 2)^T u + ((q^t + q^c) / 2)^T z:
/// yield forces that differ are those of q - (q^t - q^c) / 2, whose yield force is (q^t + q^c) / 2
/// either way. Columns: u_1 ... u_nd, z_1 ... z_nm. Rows: f_R^T u = 1; then z_i - b_i^T u >= 0 and
/// z_i + b_i^T u >= 0, member by member.
linear::LinearProgram kinematic_program(const LimitModel& model, const Eigen::VectorXd& dead);

}  // namespace kusabi::problems
