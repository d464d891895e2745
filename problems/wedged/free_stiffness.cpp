// With the stiffness S of the body on minimal grounding springs, K = S - S G (G'S G)^-1 G'S. It has
// the modes G as null space and agrees with S for forces in equilibrium.
#include "problems/wedged/free_stiffness.hpp"

#include <Eigen/LU>

#include "problems/wedged/precise_compliance.hpp"

namespace kusabi::problems {

Eigen::MatrixXd free_stiffness(const WedgedProblem& problem) {
  using numbers::Precise;
  using numbers::PreciseMatrix;
  const bool stored = problem.compliance.stiffness.size() != 0;
  if (problem.modes.matrix.cols() == 0) {
    return stored ? problem.compliance.stiffness
                  : Eigen::MatrixXd(stiffness_of(problem.compliance.precise).cast<double>());
  }
  const bool precise = problem.compliance.precise.size() != 0;
  const PreciseMatrix held = precise ? stiffness_of(problem.compliance.precise)
                                     : PreciseMatrix(problem.compliance.stiffness.cast<Precise>());
  const PreciseMatrix g = problem.modes.precise.size() != 0
                              ? problem.modes.precise
                              : PreciseMatrix(problem.modes.matrix.cast<Precise>());
  const PreciseMatrix forces = held * g;
  const PreciseMatrix gram = g.transpose() * forces;
  const PreciseMatrix shares = gram.partialPivLu().solve(PreciseMatrix(forces.transpose()));
  const Eigen::MatrixXd free = (held - forces * shares).cast<double>();
  Eigen::MatrixXd sum = (free + free.transpose()) / 2;
  // The difference of equal numbers in 104 bits is zero up to a rounding.
  constexpr double rounded = 0x1p-90;
  const Eigen::ArrayXd scale = held.diagonal().cast<double>().array().sqrt();
  if (precise)
    sum = (sum.array().abs() > rounded * (scale.matrix() * scale.matrix().transpose()).array())
              .select(sum, 0.0);
  return sum;
}

}  // namespace kusabi::problems
