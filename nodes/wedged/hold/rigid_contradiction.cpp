// A node program without compliance: reactions of the others in equilibrium with the loads on the
// modes that leave the wedged candidates at rest.
#include "nodes/wedged/hold/rigid_contradiction.hpp"

#include <algorithm>
#include <vector>

#include <Eigen/QR>

#include "solvers/conic/motions.hpp"

namespace kusabi::wedged {
namespace {

using numbers::PreciseMatrix;
using support::IndexSet;

PreciseMatrix precise_modes(const problems::WedgedProblem& problem) {
  const auto& modes = problem.modes;
  return modes.precise.size() != 0 ? modes.precise
                                   : PreciseMatrix(modes.matrix.cast<numbers::Precise>());
}

// Rows of the candidates; of those without friction along the normal only, if asked.
std::vector<Eigen::Index> rows_of(const problems::WedgedProblem& problem,
                                  const IndexSet& candidates, bool all, double mu = 0) {
  const Eigen::Index d = problem.dimension;
  std::vector<Eigen::Index> rows;
  for (const int i : candidates) {
    const bool rough = all || mu * problem.friction[static_cast<std::size_t>(i)] > 0;
    for (Eigen::Index axis = 0; axis < (rough ? d : 1); ++axis) rows.push_back(d * i + axis);
  }
  return rows;
}

// Coefficients of the modes, by columns, that leave the candidates at rest, and on which the loads
// among them do no work.
// @param problem with loads, which are its last candidates without friction
PreciseMatrix modes_at_rest(const problems::WedgedProblem& problem, const IndexSet& candidates,
                            double mu) {
  const PreciseMatrix motions = precise_modes(problem);
  PreciseMatrix seen = motions(rows_of(problem, candidates, false, mu), Eigen::all);
  for (Eigen::Index row = 0; row < seen.rows(); ++row) {
    const double largest = seen.row(row).cast<double>().cwiseAbs().maxCoeff();
    if (largest > 0) seen.row(row) /= numbers::Precise(largest);
  }
  PreciseMatrix combination = PreciseMatrix::Identity(motions.cols(), motions.cols());
  const auto moving = conic::eliminate(seen, combination, 1, conic::negligible_mode).pivots;
  return combination.rightCols(motions.cols() - moving);
}

// The loads without displacements, and the candidates with a compliance of their own each, so that
// u_n >= t follows from the cones; on the given modes.
LoadedProblem rigid_part(const LoadedProblem& block, const IndexSet& candidates,
                         const PreciseMatrix& modes) {
  LoadedProblem part = loaded_block(block, candidates);
  auto& own = part.problem;
  const auto size = own.compliance.matrix.rows();
  own.compliance.matrix =
      problems::mean_normal_compliance(block.problem) * Eigen::MatrixXd::Identity(size, size);
  own.compliance.precise = own.compliance.matrix.cast<numbers::Precise>();
  const auto rows = rows_of(block.problem, candidates, true);
  own.modes.precise = PreciseMatrix(precise_modes(block.problem)(rows, Eigen::all)) * modes;
  own.modes.matrix = own.modes.precise.cast<double>();
  const double growth = std::max(1.0, modes.cast<double>().cwiseAbs().colwise().sum().maxCoeff());
  own.modes.error *= growth;
  own.modes.precise_error *= growth;
  part.loads.motions = PreciseMatrix(block.loads.motions * modes);
  part.loads.displacements.setZero();
  part.clearance.setZero();
  return part;
}

// Rows of the loads in the modes of a problem with loads.
Eigen::MatrixXd works_of(const problems::WedgedProblem& with_loads, std::size_t loads) {
  const Eigen::Index d = with_loads.dimension;
  const auto rows = d * static_cast<Eigen::Index>(loads);
  return with_loads.modes.matrix.bottomRows(rows)(Eigen::seqN(0, rows / d, d), Eigen::all);
}

// Without other candidates.
std::optional<Eigen::VectorXd> against_loads(const Eigen::MatrixXd& works) {
  const Eigen::VectorXd wanted = -Eigen::VectorXd::Ones(works.rows());
  Eigen::VectorXd beta = works.completeOrthogonalDecomposition().solve(wanted);
  if (!((works * beta).array() < -0.5).all()) return {};
  return beta;
}

}  // namespace

std::optional<Eigen::VectorXd> rigid_contradiction(const LoadedProblem& block,
                                                   std::span<const LoadShare> shares, double mu,
                                                   Precision precision,
                                                   const ReactingCandidates& candidates) {
  if (block.problem.modes.matrix.cols() == 0) return {};
  const auto whole = with_loads(block, shares);
  const PreciseMatrix modes = modes_at_rest(whole, candidates.wedged, mu);
  if (modes.cols() == 0) return {};
  std::vector<LoadShare> left;
  const auto first = static_cast<int>(block.problem.contact_names.size());
  for (std::size_t j = 0; j < shares.size(); ++j)
    if (!candidates.wedged.contains(first + static_cast<int>(j))) left.push_back(shares[j]);
  if (candidates.others.empty() && left.empty()) return {};
  const auto part = rigid_part(block, candidates.others, modes);
  const auto problem = with_loads(part, left);
  const auto works = works_of(problem, left.size());
  const auto of_all_modes = works_of(with_loads(block, left), left.size());
  for (Eigen::Index load = 0; load < works.rows(); ++load)
    if (works.row(load).norm() <= conic::negligible_mode * of_all_modes.row(load).norm()) return {};
  std::optional<Eigen::VectorXd> beta;
  if (candidates.others.empty()) {
    beta = against_loads(works);
  } else {
    ContactSolver solver(problem, friction_with_loads(part.problem, mu, left.size()),
                         hold_tolerances, precision, static_cast<int>(left.size()));
    if (solver.solve({}, {}, {}).sign == conic::Sign::infeasible)
      beta = solver.motion_multipliers();
  }
  if (!beta) return {};
  return Eigen::VectorXd(modes.cast<double>() * *beta);
}

}  // namespace kusabi::wedged
