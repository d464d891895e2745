// The relaxation as a linear program to which rows are added.
#include "nodes/limit/root/master.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

namespace kusabi::limit {
namespace {

/// Upper limit of c+, c- and gamma, where motions with f_R'u = 1 are of the order of one: it keeps
/// the program bounded while there are too few cuts. Proofs do not use it.
constexpr double far = 1e4;

// The variable d_j'u of each column of T: the displacement itself for the first column that equals
// it; a variable from `next` on for all others.
std::vector<int> motions_along(const problems::LimitModel& model, int next) {
  std::vector<bool> taken(static_cast<std::size_t>(model.free_count()), false);
  std::vector<int> along;
  for (const auto& column : model.uncertain) {
    const auto& [degree, value] = column.direction.front();
    const auto at = static_cast<std::size_t>(degree);
    const bool itself = column.direction.size() == 1 && value == 1 && !taken[at];
    if (itself) taken[at] = true;
    along.push_back(itself ? degree : next++);
  }
  return along;
}

int first_motion_along(const problems::LimitModel& model) {
  return model.free_count() + 2 * model.member_count() + model.uncertain_count();
}

// The variables from first_motion_along() on and their rows, d_j'u - v_j = 0.
void add_motions_along(const problems::LimitModel& model, linear::LinearProgram& program) {
  const auto along = motions_along(model, first_motion_along(model));
  for (std::size_t j = 0; j < along.size(); ++j) {
    if (along[j] < model.free_count()) continue;
    std::vector<linear::LinearTerm> terms{{program.add_column({.lower = -linear::infinity}), -1}};
    for (const auto& [degree, value] : model.uncertain[j].direction) {
      terms.push_back({degree, value});
    }
    program.add_row({.lower = 0, .upper = 0}, terms);
  }
}

linear::LinearProgram relaxation(const problems::LimitModel& model, double alpha) {
  linear::LinearProgram program;
  program.name = "static relaxation";
  for (int k = 0; k < model.free_count(); ++k) {
    program.add_column({.cost = -model.dead(k), .lower = -linear::infinity});
  }
  for (const auto* yield : {&model.tension, &model.compression}) {
    for (const double cost : *yield) program.add_column({.cost = cost, .upper = far});
  }
  for (int j = 0; j < model.uncertain_count(); ++j) {
    const double weight = model.uncertain[static_cast<std::size_t>(j)].weight;
    program.add_column({.cost = -alpha * weight, .upper = far});
  }
  std::vector<linear::LinearTerm> terms;
  terms.reserve(static_cast<std::size_t>(model.free_count()));
  for (int k = 0; k < model.free_count(); ++k) terms.push_back({k, model.reference(k)});
  program.add_row({.lower = 1, .upper = 1}, terms);
  for (int i = 0; i < model.member_count(); ++i) {
    const int elongation = model.free_count() + i;
    terms = {{elongation, -1}, {elongation + model.member_count(), 1}};
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model.equilibrium, i); entry; ++entry) {
      terms.push_back({static_cast<int>(entry.row()), entry.value()});
    }
    program.add_row({.lower = 0, .upper = 0}, terms);
  }
  terms.clear();
  const Eigen::VectorXd yield = model.yield();
  for (int side = 0; side < 2; ++side) {
    for (int i = 0; i < model.member_count(); ++i) {
      terms.push_back({model.free_count() + side * model.member_count() + i, yield(i)});
    }
  }
  program.add_row({}, terms);  // the dissipation
  add_motions_along(model, program);
  return program;
}

}  // namespace

Master::Master(const problems::LimitModel& model, double alpha, support::Stop stop)
    : model_(model),
      alpha_(alpha),
      stop_(std::move(stop)),
      reduction_(Eigen::VectorXd::Zero(model.member_count())),
      signs_(model.uncertain.size(), 0),
      along_(motions_along(model, first_motion_along(model))),
      simplex_(relaxation(model, alpha)),
      first_cut_row_(simplex_.rows()) {}

void Master::reduce_yield_forces(const Eigen::VectorXd& reduction) {
  if (reduction == reduction_) return;
  reduction_ = reduction;
  for (int i = 0; i < model_.member_count(); ++i) {
    const int column = model_.free_count() + i;
    simplex_.set_cost(column, model_.tension(i) - reduction_(i));
    simplex_.set_cost(column + model_.member_count(), model_.compression(i) - reduction_(i));
  }
}

// Members whose yield force limits a motion that reaches the limit of its box: equilibrium
// determines their forces, so they have no margin.
std::vector<int> Master::members_without_choice() const {
  constexpr double along = 1e-2 * far;  // elongation of a member that moves with it
  std::vector<int> members;
  bool to_the_end = false;
  for (int i = 0; i < model_.member_count(); ++i) {
    const int column = model_.free_count() + i;
    const double maximum = std::max(simplex_.optimum().value(column),
                                    simplex_.optimum().value(column + model_.member_count()));
    to_the_end = to_the_end || maximum >= far;
    if (reduction_(i) != 0 && maximum >= along) members.push_back(i);
  }
  if (!to_the_end) members.clear();
  return members;
}

// True if the optimal dual, within the tolerances of the simplex method, keeps at least half of the
// margin of each member, and gives the cuts of each column their share.
bool Master::has_margin(double share) const {
  constexpr double kept = 0.5;
  for (int i = 0; i < model_.member_count(); ++i) {
    if (reduction_(i) == 0) continue;
    for (const int side : {0, model_.member_count()}) {
      const double slack = simplex_.optimum().reduced_cost(model_.free_count() + side + i);
      if (slack < -kept * reduction_(i)) return false;
    }
  }
  // A too small share is scaled, at the expense of the members.
  constexpr double lost = 0.1;
  for (int j = 0; j < model_.uncertain_count(); ++j) {
    if (signs_[static_cast<std::size_t>(j)] != 0) continue;
    const double weight = model_.uncertain[static_cast<std::size_t>(j)].weight;
    if (simplex_.optimum().reduced_cost(gamma_column(j)) < -lost * share * alpha_ * weight)
      return false;
  }
  return true;
}

bool Master::solve_with_margin(double first, bool for_all) {
  const double maximum = std::max(2e-7, first);
  Eigen::VectorXd has_choice = Eigen::VectorXd::Ones(model_.member_count());
  for (double share = first; share <= maximum;) {
    // Forces are of the order of one, or of their yield force.
    reduce_yield_forces(share * has_choice);
    if (!solve()) return false;
    const auto without = for_all ? std::vector<int>() : members_without_choice();
    for (const int member : without) has_choice(member) = 0;
    if (!without.empty()) continue;
    if (has_margin(share)) return true;
    share *= 10;
  }
  return true;  // decided by the exact proof
}

void Master::limit_dissipation(double maximum) {
  simplex_.set_row_bounds(dissipation_row(), -linear::infinity, maximum);
}

void Master::add(const StaticCut& cut) {
  std::vector<linear::LinearTerm> terms{{gamma_column(cut.column), 1}};
  for (const auto& [member, force] : cut.forces) {
    const int elongation = model_.free_count() + member;
    terms.push_back({elongation, -std::abs(force)});
    terms.push_back({elongation + model_.member_count(), -std::abs(force)});
  }
  simplex_.add_row(-linear::infinity, std::abs(cut.factor), terms);
  ++cuts_;
}

void Master::drop_cuts_from(std::size_t first) {
  simplex_.drop_rows_from(first_cut_row() + static_cast<int>(first));
  cuts_ = first;
}

void Master::decide(const Signs& signs) {
  reduce_yield_forces(Eigen::VectorXd::Zero(model_.member_count()));
  for (int j = 0; j < model_.uncertain_count(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    if (signs[at] == signs_[at]) continue;
    const double weight = model_.uncertain[at].weight;
    const int along = along_[at];
    const double infinity = linear::infinity;
    simplex_.set_column_bounds(along, signs[at] > 0 ? 0 : -infinity, signs[at] < 0 ? 0 : infinity);
    const double dead = along < model_.free_count() ? model_.dead(along) : 0;
    simplex_.set_cost(along, -dead - signs[at] * alpha_ * weight);
    simplex_.set_column_bounds(gamma_column(j), 0, signs[at] == 0 ? far : 0);
    simplex_.set_cost(gamma_column(j), signs[at] == 0 ? -alpha_ * weight : 0);
  }
  signs_ = signs;
}

// A motion without cost may lie at the limit of its box by chance; the bound depends on the box
// only if a further motion would decrease the objective.
bool Master::box_is_active() const {
  constexpr double gain = 1e-9;  // tolerance of the simplex method where yield forces are one
  for (int column = model_.free_count(); column < first_motion_along(model_); ++column) {
    if (simplex_.optimum().value(column) >= far && simplex_.optimum().reduced_cost(column) < -gain)
      return true;
  }
  return false;
}

bool Master::solve() {
  return std::holds_alternative<linear::CheckedOptimum>(simplex_.solve(stop_));
}

bool Master::is_interrupted() const {
  const auto* const open = std::get_if<linear::NotDetermined>(&simplex_.answer());
  return open != nullptr && open->interrupted;
}

Relaxed Master::relaxed() const {
  Relaxed point;
  point.motion.resize(model_.free_count());
  for (int k = 0; k < model_.free_count(); ++k) point.motion(k) = simplex_.optimum().value(k);
  point.z.resize(model_.member_count());
  for (int i = 0; i < model_.member_count(); ++i) {
    const int elongation = model_.free_count() + i;
    point.z(i) = simplex_.optimum().value(elongation) +
                 simplex_.optimum().value(elongation + model_.member_count());
  }
  point.gamma.resize(model_.uncertain_count());
  for (int j = 0; j < model_.uncertain_count(); ++j) {
    const double sign = signs_[static_cast<std::size_t>(j)];
    const int along = along_[static_cast<std::size_t>(j)];
    point.gamma(j) = simplex_.optimum().value(gamma_column(j));
    if (sign != 0) point.gamma(j) = sign * simplex_.optimum().value(along);
  }
  return point;
}

StaticProof Master::proof() const {
  StaticProof proof;
  proof.signs = signs_;
  proof.factor = simplex_.optimum().dual(0);
  proof.forces.resize(model_.member_count());
  // The dual of a row B'u - c+ + c- = 0 is minus the force: the cost of B'u in -f_D'u.
  for (int i = 0; i < model_.member_count(); ++i) proof.forces(i) = -simplex_.optimum().dual(1 + i);
  for (std::size_t c = 0; c < cuts_; ++c) {
    proof.mu.push_back(
        std::max(0.0, -simplex_.optimum().dual(first_cut_row() + static_cast<int>(c))));
  }
  proof.one_sided = Eigen::VectorXd::Zero(model_.uncertain_count());
  for (int j = 0; j < model_.uncertain_count(); ++j) {
    const double sign = signs_[static_cast<std::size_t>(j)];
    const int along = along_[static_cast<std::size_t>(j)];
    if (sign != 0)
      proof.one_sided(j) = std::max(0.0, sign * simplex_.optimum().reduced_cost(along));
  }
  return proof;
}

}  // namespace kusabi::limit
