// Program (45), row by row.
#include "problems/limit/dual_limit.hpp"

#include <cstddef>
#include <utility>

namespace kusabi::problems {
namespace {

using linear::infinity;
using linear::LinearProgram;

class DualProgram {
 public:
  DualProgram(const LimitModel& model, const Eigen::VectorXd& big_m,
              std::span<const FixedTau> fixed)
      : model_(model), big_m_(big_m), fixed_(fixed) {}

  LinearProgram write(double alpha, std::span<const RelaxationCut> cuts) {
    program_.name = "dual (45) of the relaxation of (29)";
    write_columns();
    write_rows(alpha);
    write_equilibrium();
    for (int j = 0; j < m_; ++j) write_uncertain(j);
    for (const auto& cut : cuts) write_cut(cut);
    return std::move(program_);
  }

 private:
  [[nodiscard]] FixedTau fixed(int j) const { return fixed_[static_cast<std::size_t>(j)]; }
  void entry(int row, int column, double value) {
    program_.entries.push_back({row, column, value});
  }

  // A multiplier >= 0, or one eliminated by (a), (b).
  void multiplier(double cost, bool eliminated = false) {
    program_.add_column({.cost = cost, .upper = eliminated ? 0 : infinity});
  }

  void write_columns() {
    program_.add_column({.cost = -1, .lower = -infinity});  // rho^lambda
    for (int i = 0; i < 2 * members_; ++i) multiplier(0);
    // For tau_j = 1 the constant M of row j of (42e) vanishes.
    for (int j = 0; j < m_; ++j) {
      multiplier(fixed(j) == FixedTau::not_fixed ? big_m_(j) : 0, fixed(j) == FixedTau::at_zero);
    }
    for (int j = 0; j < m_; ++j) multiplier(0, fixed(j) == FixedTau::at_one);
    for (int j = 0; j < m_; ++j) multiplier(0, fixed(j) != FixedTau::not_fixed);
    for (int j = 0; j < m_; ++j) multiplier(1, fixed(j) != FixedTau::not_fixed);
  }

  void write_rows(double alpha) {
    const Eigen::VectorXd shift = (model_.tension - model_.compression) / 2;
    const Eigen::VectorXd load = model_.dead - model_.equilibrium * shift;
    for (const double each : load) program_.add_row({.lower = each, .upper = each}, {});
    for (const double each : model_.yield()) program_.add_row({.lower = each, .upper = each}, {});
    for (const auto& column : model_.uncertain) {
      const double share = alpha * column.weight;
      program_.add_row({.lower = share, .upper = share}, {});
    }
    for (int j = 0; j < m_; ++j) {
      const bool kept = fixed(j) == FixedTau::not_fixed;
      program_.add_row({.lower = kept ? 0 : -infinity, .upper = kept ? 0 : infinity}, {});
    }
  }

  // (45b) without T, and (45c).
  void write_equilibrium() {
    for (int k = 0; k < degrees_; ++k) {
      if (model_.reference(k) != 0) entry(k, 0, -model_.reference(k));
    }
    for (int i = 0; i < members_; ++i) {
      for (Eigen::SparseMatrix<double>::InnerIterator each(model_.equilibrium, i); each; ++each) {
        entry(static_cast<int>(each.row()), 1 + i, each.value());
        entry(static_cast<int>(each.row()), 1 + members_ + i, -each.value());
      }
      entry(degrees_ + i, 1 + i, 1);
      entry(degrees_ + i, 1 + members_ + i, 1);
    }
  }

  // T in (45b), (45d) and (45e).
  void write_uncertain(int j) {
    const int plus = zeta_ + j;
    const int minus = plus + m_;
    for (const auto& [degree, value] : model_.uncertain[static_cast<std::size_t>(j)].direction) {
      entry(degree, plus, -value);
      entry(degree, minus, value);
    }
    const int of_gamma = degrees_ + members_ + j;
    entry(of_gamma, plus, 1);
    entry(of_gamma, minus, 1);
    const int of_tau = of_gamma + m_;
    entry(of_tau, plus, big_m_(j));
    entry(of_tau, minus, -big_m_(j));
    entry(of_tau, minus + m_, -1);     // rho^+
    entry(of_tau, minus + 2 * m_, 1);  // rho^-
  }

  // The columns of (42) are the rows of (45), in the same order.
  void write_cut(const RelaxationCut& cut) {
    const int mu = program_.add_column({});
    double lower = cut.lower;
    const int first_tau = degrees_ + members_ + m_;
    const int first_z = degrees_;
    const int first_gamma = degrees_ + members_;
    for (const auto& [column, value] : cut.terms) {
      if (column >= first_tau && fixed(column - first_tau) != FixedTau::not_fixed) {
        if (fixed(column - first_tau) == FixedTau::at_one) lower -= value;
        continue;
      }
      // In (45b), (45d) and (45e) A mu is on the right-hand side, in (45c) on the left.
      const bool on_the_left = column >= first_z && column < first_gamma;
      entry(column, mu, on_the_left ? value : -value);
    }
    program_.columns[static_cast<std::size_t>(mu)].cost = -lower;
  }

  const LimitModel& model_;
  const Eigen::VectorXd& big_m_;
  std::span<const FixedTau> fixed_;
  const int degrees_ = model_.free_count();
  const int members_ = model_.member_count();
  const int m_ = model_.uncertain_count();
  const int zeta_ = 1 + 2 * members_;  // the first zeta^+
  LinearProgram program_;
};

}  // namespace

LinearProgram dual_program(const LimitModel& model, double alpha, const Eigen::VectorXd& big_m,
                           std::span<const FixedTau> fixed, std::span<const RelaxationCut> cuts) {
  return DualProgram(model, big_m, fixed).write(alpha, cuts);
}

}  // namespace kusabi::problems
