// In the plane a reaction within the friction cone is a sum of two along its edges, each at least
// zero. One row for each rigid-body mode, scaled to the order of one.
#include "nodes/wedged/hold/statics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/LU>

#include "solvers/linear/simplex.hpp"

namespace kusabi::wedged {
namespace {

/// Smaller entries of programs scaled to the order of one are zero: GLPK would scale them up.
constexpr double negligible_entry = 1e-14;

/// Cost of sliding beside that of opening, in the choice of a motion.
constexpr double little = 1e-3;

/// Relative width to which a coefficient is bisected, far above the tolerance of the simplex method;
/// its basis then determines the coefficient to the last digits.
constexpr double static_width = 1e-6;

/// Linear program of a block, of its dead load and a multiple of its reference load.
struct StaticProgram {
  linear::LinearProgram program;
  int factor = -1;   ///< column of the factor of the reference load
  double scale = 1;  ///< of the factor

  StaticProgram(const LoadedProblem& block, double mu, bool with_reference,
                std::optional<double> total);
};

StaticProgram::StaticProgram(const LoadedProblem& block, double mu, bool with_reference,
                             std::optional<double> total) {
  const auto& problem = block.problem;
  const Eigen::MatrixXd& modes = problem.modes.matrix;               // 2m x p
  const Eigen::MatrixXd works = block.loads.motions.cast<double>();  // loads x p
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(modes.cols());
  const Eigen::VectorXd dead = block.has_dead ? Eigen::VectorXd(works.row(0)) : none;
  const Eigen::VectorXd reference =
      with_reference ? Eigen::VectorXd(works.row(block.has_dead ? 1 : 0)) : none;
  // Reactions in units of the loads.
  const double size = total ? *total : dead.isZero(0) ? reference.norm() : dead.norm();
  if (with_reference) scale = size / reference.norm();
  Eigen::VectorXd of_row(modes.cols());
  for (Eigen::Index mode = 0; mode < modes.cols(); ++mode) {
    const double largest =
        std::max({modes.col(mode).cwiseAbs().maxCoeff(), std::abs(dead[mode]) / size,
                  std::abs(reference[mode]) * scale / size});
    of_row[mode] = largest > 0 ? 1 / largest : 1;
    const double bound = -dead[mode] / size * of_row[mode];
    program.rows.push_back({bound, bound});
  }
  if (total) program.rows.push_back({1, 1});
  const auto add = [&](const Eigen::VectorXd& column, linear::LinearColumn bounds, double sum) {
    const int index = program.add_column(std::move(bounds));
    for (Eigen::Index mode = 0; mode < modes.cols(); ++mode) {
      const double value = column[mode] * of_row[mode];
      if (std::abs(value) > negligible_entry)
        program.entries.push_back({static_cast<int>(mode), index, value});
    }
    if (total && sum != 0) program.entries.push_back({static_cast<int>(modes.cols()), index, sum});
    return index;
  };
  for (int i = 0; i < static_cast<int>(problem.contact_names.size()); ++i) {
    const double own = mu * problem.friction[static_cast<std::size_t>(i)];
    const Eigen::VectorXd normal = modes.row(2 * i);
    const Eigen::VectorXd tangent = modes.row(2 * i + 1);
    add(normal + own * tangent, {}, 1);
    if (own > 0) add(normal - own * tangent, {}, 1);
  }
  if (with_reference)
    factor = add(reference * (scale / size), {0, -linear::infinity, linear::infinity}, 0);
}

// The coefficient near `mu` at which the first of the basic reactions vanishes: Newton's method for
// the others and the coefficient, on which the basic columns depend linearly. Nothing if it does not
// converge.
std::optional<double> end_of_basis(const LoadedProblem& block, double mu,
                                   const linear::Basis& basis) {
  using Real = long double;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  const auto& problem = block.problem;
  const Matrix modes = problem.modes.matrix.cast<Real>();
  const Vector load = block.loads.motions.row(0).transpose().cast<Real>();
  const Eigen::Index p = modes.cols();
  Matrix constant = Matrix::Zero(p, p);  // basic columns at mu: constant + mu slope
  Matrix slope = Matrix::Zero(p, p);
  Eigen::Index count = 0;
  for (std::size_t row = 0; row < basis.rows(); ++row)
    if (basis.row(row) == linear::BasisStatus::basic && count < p)
      constant(static_cast<Eigen::Index>(row), count++) = 1;
  const Eigen::Index first = count;
  std::size_t column = 0;
  for (Eigen::Index i = 0; i < modes.rows() / 2; ++i) {
    const double factor = problem.friction[static_cast<std::size_t>(i)];
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && !(mu * factor > 0)) continue;
      const bool basic = basis.column(column++) == linear::BasisStatus::basic;
      if (!basic) continue;
      if (count == p) return {};
      constant.col(count) = modes.row(2 * i).transpose();
      slope.col(count++) = Real(side * factor) * modes.row(2 * i + 1).transpose();
    }
  }
  if (count != p) return {};
  Real at = mu;
  const auto columns = [&]() -> Matrix { return constant + at * slope; };
  const Eigen::PartialPivLU<Matrix> factor(columns());
  Vector reactions = -factor.solve(load);
  const Vector rates = -factor.solve(slope * reactions);
  Eigen::Index leaving = -1;
  for (Eigen::Index k = first; k < p; ++k) {
    if (!(rates[k] > 0)) continue;
    if (leaving < 0 || reactions[k] * rates[leaving] < reactions[leaving] * rates[k]) leaving = k;
  }
  if (leaving < 0) return {};
  constexpr int steps = 4;
  reactions[leaving] = 0;
  for (int step = 0; step < steps; ++step) {
    Matrix tangent = columns();
    const Vector off = tangent * reactions + load;
    tangent.col(leaving) = slope * reactions;
    Vector change = tangent.partialPivLu().solve(-off);
    at += change[leaving];
    change[leaving] = 0;
    reactions += change;
  }
  const auto found = static_cast<double>(at);
  if (!(std::abs(found - mu) <= 2 * static_width * mu)) return {};
  return found;
}

// @param load its number among those that are there
bool is_answered_by_statics(const LoadedProblem& block, Eigen::Index load) {
  return block.problem.dimension == 2 && block.problem.modes.matrix.cols() > 0 &&
         !block.loads.motions.row(load).isZero(0);
}

// True if the dead load has reactions; nothing if that is numerically undecided.
std::optional<bool> balances_dead(const LoadedProblem& block, double mu, linear::Basis& basis,
                                  const support::Stop& stop) {
  linear::Simplex simplex(StaticProgram(block, mu, false, {}).program);
  if (!basis.empty()) simplex.set_basis(basis);
  const auto status = simplex.solve_robustly({.stop = stop});
  basis = simplex.basis();
  if (status == linear::LinearStatus::optimal) return true;
  if (status == linear::LinearStatus::infeasible) return false;
  return {};
}

}  // namespace

std::optional<StaticRange> static_range(const LoadedProblem& block, double mu,
                                        std::optional<double> total, const support::Stop& stop) {
  if (!block.has_reference || !is_answered_by_statics(block, block.has_dead ? 1 : 0)) return {};
  const StaticProgram statics(block, mu, true, total);
  linear::Simplex simplex(statics.program);
  const auto end = [&](double direction) -> std::optional<double> {
    simplex.set_cost(statics.factor, -direction);
    const auto status = direction > 0 ? simplex.solve_robustly({.stop = stop})
                                      : simplex.solve_primal({.stop = stop});
    if (status == linear::LinearStatus::unbounded) return direction * linear::infinity;
    if (status != linear::LinearStatus::optimal) return {};
    return simplex.value(statics.factor) * statics.scale;
  };
  const auto high = end(1);
  if (!high) return {};
  const auto low = end(-1);
  if (!low) return {};
  return StaticRange{*low, *high};
}

std::optional<double> static_friction(const LoadedProblem& block, double low, double high,
                                      const support::Stop& stop) {
  if (!block.has_dead || !is_answered_by_statics(block, 0)) return {};
  linear::Basis basis;
  const auto at_low = balances_dead(block, low, basis, stop);
  if (!at_low || *at_low) return {};
  const auto at_high = balances_dead(block, high, basis, stop);
  if (!at_high || !*at_high) return {};
  auto at_end = basis;  // of `high`
  while (high - low > static_width * high) {
    const double middle = low + (high - low) / 2;
    const auto balances = balances_dead(block, middle, basis, stop);
    if (!balances) return {};
    (*balances ? high : low) = middle;
    if (*balances) at_end = basis;
  }
  return end_of_basis(block, high, at_end).value_or(high);
}

std::optional<Eigen::VectorXd> static_motion(const LoadedProblem& block,
                                             const Eigen::VectorXd& load, double mu,
                                             const support::Stop& stop) {
  const auto& problem = block.problem;
  const Eigen::MatrixXd& modes = problem.modes.matrix;
  if (problem.dimension != 2 || load.isZero(0)) return {};
  // Modes in units in which they displace candidates by one at most.
  Eigen::VectorXd units(modes.cols());
  linear::LinearProgram program;
  for (Eigen::Index mode = 0; mode < modes.cols(); ++mode) {
    const double largest = modes.col(mode).cwiseAbs().maxCoeff();
    units[mode] = largest > 0 ? 1 / largest : 1;
    double opening = 0;
    for (Eigen::Index row = 0; row < modes.rows(); row += 2) opening += modes(row, mode);
    program.add_column({opening * units[mode], -linear::infinity, linear::infinity});
  }
  // Of motions that open alike, the one that slides least.
  const auto slides = modes.cols();
  for (Eigen::Index i = 0; i < modes.rows() / 2; ++i) program.add_column({.cost = little});
  std::vector<linear::LinearTerm> terms;
  const auto add_row = [&](double lower, double upper, const Eigen::VectorXd& row,
                           Eigen::Index slide) {
    terms.clear();
    for (Eigen::Index mode = 0; mode < row.size(); ++mode) {
      const double value = row[mode] * units[mode];
      if (std::abs(value) > negligible_entry) terms.push_back({static_cast<int>(mode), value});
    }
    if (slide > 0) terms.push_back({static_cast<int>(slide), 1});
    program.add_row({lower, upper}, terms);
  };
  for (Eigen::Index i = 0; i < modes.rows() / 2; ++i) {
    const double own = mu * problem.friction[static_cast<std::size_t>(i)];
    const Eigen::VectorXd normal = modes.row(2 * i);
    const Eigen::VectorXd tangent = modes.row(2 * i + 1);
    add_row(0, linear::infinity, normal + own * tangent, 0);
    if (own > 0) add_row(0, linear::infinity, normal - own * tangent, 0);
    for (const double side : {1.0, -1.0}) add_row(0, linear::infinity, side * tangent, slides + i);
  }
  const double size = load.cwiseProduct(units).cwiseAbs().maxCoeff();
  add_row(1, 1, load / size, 0);
  linear::Simplex simplex(program);
  if (simplex.solve_robustly({.stop = stop}) != linear::LinearStatus::optimal) return {};
  Eigen::VectorXd motion(modes.cols());
  for (Eigen::Index mode = 0; mode < modes.cols(); ++mode)
    motion[mode] = simplex.value(static_cast<int>(mode)) * units[mode];
  return motion;
}

}  // namespace kusabi::wedged
