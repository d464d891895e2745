// Bounds: rigorous bounds of t* from approximate solutions, with rounding errors and the error of
// F.
//
// The iterations give points that satisfy their equations up to a residual, computed from an F with
// an error e: |F~_ij - F_ij| <= e sqrt(F_ii F_jj). The bounds hold for the program with the true F
// (docs/theory/wedged.md, "Rigorous bounds"). With n terms in a sum and the unit roundoff u of its
// numbers let eps = e + (n + 4) u and R_i = sqrt(F_ii).
//
// Upper bound: for multipliers y with y_j >= 0 off U, w = sum_i y_i (row (n, i) of F) and any tau
// >= w_nk + mu_k |w_tk| on C,
//
//   t* <= tau / N,   N = sum_{j not in U} y_j + sum_C (tau - w_nk) / mu_k  >= 0,
//
// so the sign is that of tau, for any scale of y. The error of w_k is eps R_k sum_i |y_i| R_i. A
// cut (cut.hpp) with the multiplier eta >= 0 adds eta level to N, and to w its left side as a
// function of r.
//
// Lower bound: a reaction r with a residual rho in u_n = 0 on U is corrected by normal reactions
// delta on U, F_nn,UU delta = -rho. With s > 0 not above the least eigenvalue of F_nn scaled to a
// unit diagonal and |rho/R| =: q, |delta_i| <= q / (s R_i), and u_n changes elsewhere by at most
// R_j q / sqrt(s). Hence t* is at least the level of r minus the cost of this correction.
//
// An unconstrained body adds equations on both sides; motion_bounds.hpp has the cost of their
// correction.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "solvers/conic/cut.hpp"
#include "solvers/conic/motion_bounds.hpp"
#include "solvers/conic/motions.hpp"
#include "support/index_set.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::conic {

/// Candidates and cones of a node, as in NodeProgram.
struct NodeSets {
  std::span<const int> cones;         ///< C
  std::span<const int> gap_rows;      ///< candidates with u_n >= t
  std::span<const int> contact_rows;  ///< U
  const support::IndexSet& contact;   ///< U
  std::span<const Cut> cuts = {};
};

/// Excess of r_n over x_0 of the standard form per unit of t: 1 / mu, or 1 without friction.
template <class Real = double>
Real level_weight(double friction) {
  return friction == 0 ? Real(1) : Real(1) / Real(friction);
}

/// Bounds for one F.
template <int D, class Real>
class Bounds {
 public:
  using Vector = VectorOf<Real>;
  using Matrix = MatrixOf<Real>;

  /// @param compliance F~, over the cones, D rows each  @param error e
  /// @param owners candidate of each cone, in order  @param motions of an unconstrained body
  /// @param loads number of loads: the last candidates, which have a cone and no row
  Bounds(const Matrix& compliance, double error, const std::vector<int>& owners,
         const Motions<Real>& motions = {}, int loads = 0)
      : loads_(loads),
        equation_(motions.equation),
        error_(error),
        rounding_((static_cast<double>(compliance.rows()) + 4) * numbers::unit_roundoff<Real>),
        owners_(owners) {
    roots_ = (safety * compliance.diagonal().template cast<double>()).cwiseSqrt();
    for (std::size_t k = 0; k < owners.size(); ++k) {
      if (k == 0 || owners[k] != owners[k - 1]) first_cones_.push_back(static_cast<int>(k));
    }
    minimum_ = min_eigenvalue(compliance);
    if (motions.count() == 0) return;
    std::vector<Eigen::Index> rows;
    for (const int cone : first_cones_) rows.push_back(D * static_cast<Eigen::Index>(cone));
    normal_motions_ = motions.at_cones(rows, Eigen::seqN(0, motions.lifting));
    motions_ = RigidModeBounds(motions.at_cones.template cast<double>(), motions.lifting,
                               motions.error, roots_, std::move(rows));
  }

  /// Cost of correcting the equations of the rigid-body modes at a node.
  struct MotionCost {
    double carrying_reaction = 0;  ///< see RigidModeBounds
    double closing_displacement = 0;
  };
  /// Kept until the sets change: a bisection solves the node of one pattern many times.
  [[nodiscard]] MotionCost motion_cost(const NodeSets& sets, std::span<const double> friction) {
    if (!motions_.has_modes()) return {};
    std::vector<std::pair<int, bool>> acting;
    for (const int k : sets.cones)
      acting.emplace_back(k, friction[static_cast<std::size_t>(k)] > 0);
    if (acting != acting_) {
      acting_ = std::move(acting);
      const auto own = static_cast<std::size_t>(
          std::ranges::count_if(sets.cones, [&](int k) { return !is_load(k); }));
      cost_.carrying_reaction =
          motions_.carrying_reaction(sets.cones.first(own), D, friction, sets.cones.subspan(own));
    }
    if (!std::ranges::equal(closed_, sets.contact_rows)) {
      closed_.assign(sets.contact_rows.begin(), sets.contact_rows.end());
      cost_.closing_displacement = motions_.closing_displacement(sets.contact_rows);
    }
    return cost_;
  }

  /// Lower bound from a reaction.
  struct Below {
    double level;     ///< lower bound of t*; minus infinity if nothing is proved
    double residual;  ///< |rho/R| as computed
    double noise;     ///< upper bound of the effect of rounding and the error of F
    double cost;      ///< reduction of the level by both
  };

  /// @param r reaction, over all cones  @param normal its u_n = F~ r, one number per candidate; for
  ///        an unconstrained body with H alpha, and then G'r
  /// @param alpha coefficients of the rigid-body modes  @param correction cost of correcting the
  ///        equations of these modes
  template <class Reaction, class Normal, class Motion = Vector>
  [[nodiscard]] Below below(const NodeSets& sets, std::span<const double> friction,
                            const Reaction& r, const Normal& normal, const Motion& alpha = {},
                            MotionCost correction = {}) const {
    using std::abs;
    // A load that no reaction carries: its point proves nothing.
    if (!(correction.carrying_reaction < infinity)) return {-infinity, infinity, 0, infinity};
    double size = 0;
    Real sum = 0;
    double sizes = 0;
    for (const int k : sets.cones) {
      for (int d = 0; d < D; ++d)
        size += roots_[D * k + d] * std::abs(numbers::rounded(Real(r[D * k + d])));
      sum += r[D * k];
      sizes += std::abs(numbers::rounded(Real(r[D * k])));
    }
    const Unbalanced load = unbalanced(sets, r, normal, alpha, correction);
    const double noise = safety * ((error_ + rounding_) * size + load.displacement);
    double residual = load.residual * load.residual, rho = 0, inverse = 0;
    for (const int i : sets.contact_rows) {
      const double root = normal_root(i);
      const double off = std::abs(numbers::rounded(Real(normal[i]))) / root * safety;
      residual += off * off;
      rho += (off + noise) * (off + noise);
      inverse += 1 / (root * root);
    }
    residual = std::sqrt(residual);
    rho = safety * std::sqrt(rho);
    Below result{-infinity, residual, noise, infinity};
    if (!(minimum_ > 0) && !sets.contact_rows.empty()) return result;
    const double corrected = rho == 0 ? 0 : safety * rho / minimum_;
    const double elsewhere = rho == 0 ? 0 : safety * rho / std::sqrt(minimum_);
    const double unit = 4 * numbers::unit_roundoff<Real>;
    const double sum_error = corrected * std::sqrt(inverse) * safety + rounding_ * sizes +
                             load.reaction * static_cast<double>(sets.cones.size());

    // Normal forces of the correction are not in the side equation, whose entries are at most 1.
    const double equation_error =
        equation_ == SideEquation::none ? 0 : corrected * std::sqrt(inverse) * safety;
    if (equation_ == SideEquation::exact && equation_error > negligible_sum * sizes) return result;

    double level = infinity;
    double raw = infinity;
    const auto take = [&](const Real& value, double cost) {
      const double number = numbers::rounded(value);
      const double proved = number - cost - double_rounding * std::abs(number);
      raw = std::min(raw, number);
      level = std::isnan(proved) ? -infinity : std::min(level, proved);
    };
    const double moved =
        correction.closing_displacement == 0
            ? 0
            : safety * correction.closing_displacement * rho *
                  (1 + std::sqrt(static_cast<double>(sets.contact_rows.size()) / minimum_));
    const auto gap_cost = [&](int j) {
      const double lift = moved == 0 ? 0 : moved * motions_.normal_displacement(j);
      return normal_root(j) * (noise + elsewhere) + lift;
    };
    for (const int j : sets.gap_rows) take(normal[j], gap_cost(j));
    for (const int k : sets.cones) {
      const auto mu = friction[static_cast<std::size_t>(k)];
      const double delta =
          (carries(k, sets) ? corrected / (roots_[D * k] / safety) : 0) + load.reaction;
      if (mu == 0) {
        take(r[D * k], delta + (is_slack(k) ? equation_error : 0));
        continue;
      }
      Real tangential = 0;
      for (int d = 1; d < D; ++d) tangential += r[D * k + d] * r[D * k + d];
      using std::sqrt;
      tangential = sqrt(tangential);
      const Real normal_part = r[D * k] * Real(mu);
      take(normal_part - tangential, mu * delta + load.reaction +
                                         unit * (std::abs(numbers::rounded(normal_part)) +
                                                 std::abs(numbers::rounded(tangential))));
    }
    for (const Cut& cut : sets.cuts) {
      Real own = 0;
      for (const int k : sets.cones)
        if (owners_[static_cast<std::size_t>(k)] == cut.candidate) own += r[D * k];
      const double gap = cut.displacement == 0 ? 0 : gap_cost(cut.candidate);
      const double correction_force =
          corrected / (normal_root(cut.candidate) / safety) + load.reaction;
      const Real left = Real(cut.share) * sum - Real(cut.displacement) * normal[cut.candidate] -
                        Real(cut.reaction) * own;
      take(left / Real(cut.level),
           (std::abs(cut.share) * sum_error + std::abs(cut.displacement) * gap +
            std::abs(cut.reaction) * correction_force + unit * (std::abs(cut.share) * sizes)) /
               cut.level);
    }
    const double min_sum = (numbers::rounded(sum) - sum_error) * (1 - double_rounding);
    const double max_sum = (numbers::rounded(sum) + sum_error) * (1 + double_rounding);
    if (!(min_sum > 0) || !std::isfinite(level)) return result;
    result.level = level > 0 ? level / max_sum * (1 - double_rounding)
                             : level / min_sum * (1 + double_rounding);
    result.cost = raw - level;
    return result;
  }

  /// Upper bound of t* from multipliers.
  /// @param y >= 0 on the gap rows, zero on ignored candidates; for an unconstrained body with beta
  ///        after the m multipliers; then one >= 0 for each cut
  /// @param w = sum_i y_i (row i of F~_n) + G beta and the contribution of the cuts
  template <class Multipliers, class Pull>
  [[nodiscard]] double above(const NodeSets& sets, std::span<const double> friction,
                             const Multipliers& y, const Pull& w) const {
    const Reach reach = examine(sets, friction, y, w);
    if (!(reach.tau < infinity)) return infinity;
    const double tau = reach.tau;
    // N lies between two numbers; t = (1 - sum x_0) / omega is never above 1 / omega.
    double omega = 0;
    double scale = numbers::rounded(reach.pushes);
    double wrong = (double_rounding + rounding_ + reach.balanced) * std::abs(scale);
    for (const int k : sets.cones) {
      const double weight = level_weight(friction[static_cast<std::size_t>(k)]);
      const double rest = numbers::rounded(Real(Real(tau) - w[D * k]));
      omega += weight;
      scale += weight * rest;
      wrong += weight * (reach.noise * roots_[D * k] + reach.cut_noise +
                         8 * double_rounding * std::abs(rest));
    }
    wrong = safety *
            (wrong + double_rounding * static_cast<double>(sets.cones.size()) * std::abs(scale));
    const double trivial = (1 + 8 * double_rounding) / omega;
    if (tau < 0) return tau / (scale + wrong) * (1 - 2 * double_rounding);
    if (!(scale - wrong > 0)) return trivial;
    return std::min(trivial, tau / (scale - wrong) * (1 + 2 * double_rounding));
  }

  /// Upper bound tau of w'r for all r with sum_k r_nk = 1 and t >= 0, from multipliers.
  template <class Multipliers, class Pull>
  [[nodiscard]] double reach(const NodeSets& sets, std::span<const double> friction,
                             const Multipliers& y, const Pull& w) const {
    return examine(sets, friction, y, w).tau;
  }

  /// Rows whose forces an equilibrium correction may change.
  static std::vector<int> force_rows(const NodeSets& sets) {
    std::vector<int> rows(sets.gap_rows.begin(), sets.gap_rows.end());
    rows.insert(rows.end(), sets.contact_rows.begin(), sets.contact_rows.end());
    return rows;
  }

  /// Of these, the largest change: |y_j| on the gap rows, the largest of all for a force that may have
  /// either sign.
  template <class Multipliers>
  [[nodiscard]] std::vector<double> force_sizes(const NodeSets& sets, const Multipliers& y) const {
    std::vector<double> sizes;
    sizes.reserve(sets.gap_rows.size() + sets.contact_rows.size());
    double largest = 0;
    for (const int j : sets.gap_rows) {
      sizes.push_back(std::abs(numbers::rounded(Real(y[j]))));
      largest = std::max(largest, sizes.back());
    }
    for (const int i : sets.contact_rows)
      largest = std::max(largest, std::abs(numbers::rounded(Real(y[i]))));
    sizes.insert(sizes.end(), sets.contact_rows.size(), largest);
    return sizes;
  }

 private:
  struct Reach {
    double tau = infinity;
    double noise = 0;  ///< w_k has an error of at most this times R_k, and w_nk in addition:
    double cut_noise = 0;
    double balanced = 0;  ///< relative change of the forces by the equilibrium correction
    Real pushes = 0;      ///< N without the contribution of the cones
  };
  template <class Multipliers, class Pull>
  [[nodiscard]] Reach examine(const NodeSets& sets, std::span<const double> friction,
                              const Multipliers& y, const Pull& w) const {
    double size = 0;
    for (const int i : sets.contact_rows)
      size += std::abs(numbers::rounded(Real(y[i]))) * normal_root(i);
    Real pushes = 0;
    for (const int j : sets.gap_rows) {
      size += std::abs(numbers::rounded(Real(y[j]))) * normal_root(j);
      pushes += y[j];
    }
    double shares = 0;
    for (std::size_t i = 0; i < sets.cuts.size(); ++i) {
      const Cut& cut = sets.cuts[i];
      const Real force = y[first_cut() + static_cast<Eigen::Index>(i)];
      const double much = std::abs(numbers::rounded(force));
      size += much * std::abs(cut.displacement) * normal_root(cut.candidate);
      shares += much * (std::abs(cut.share) + std::abs(cut.reaction));
      pushes += force * Real(cut.level);
    }
    const double balanced = motions_.has_modes() ? balance(sets, y) : 0;
    if (!(balanced <= max_balance)) return {};
    const double cut_noise = safety * rounding_ * shares;
    // A force changed by the equilibrium correction moves the candidates by at most this over R.
    const double noise =
        safety * ((error_ + rounding_) * size + balanced * balance_size(sets, y) +
                  (motions_.has_modes() ? motion_noise(y) / motions_.min_root() : 0));
    const double unit = 4 * numbers::unit_roundoff<Real>;
    double tau = -infinity;
    for (const int k : sets.cones) {
      const auto mu = friction[static_cast<std::size_t>(k)];
      Real tangential = 0;
      double roots = 0;
      for (int d = 1; d < D; ++d) {
        tangential += w[D * k + d] * w[D * k + d];
        roots += roots_[D * k + d] * roots_[D * k + d];
      }
      using std::sqrt;
      tangential = sqrt(tangential) * Real(mu);
      const double reach = numbers::rounded(Real(w[D * k] + tangential));
      const double wrong = noise * (roots_[D * k] + mu * std::sqrt(roots) * safety) +
                           unit * (std::abs(numbers::rounded(Real(w[D * k]))) +
                                   std::abs(numbers::rounded(tangential))) +
                           double_rounding * std::abs(reach) + cut_noise;
      const double most = reach + wrong * safety;
      tau = std::isnan(most) ? infinity : std::max(tau, most);
    }
    return {tau, noise, cut_noise, balanced, pushes};
  }

  /// Cost of the equilibrium correction of a reaction.
  struct Unbalanced {
    double residual = 0;      ///< |G'r| as computed
    double reaction = 0;      ///< largest change of a component of r
    double displacement = 0;  ///< largest change of u_i / R_i, including the rounding of H alpha
  };
  template <class Reaction, class Normal, class Motion>
  [[nodiscard]] Unbalanced unbalanced(const NodeSets& sets, const Reaction& r, const Normal& normal,
                                      const Motion& alpha, MotionCost cost) const {
    if (!motions_.has_modes()) return {};
    double sizes = 0;
    for (const int k : sets.cones)
      for (int d = 0; d < D; ++d) sizes += std::abs(numbers::rounded(Real(r[D * k + d])));
    double squares = 0;
    double maximum = 0;
    const auto m = static_cast<Eigen::Index>(first_cones_.size());
    for (Eigen::Index l = 0; l < motions_.count(); ++l) {
      const double off = std::abs(numbers::rounded(Real(normal[m + l])));
      maximum += off * off;
      squares += std::pow(off + sizes * motions_.noise(rounding_), 2);
    }
    const double change = safety * cost.carrying_reaction * std::sqrt(squares);
    double motion = 0;
    for (Eigen::Index l = 0; l < alpha.size(); ++l)
      motion += std::abs(numbers::rounded(Real(alpha[l])));
    return {safety * cost.carrying_reaction * std::sqrt(maximum), change / motions_.min_root(),
            change * std::sqrt(static_cast<double>(D * sets.cones.size())) +
                motion * motions_.noise(rounding_) / motions_.min_root()};
  }

  /// Relative change of the normal forces by the equilibrium correction, including the contribution
  /// of the cuts; more than 1 if equilibrium is impossible.
  template <class Multipliers>
  [[nodiscard]] double balance(const NodeSets& sets, const Multipliers& y) const {
    const std::vector<int> rows = force_rows(sets);
    Vector load = Vector::Zero(normal_motions_.cols());
    bool all = true;
    double total = 0;
    std::vector<Real> of_cuts(sets.cuts.empty() ? 0 : first_cones_.size(), Real(0));
    for (std::size_t k = 0; k < sets.cuts.size(); ++k) {
      const Real force =
          y[first_cut() + static_cast<Eigen::Index>(k)] * Real(sets.cuts[k].displacement);
      of_cuts[static_cast<std::size_t>(sets.cuts[k].candidate)] += force;
      total += std::abs(numbers::rounded(force));
    }
    for (const int i : rows) {
      total += std::abs(numbers::rounded(Real(y[i])));
      const Real own =
          of_cuts.empty() ? Real(y[i]) : Real(y[i] - of_cuts[static_cast<std::size_t>(i)]);
      load += own * normal_motions_.row(i).transpose();
    }
    for (const int j : sets.gap_rows) all = all && y[j] != Real(0);
    return motions_.balance(rows, force_sizes(sets, y), load.template cast<double>(),
                            total * motions_.noise(2 * rounding_), all);
  }

  /// sum_j R_j |y_j| with the magnitudes of `balance`.
  template <class Multipliers>
  [[nodiscard]] double balance_size(const NodeSets& sets, const Multipliers& y) const {
    if (!motions_.has_modes()) return 0;
    const auto sizes = force_sizes(sets, y);
    double sum = 0;
    std::size_t place = 0;
    for (const auto rows : {sets.gap_rows, sets.contact_rows})
      for (const int i : rows) sum += sizes[place++] * normal_root(i);
    return sum;
  }

  template <class Multipliers>
  [[nodiscard]] double motion_noise(const Multipliers& y) const {
    double sum = 0;
    const auto m = static_cast<Eigen::Index>(first_cones_.size());
    for (Eigen::Index l = 0; l < motions_.count(); ++l)
      sum += std::abs(numbers::rounded(Real(y[m + l])));
    return sum * motions_.noise(rounding_);
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  /// Factor for the rounding of sums of a few hundred non-negative doubles.
  static constexpr double safety = 1.001;
  static constexpr double double_rounding = 0x1p-51;
  /// Limit of the relative equilibrium correction of valid multipliers: other conclusions, for
  /// other coefficients of friction, take them as exact.
  static constexpr double max_balance = 1e-6;
  /// Relative error of an exact side equation, in states that count as feasible.
  static constexpr double negligible_sum = 1e-10;

  /// Index of the first cut's multiplier.
  [[nodiscard]] Eigen::Index first_cut() const {
    return static_cast<Eigen::Index>(first_cones_.size()) + motions_.count();
  }

  [[nodiscard]] bool is_load(int cone) const {
    return owners_[static_cast<std::size_t>(cone)] >=
           static_cast<int>(first_cones_.size()) - loads_;
  }

  /// True for the last load if it is the slack of the side equation; its entry there is 1.
  [[nodiscard]] bool is_slack(int cone) const {
    return equation_ == SideEquation::with_slack &&
           static_cast<std::size_t>(cone) + 1 == owners_.size();
  }

  [[nodiscard]] double normal_root(int candidate) const {
    return roots_[D * first_cones_[static_cast<std::size_t>(candidate)]];
  }

  /// True if a cone takes part in the correction: the first one of a candidate of U.
  [[nodiscard]] bool carries(int cone, const NodeSets& sets) const {
    const auto owner = static_cast<std::size_t>(owners_[static_cast<std::size_t>(cone)]);
    return sets.contact.contains(static_cast<int>(owner)) && first_cones_[owner] == cone;
  }

  /// Lower bound of the least eigenvalue of F_nn scaled to a unit diagonal. If the Cholesky
  /// factorisation of F - s I succeeds, F - s I + E is positive semidefinite with |E| <= (m + 4) u
  /// trace F. Zero if no bound is found.
  [[nodiscard]] double min_eigenvalue(const Matrix& compliance) const {
    const auto m = static_cast<Eigen::Index>(first_cones_.size()) - loads_;
    Matrix scaled(m, m);
    using std::sqrt;
    for (Eigen::Index i = 0; i < m; ++i) {
      for (Eigen::Index j = 0; j < m; ++j) {
        const auto row = D * first_cones_[static_cast<std::size_t>(i)];
        const auto column = D * first_cones_[static_cast<std::size_t>(j)];
        scaled(i, j) = compliance(row, column) /
                       (sqrt(compliance(row, row)) * sqrt(compliance(column, column)));
      }
    }
    const auto size = static_cast<double>(m);
    // Sum of the errors of F, the scaling, the shift and the factorisation.
    const double wrong = 2 * size * (error_ + (size + 12) * numbers::unit_roundoff<Real>);
    const Eigen::MatrixXd rounded = scaled.template cast<double>();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(rounded, Eigen::EigenvaluesOnly);
    // The shift starts at the rounding level of doubles if the computed eigenvalue is below it.
    double shift = std::max(0.5 * eigen.eigenvalues()[0], 1e-13);
    for (; shift > 2 * wrong; shift /= 8) {
      Matrix shifted = scaled;
      for (Eigen::Index i = 0; i < m; ++i) shifted(i, i) -= Real(shift);
      if (Eigen::LLT<Matrix>(shifted).info() == Eigen::Success) return shift - wrong;
    }
    return 0;
  }

  int loads_ = 0;
  SideEquation equation_ = SideEquation::none;
  double error_, rounding_;
  RigidModeBounds motions_;
  Matrix normal_motions_;         // H, m rows
  Eigen::VectorXd roots_;         // R of all rows of F, rounded up
  std::vector<int> owners_;       // of each cone
  std::vector<int> first_cones_;  // of each candidate
  double minimum_ = 0;            // lower bound s of the least eigenvalue
  MotionCost cost_;               // of the cones of C, each with or without friction, and of U:
  std::vector<std::pair<int, bool>> acting_;
  std::vector<int> closed_;
};

}  // namespace kusabi::conic
