// Columns of the loads, condensed with the candidates, and their combinations.
#include "nodes/wedged/hold/load_program.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "problems/wedged/precise_compliance.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

using numbers::Precise;
using numbers::PreciseMatrix;
using numbers::PreciseVector;

/// Roundings of a combination of two loads and a clearance, divided by its scale.
constexpr double share_roundings = 16;

/// Bound of a mode's displacement of a node relative to that of the candidates, whose largest is
/// between 1/2 and 1.
constexpr double mode_size = 4;

/// The loads of the structure: dead and reference, or with cases the reference of each, d nodes x
/// 2 or 3.
Eigen::MatrixXd node_forces(const problems::Structure& structure,
                            std::span<const std::string> cases) {
  const Eigen::Index d = structure.dimension;
  const auto count = static_cast<Eigen::Index>(std::max<std::size_t>(1, cases.size()));
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(structure.coordinates.size(), 1 + count);
  for (const problems::Load& load : structure.loads) {
    Eigen::Index column = load.kind == problems::Load::Kind::dead ? 0 : 1;
    if (column == 1 && !cases.empty())
      column += std::ranges::find(cases, load.load_case) - cases.begin();
    if (column > count || (column == 0 && !cases.empty() && !load.load_case.empty())) continue;
    forces.col(column).segment(d * load.node, d) += load.force;
  }
  if (structure.imposed_forces.size() > 0) forces.col(0) += structure.imposed_forces.reshaped();
  return forces;
}

Eigen::Index count(const LoadedProblem& loaded) {
  return Eigen::Index{loaded.has_dead ? 1 : 0} + (loaded.has_reference ? 1 : 0) +
         (loaded.has_second ? 1 : 0);
}

/// The coefficient of each load that is there.
PreciseVector coefficients(const LoadedProblem& loaded, LoadShare share) {
  PreciseVector result(count(loaded));
  Eigen::Index place = 0;
  if (loaded.has_dead) result[place++] = Precise(share.dead);
  if (loaded.has_reference) result[place++] = Precise(share.reference);
  if (loaded.has_second) result[place] = Precise(share.second);
  return result;
}

double mean_of(const problems::WedgedProblem& problem) {
  return problems::mean_normal_compliance(problem);
}

/// Upper bound of sqrt(F_jj) of a combination, with its clearance.
double root_of(const LoadedProblem& loaded, LoadShare share) {
  const PreciseVector amounts = coefficients(loaded, share);
  double root = 0;
  for (Eigen::Index l = 0; l < amounts.size(); ++l)
    root += std::abs(numbers::rounded(amounts[l])) *
            std::sqrt(std::max(0.0, numbers::rounded(loaded.loads.work(l, l))));
  double gap = 0;
  for (Eigen::Index i = 0; i < loaded.clearance.size(); ++i) {
    const Eigen::Index normal = loaded.problem.dimension * i;
    gap = std::max(gap, std::abs(loaded.clearance[i]) /
                            std::sqrt(loaded.problem.compliance.matrix(normal, normal)));
  }
  return (root + std::abs(share.dead) * gap) * (1 + 1e-12);
}

/// @param all loads, d nodes x L; those that act on supports alone count as absent
LoadedProblem loaded_with(const problems::CheckedStructure& structure, const Eigen::MatrixXd& all,
                          const support::LongWork& work) {
  LoadedProblem loaded;
  const std::array present{&loaded.has_dead, &loaded.has_reference, &loaded.has_second};
  std::vector<Eigen::Index> columns;
  for (Eigen::Index k = 0; k < all.cols(); ++k) {
    if (all.col(k).isZero(0) || problems::acts_on_supports_only(structure.degrees(), all.col(k)))
      continue;
    *present.at(static_cast<std::size_t>(k)) = true;
    columns.push_back(k);
  }
  const Eigen::MatrixXd forces = all(Eigen::all, columns);
  loaded.problem = problems::wedged_problem(structure, forces, loaded.loads, work);
  loaded.clearance.resize(static_cast<Eigen::Index>(structure->contact.size()));
  for (std::size_t i = 0; i < structure->contact.size(); ++i)
    loaded.clearance[static_cast<Eigen::Index>(i)] = structure->contact[i].clearance;
  if (loaded.loads.motions.rows() != count(loaded))  // constrained bodies
    loaded.loads.motions = PreciseMatrix(count(loaded), 0);
  return loaded;
}

}  // namespace

bool acts(const LoadedProblem& block, Eigen::Index load) {
  return !block.loads.motions.row(load).isZero(0) || !block.loads.displacements.col(load).isZero(0);
}

bool is_under_dead(const LoadedProblem& block) {
  return !block.clearance.isZero(0) || (block.has_dead && acts(block, 0));
}

bool is_loaded(const LoadedProblem& block) {
  bool loaded = !block.clearance.isZero(0);
  for (Eigen::Index load = 0; load < count(block); ++load) loaded = loaded || acts(block, load);
  return loaded;
}

LoadedProblem loaded_problem(const problems::CheckedStructure& structure,
                             const support::LongWork& work) {
  return loaded_with(structure, node_forces(structure, {}), work);
}

LoadedProblem loaded_problem(const problems::CheckedStructure& structure,
                             const std::array<std::string, 2>& cases,
                             const support::LongWork& work) {
  return loaded_with(structure, node_forces(structure, cases), work);
}

EquivalentForces equivalent_forces(const LoadedProblem& loaded) {
  const auto& compliance = loaded.problem.compliance;
  const Eigen::Index size = compliance.matrix.rows();
  EquivalentForces forces{Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size)};
  if (!loaded.has_dead && !loaded.has_reference) return forces;
  const PreciseMatrix stiffness = problems::stiffness_of(compliance.precise);
  PreciseMatrix all = stiffness * loaded.loads.displacements;
  const PreciseMatrix& modes = loaded.problem.modes.precise;
  if (modes.cols() > 0) {
    const PreciseMatrix springs = stiffness * modes;
    const PreciseMatrix gram = modes.transpose() * springs;
    const PreciseMatrix missing = loaded.loads.motions.transpose() - modes.transpose() * all;
    all += springs * gram.partialPivLu().solve(missing);
  }
  // The difference of equal numbers in 104 bits is zero up to a rounding, and so are all forces of a
  // load that supports carry.
  constexpr double rounded = 0x1p-60;
  constexpr double carried = 0x1p-80;
  const auto column = [&](Eigen::Index k) -> Eigen::VectorXd {
    const Eigen::VectorXd own = all.col(k).cast<double>();
    const double smallest =
        std::max(rounded * own.cwiseAbs().maxCoeff(), carried * loaded.loads.sizes[k]);
    return (own.array().abs() > smallest).select(own, 0.0);
  };
  Eigen::Index place = 0;
  if (loaded.has_dead) forces.dead = column(place++);
  if (loaded.has_reference) forces.reference = column(place);
  return forces;
}

LoadedProblem loaded_block(const LoadedProblem& whole, const support::IndexSet& candidates) {
  LoadedProblem part = whole;
  part.problem = problems::block_problem(whole.problem, candidates);
  std::vector<Eigen::Index> normals;
  std::vector<Eigen::Index> rows;
  for (const int i : candidates) {
    normals.push_back(i);
    for (int axis = 0; axis < whole.problem.dimension; ++axis)
      rows.push_back(Eigen::Index{whole.problem.dimension} * i + axis);
  }
  part.clearance = whole.clearance(normals);
  std::vector<Eigen::Index> moving;  // as block_problem selects them
  for (Eigen::Index k = 0; k < whole.problem.modes.matrix.cols(); ++k)
    if (!whole.problem.modes.matrix(rows, k).isZero(0.0)) moving.push_back(k);
  part.loads.motions = whole.loads.motions(Eigen::all, moving);
  if (count(whole) > 0) part.loads.displacements = whole.loads.displacements(rows, Eigen::all);
  return part;
}

bool is_constrained(const LoadedProblem& loaded) {
  return loaded.problem.modes.matrix.cols() == 0 && loaded.loads.other_modes.cols() == 0;
}

double work_on_other_modes(const LoadedProblem& loaded, LoadShare share) {
  if (count(loaded) == 0 || loaded.loads.other_modes.cols() == 0) return 0;
  const PreciseVector amounts = coefficients(loaded, share);
  double size = 0;
  for (Eigen::Index l = 0; l < amounts.size(); ++l)
    size += std::abs(numbers::rounded(amounts[l])) * loaded.loads.sizes[l];
  if (size == 0) return 0;
  const PreciseVector work = loaded.loads.other_modes.transpose() * amounts;
  return work.cast<double>().cwiseAbs().maxCoeff() / size;
}

double scale_of(const LoadedProblem& loaded, LoadShare share) {
  const double root = root_of(loaded, share);
  return root == 0 ? 1 : root / std::sqrt(mean_of(loaded.problem));
}

problems::WedgedProblem with_loads(const LoadedProblem& loaded, std::span<const LoadShare> shares) {
  problems::WedgedProblem result = loaded.problem;
  if (shares.empty()) return result;
  const Eigen::Index d = result.dimension;
  const Eigen::Index own = result.compliance.matrix.rows();
  const Eigen::Index all = own + d * static_cast<Eigen::Index>(shares.size());
  const double mean = mean_of(loaded.problem);
  PreciseMatrix compliance = PreciseMatrix::Zero(all, all);
  compliance.topLeftCorner(own, own) =
      result.compliance.precise.size() != 0
          ? result.compliance.precise
          : PreciseMatrix(result.compliance.matrix.cast<Precise>());
  PreciseMatrix motions = PreciseMatrix::Zero(all, result.modes.matrix.cols());
  motions.topRows(own) = result.modes.precise.size() != 0
                             ? result.modes.precise
                             : PreciseMatrix(result.modes.matrix.cast<Precise>());
  double relative = 1;
  Eigen::Index column = own;
  for (const LoadShare& share : shares) {
    const double scale = scale_of(loaded, share);
    const PreciseVector amounts = coefficients(loaded, share) / Precise(scale);
    PreciseVector w = PreciseVector::Zero(own);
    if (amounts.size() > 0) w = loaded.loads.displacements * amounts;
    for (Eigen::Index i = 0; i < loaded.clearance.size(); ++i)
      w[d * i] += Precise(share.dead) * Precise(loaded.clearance[i]) / Precise(scale);
    compliance.col(column).head(own) = w;
    compliance.row(column).head(own) = w.transpose();
    for (Eigen::Index axis = 0; axis < d; ++axis)
      compliance(column + axis, column + axis) = Precise(mean);
    if (motions.cols() > 0 && amounts.size() > 0)
      motions.row(column) = (loaded.loads.motions.transpose() * amounts).transpose();
    double size = 0;
    for (Eigen::Index l = 0; l < amounts.size(); ++l)
      size += std::abs(numbers::rounded(amounts[l])) * loaded.loads.sizes[l];
    relative = std::max(relative, mode_size * size);
    column += d;
    result.contact_names.emplace_back("load");
    result.friction.push_back(0);
  }
  result.compliance.matrix = compliance.cast<double>();
  result.modes.matrix = motions.cast<double>();
  result.compliance.precise_error += share_roundings * numbers::unit_roundoff<Precise>;
  result.compliance.error += share_roundings * numbers::unit_roundoff<double>;
  result.compliance.precise = std::move(compliance);
  if (motions.cols() > 0) {
    result.modes.precise_error =
        relative * (result.modes.precise_error + share_roundings * numbers::unit_roundoff<Precise>);
    result.modes.error =
        relative * (result.modes.error + share_roundings * numbers::unit_roundoff<double>);
    result.modes.precise = std::move(motions);
  }
  result.blocks = {};
  return result;
}

double grip_scale(const LoadedProblem& loaded, std::span<const LoadShare> shares,
                  const GripRestriction& grip) {
  double largest = 1;
  for (const LoadShare& share : shares)
    largest = std::max(largest, share.dead * grip.total / scale_of(loaded, share));
  return largest;
}

problems::WedgedProblem with_grip(const LoadedProblem& loaded, std::span<const LoadShare> shares,
                                  const GripRestriction& grip) {
  auto result = with_loads(loaded, shares);
  const Eigen::Index d = result.dimension;
  const Eigen::Index own = d * loaded.clearance.size();
  const bool slack = grip.kind != GripRestriction::Kind::equal;
  const Eigen::Index all = result.compliance.matrix.rows() + (slack ? d : 0);
  const Eigen::Index modes = result.modes.matrix.cols();
  PreciseMatrix motions = PreciseMatrix::Zero(all, modes + 1);
  if (modes > 0) motions.topLeftCorner(result.modes.precise.rows(), modes) = result.modes.precise;
  const Precise scale(grip_scale(loaded, shares, grip));
  for (Eigen::Index normal = 0; normal < own; normal += d)
    motions(normal, modes) = Precise(1) / scale;
  Eigen::Index row = own;
  for (const LoadShare& share : shares) {
    motions(row, modes) =
        -Precise(share.dead) * Precise(grip.total) / Precise(scale_of(loaded, share)) / scale;
    row += d;
  }
  if (slack) {
    motions(row, modes) = Precise(grip.kind == GripRestriction::Kind::above ? -1 : 1);
    PreciseMatrix compliance = PreciseMatrix::Zero(all, all);
    compliance.topLeftCorner(row, row) = result.compliance.precise;
    for (Eigen::Index axis = 0; axis < d; ++axis)
      compliance(row + axis, row + axis) = Precise(mean_of(loaded.problem));
    result.compliance.matrix = compliance.cast<double>();
    result.compliance.precise = std::move(compliance);
    result.contact_names.emplace_back("sum");
    result.friction.push_back(0);
  }
  result.modes.matrix = motions.cast<double>();
  result.modes.precise = std::move(motions);
  result.modes.error += share_roundings * numbers::unit_roundoff<double>;
  result.modes.precise_error += share_roundings * numbers::unit_roundoff<Precise>;
  return result;
}

std::vector<double> friction_with_loads(const problems::WedgedProblem& problem, double mu,
                                        std::size_t loads) {
  std::vector<double> friction;
  for (const double factor : problem.friction) friction.push_back(mu * factor);
  friction.resize(friction.size() + loads, 0);
  return friction;
}

}  // namespace kusabi::wedged
