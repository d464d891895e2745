// Solution in doubles, escalated to higher precision levels where necessary.
#include "nodes/wedged/relaxation/contact_solver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>
#include <utility>

namespace kusabi::wedged {

using support::IndexSet;

namespace {

// Relative accuracy of the margin of a leaf.
constexpr double three_digits = 1e-3;

// Rounding of the quotient of F and its unit.
constexpr double scaling_roundings = 1.01;

/// G in 104 bits, combined as the solvers require.
conic::Motions<numbers::Precise> combined(const problems::WedgedProblem& problem, int loads,
                                          conic::SideEquation equation) {
  const bool precise = problem.modes.precise.size() != 0;
  const numbers::PreciseMatrix given =
      precise ? problem.modes.precise
              : numbers::PreciseMatrix(problem.modes.matrix.cast<numbers::Precise>());
  const double error = precise ? problem.modes.precise_error : problem.modes.error;
  if (problem.dimension == 2)
    return conic::ordered_motions<2, numbers::Precise>(given, error, loads, equation);
  return conic::ordered_motions<3, numbers::Precise>(given, error, loads, equation);
}

/// Owners of the cones, one for each candidate.
std::vector<int> one_cone_each(std::size_t candidates) {
  std::vector<int> owners(candidates);
  std::iota(owners.begin(), owners.end(), 0);
  return owners;
}

template <class Real>
constexpr double scaling_error = scaling_roundings* numbers::unit_roundoff<Real>;

}  // namespace

ContactSolver::ContactSolver(const problems::WedgedProblem& problem,
                             std::span<const double> friction, conic::Tolerances tolerances,
                             Precision precision, int loads, conic::SideEquation equation)
    : dimension_(problem.dimension),
      unit_(loads == 0 ? problems::margin_unit(problem)
                       : problems::mean_normal_compliance(problem)),
      tolerances_(tolerances),
      precision_(precision),
      loads_(loads),
      friction_(friction.begin(), friction.end()),
      compliance_(problem.compliance.matrix),
      precise_compliance_(problem.compliance.precise),
      compliance_error_(problem.compliance.error),
      precise_error_(problem.compliance.precise_error),
      motions_(combined(problem, loads, equation)),
      solver_([&]() -> decltype(solver_) {
        const Eigen::MatrixXd scaled = problem.compliance.matrix / unit_;
        const double error = problem.compliance.error + scaling_error<double>;
        if (problem.dimension == 2)
          return conic::NodeSolver<2>(scaled, friction, one_cone_each(friction.size()), tolerances,
                                      error, motions<double>(), loads);
        return conic::NodeSolver<3>(scaled, friction, one_cone_each(friction.size()), tolerances,
                                    error, motions<double>(), loads);
      }()) {}

void ContactSolver::make_room(int max_cuts) {
  std::visit([&](auto& solver) { solver.make_room(max_cuts); }, solver_);
}

void ContactSolver::end_when(const support::Stop& stop) {
  stop_ = stop;
  std::visit([&](auto& solver) { solver.end_when(stop); }, solver_);
}

Eigen::VectorXd ContactSolver::motion() const {
  return motions_.combination.cast<double>().leftCols(motion_.size()) * motion_;
}

void ContactSolver::set_friction(std::span<const double> friction) {
  std::visit([&](auto& solver) { solver.set_friction(friction); }, solver_);
  friction_.assign(friction.begin(), friction.end());
}

template <class Real>
Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> ContactSolver::scaled_compliance() const {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  const Matrix whole = precise_compliance_.size() != 0
                           ? Matrix(precise_compliance_.template cast<Real>())
                           : Matrix(compliance_.template cast<Real>());
  return whole / Real(unit_);
}

template <class Real>
conic::Motions<Real> ContactSolver::motions() const {
  const double largest =
      motions_.count() == 0 ? 0 : motions_.at_cones.template cast<double>().cwiseAbs().maxCoeff();
  return motions_.template cast<Real>(largest * numbers::unit_roundoff<Real>);
}

template <class Vector>
Eigen::VectorXd ContactSolver::given(const Vector& multipliers) const {
  Eigen::VectorXd result = multipliers.template cast<double>();
  const Eigen::Index p = motions_.count();
  if (p > 0)
    result.tail(p) = motions_.combination.template cast<double>() * Eigen::VectorXd(result.tail(p));
  return result;
}

template <class Real>
double ContactSolver::scaled_error() const {
  if (precise_compliance_.size() == 0) return compliance_error_ + scaling_error<Real>;
  return precise_error_ + 2 * scaling_error<Real>;
}

template <class Real>
auto ContactSolver::made(Level<Real>& level) -> Level<Real>& {
  if (!std::holds_alternative<std::monostate>(level)) return level;
  if (dimension_ == 2)
    level.template emplace<1>(scaled_compliance<Real>(), friction_, one_cone_each(friction_.size()),
                              tolerances_, scaled_error<Real>(), motions<Real>(), loads_);
  else
    level.template emplace<2>(scaled_compliance<Real>(), friction_, one_cone_each(friction_.size()),
                              tolerances_, scaled_error<Real>(), motions<Real>(), loads_);
  return level;
}

namespace {

/// Calls `function` with the solver of a precision level that has been constructed.
template <class Level, class Function>
auto with(Level& level, Function function) {
  if (auto* plane = std::get_if<1>(&level)) return function(*plane);
  return function(std::get<2>(level));
}

}  // namespace

template <class Solver>
void ContactSolver::take(const Solver& solver, const conic::ConicResult& again,
                         conic::ConicResult& answer) {
  if (again.lower > answer.lower) {
    answer.lower = again.lower;
    answer.has_point = again.has_point;
    answer.primal_residual = again.primal_residual;
    reaction_ = solver.reaction().template cast<double>();
    displacement_ = solver.displacement().template cast<double>();
    motion_ = solver.motion().template cast<double>();
  }
  if (again.upper < answer.upper) {
    answer.upper = again.upper;
    multipliers_ = given(solver.multipliers());
  }
  answer.sign = conic::sign_of(answer, tolerances_);
  answer.gap = answer.upper - answer.lower;
}

// From what costs least to what costs most, until the node is resolved.
template <int D>
void ContactSolver::escalate(const IndexSet& contact, const IndexSet& separated,
                             const IndexSet& ignored, conic::StopEarly stop,
                             conic::ConicResult& answer) {
  const auto solver_of = [&](auto& level) -> auto& {
    auto& solver = std::get<D - 1>(made(level));
    solver.end_when(stop_);
    solver.set_friction(friction_);
    return solver;
  };
  const auto resolves = [&](const auto& solver, const conic::ConicResult& again) {
    answer.iterations += again.iterations;
    take(solver, again, answer);
    return !is_unresolved(answer, stop);
  };
  auto& doubles = std::get<D - 2>(solver_);
  auto& precise = solver_of(precise_level_);
  if (resolves(precise, doubles.examine_with(precise))) return;
  answer.precision_level = 1;
  auto& longer = solver_of(long_level_);
  const auto from_doubles = longer.solve_from(doubles, contact, separated, stop, ignored);
  if (resolves(longer, from_doubles)) return;
  const bool nothing_proved = !from_doubles.has_point && std::isinf(from_doubles.upper);
  if (nothing_proved && resolves(longer, longer.solve(contact, separated, stop, ignored))) return;
  if (resolves(precise, longer.examine_with(precise))) return;
  answer.precision_level = 2;
  if (resolves(precise, precise.solve_from(longer, contact, separated, stop, ignored))) return;
  resolves(precise, precise.solve(contact, separated, stop, ignored));
}

bool ContactSolver::has_centre(const conic::ConicResult& answer, conic::StopEarly stop) const {
  return answer.sign == conic::Sign::feasible && stop.when_feasible && motions_.count() == 0;
}

bool ContactSolver::is_unresolved(const conic::ConicResult& answer, conic::StopEarly stop) const {
  if (precision_ == Precision::doubles) return false;
  if (answer.sign == conic::Sign::unproved) return !conic::is_unresolvable(answer, tolerances_);
  return answer.sign == conic::Sign::feasible && !stop.when_feasible &&
         answer.upper - answer.lower > three_digits * answer.lower;
}

conic::ConicResult ContactSolver::solve_with(std::span<const conic::Cut> cuts,
                                             const IndexSet& contact, const IndexSet& separated,
                                             conic::StopEarly stop) {
  return std::visit(
      [&](auto& solver) {
        const conic::ConicResult answer = solver.solve(contact, separated, stop, {}, cuts);
        reaction_ = solver.reaction();
        displacement_ = solver.displacement();
        motion_ = solver.motion();
        multipliers_ = solver.multipliers();
        if (motions_.count() > 0) multipliers_ = given(solver.multipliers());
        for (std::size_t cut = 0; cut < cuts.size(); ++cut)
          multipliers_[cuts[cut].candidate] -= cuts[cut].displacement * solver.cut_multiplier(cut);
        has_centre_ = has_centre(answer, stop);
        return answer;
      },
      solver_);
}

const Eigen::VectorXd& ContactSolver::pull() {
  return std::visit([](auto& solver) -> const Eigen::VectorXd& { return solver.pull(); }, solver_);
}

double ContactSolver::max_of(std::size_t cut) {
  return std::visit([&](auto& solver) { return solver.max_of(cut); }, solver_);
}

double ContactSolver::cut_multiplier(std::size_t cut) const {
  return std::visit([&](const auto& solver) { return solver.cut_multiplier(cut); }, solver_);
}

conic::ConicResult ContactSolver::solve(const IndexSet& contact, const IndexSet& separated,
                                        conic::StopEarly stop, const IndexSet& ignored) {
  conic::ConicResult answer = std::visit(
      [&](auto& solver) {
        const conic::ConicResult first = solver.solve(contact, separated, stop, ignored);
        reaction_ = solver.reaction();
        displacement_ = solver.displacement();
        motion_ = solver.motion();
        multipliers_ = solver.multipliers();
        if (motions_.count() > 0) multipliers_ = given(solver.multipliers());
        return first;
      },
      solver_);
  has_centre_ = has_centre(answer, stop);
  if (!is_unresolved(answer, stop)) return answer;
  if (dimension_ == 2)
    escalate<2>(contact, separated, ignored, stop, answer);
  else
    escalate<3>(contact, separated, ignored, stop, answer);
  return answer;
}

std::span<const conic::FaceDistances> ContactSolver::face_distances() {
  if (!std::exchange(has_centre_, false)) return {};
  return std::visit([](auto& solver) { return solver.face_distances(); }, solver_);
}

std::optional<conic::RelativeInterior> ContactSolver::relative_interior(const IndexSet& contact,
                                                                        const IndexSet& separated,
                                                                        const IndexSet& ignored) {
  if (precision_ == Precision::doubles) return {};
  return with(made(precise_level_), [&](auto& solver) {
    solver.end_when(stop_);
    solver.set_friction(friction_);
    auto found = solver.relative_interior(contact, separated, ignored);
    reaction_ = solver.reaction().template cast<double>();
    displacement_ = solver.displacement().template cast<double>();
    motion_ = solver.motion().template cast<double>();
    multipliers_.setZero();
    if (found) found->moved &= moved_by(found->loaded);
    return found;
  });
}

// Reactions that vanish only approximately still displace other candidates. A displacement counts
// as zero if it is within the error of cancellation, of directions with sixteen digits in its block
// of F, or of F.
IndexSet ContactSolver::moved_by(const IndexSet& loaded) const {
  constexpr double cancelled = 1e-12;
  const double unknown = precise_compliance_.size() == 0 ? compliance_error_ : precise_error_;
  const auto own = [&](Eigen::Index row) { return std::sqrt(compliance_(row, row)); };
  const Eigen::Index d = dimension_;
  IndexSet moved;
  for (int i = 0; normal(i) < reaction_.size(); ++i) {
    double displacement = 0;
    double minimum = 0;
    for (const int k : loaded) {
      const double together = compliance_.block(normal(i), normal(k), d, d).cwiseAbs().maxCoeff();
      for (Eigen::Index column = normal(k); column < normal(k + 1); ++column) {
        const double size = std::abs(reaction_[column]);
        displacement += compliance_(normal(i), column) * reaction_[column];
        minimum += (cancelled * together + unknown * own(normal(i)) * own(column)) * size;
      }
    }
    for (Eigen::Index l = 0; l < motion_.size(); ++l) {
      const double lift = unit_ * numbers::rounded(motions_.at_cones(normal(i), l)) * motion_[l];
      displacement += lift;
      minimum += cancelled * std::abs(lift);
    }
    if (displacement > minimum) moved.insert(i);
  }
  return moved;
}

}  // namespace kusabi::wedged
