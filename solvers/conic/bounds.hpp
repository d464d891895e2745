// Bounds of t* that hold in spite of rounding and of what is not known of F.
//
// The iterations hand over points that satisfy their equations up to a residual, computed from an F
// that is right up to an error e: |F~_ij - F_ij| <= e sqrt(F_ii F_jj). Here is what such a point
// proves of the program with the true F (docs/theory/wedged.md, "Two proofs"). With n terms in a
// sum and the unit roundoff u of its numbers let eps = e + (n + 4) u and R_i = sqrt(F_ii).
//
// From above: for multipliers y with y_j >= 0 off U, w = sum_i y_i (row (n, i) of F) and any
// tau >= w_nk + mu_k |w_tk| on C,
//
//   t* <= tau / N,   N = sum_{j not in U} y_j + sum_C (tau - w_nk) / mu_k  >= 0,
//
// so the sign is that of tau, whatever the scale of y. w_k is wrong by eps R_k sum_i |y_i| R_i.
//
// From below: a reaction r with a residual rho in u_n = 0 on U is mended by normal reactions delta
// on U, F_nn,UU delta = -rho. With s > 0 not above the least eigenvalue of F_nn scaled to a unit
// diagonal and |rho/R| =: q, |delta_i| <= q / (s R_i), and u_n changes elsewhere by no more than
// R_j q / sqrt(s). So t* is not below the level of r less what this costs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "support/numbers/precise.hpp"

namespace kusabi::conic {

/// The candidates and cones of a node, as NodeProgram has them.
struct NodeSets {
  std::span<const int> cones;         ///< C
  std::span<const int> gap_rows;      ///< candidates whose u_n must not be below t
  std::span<const int> contact_rows;  ///< U
  std::uint64_t contact = 0;          ///< U as a bit set
};

/// By how much r_n exceeds x_0 of the standard form for each unit of t: 1 / mu, or 1 without
/// friction.
inline double level_weight(double friction) {
  return friction == 0 ? 1 : 1 / friction;
}

/// Bounds for one F.
template <int D, class Real>
class Bounds {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

  /// @param compliance F~, over the cones, D rows each  @param error e
  /// @param owners the candidate of each cone, in order
  Bounds(const Matrix& compliance, double error, const std::vector<int>& owners)
      : error_(error),
        rounding_((static_cast<double>(compliance.rows()) + 4) * numbers::unit_roundoff<Real>),
        owners_(owners) {
    roots_ = (safety * compliance.diagonal().template cast<double>()).cwiseSqrt();
    for (std::size_t k = 0; k < owners.size(); ++k) {
      if (k == 0 || owners[k] != owners[k - 1]) first_cones_.push_back(static_cast<int>(k));
    }
    least_ = least_eigenvalue(compliance);
  }

  /// What a reaction proves.
  struct Below {
    double level;     ///< t* is not below this; minus infinity if nothing is proved
    double residual;  ///< |rho/R| as it was computed
    double noise;     ///< what rounding and the error of F may add to it
    double cost;      ///< by how much the level suffers from both
  };

  /// @param r reaction, over all cones  @param normal its u_n = F~ r, one number a candidate
  template <class Reaction, class Normal>
  [[nodiscard]] Below below(const NodeSets& sets, std::span<const double> friction,
                            const Reaction& r, const Normal& normal) const {
    using std::abs;
    double size = 0;
    Real sum = 0;
    double sizes = 0;
    for (const int k : sets.cones) {
      for (int d = 0; d < D; ++d)
        size += roots_[D * k + d] * std::abs(numbers::rounded(Real(r[D * k + d])));
      sum += r[D * k];
      sizes += std::abs(numbers::rounded(Real(r[D * k])));
    }
    const double noise = safety * (error_ + rounding_) * size;
    double residual = 0, rho = 0, inverse = 0;
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
    if (!(least_ > 0) && !sets.contact_rows.empty()) return result;
    const double mended = rho == 0 ? 0 : safety * rho / least_;
    const double elsewhere = rho == 0 ? 0 : safety * rho / std::sqrt(least_);
    const double unit = 4 * numbers::unit_roundoff<Real>;

    double level = infinity;
    double raw = infinity;
    const auto take = [&](const Real& value, double cost) {
      const double number = numbers::rounded(value);
      raw = std::min(raw, number);
      level = std::min(level, number - cost - double_rounding * std::abs(number));
    };
    for (const int j : sets.gap_rows) take(normal[j], normal_root(j) * (noise + elsewhere));
    for (const int k : sets.cones) {
      const auto mu = friction[static_cast<std::size_t>(k)];
      const double delta = carries(k, sets) ? mended / (roots_[D * k] / safety) : 0;
      if (mu == 0) {
        take(r[D * k], delta);
        continue;
      }
      Real tangential = 0;
      for (int d = 1; d < D; ++d) tangential += r[D * k + d] * r[D * k + d];
      using std::sqrt;
      tangential = sqrt(tangential);
      const Real normal_part = r[D * k] * Real(mu);
      take(normal_part - tangential, mu * delta + unit * (std::abs(numbers::rounded(normal_part)) +
                                                          std::abs(numbers::rounded(tangential))));
    }
    const double loose = mended * std::sqrt(inverse) * safety + rounding_ * sizes;
    const double least_sum = (numbers::rounded(sum) - loose) * (1 - double_rounding);
    const double most_sum = (numbers::rounded(sum) + loose) * (1 + double_rounding);
    if (!(least_sum > 0) || !std::isfinite(level)) return result;
    result.level = level > 0 ? level / most_sum * (1 - double_rounding)
                             : level / least_sum * (1 + double_rounding);
    result.cost = raw - level;
    return result;
  }

  /// What multipliers prove: t* is not above this.
  /// @param y >= 0 on the gap rows, zero on ignored candidates  @param w = sum_i y_i (row i of
  /// F~_n)
  template <class Multipliers, class Pull>
  [[nodiscard]] double above(const NodeSets& sets, std::span<const double> friction,
                             const Multipliers& y, const Pull& w) const {
    double size = 0;
    for (const int i : sets.contact_rows)
      size += std::abs(numbers::rounded(Real(y[i]))) * normal_root(i);
    Real pushes = 0;
    for (const int j : sets.gap_rows) {
      size += std::abs(numbers::rounded(Real(y[j]))) * normal_root(j);
      pushes += y[j];
    }
    const double noise = safety * (error_ + rounding_) * size;
    const double unit = 4 * numbers::unit_roundoff<Real>;
    double tau = -infinity;
    double omega = 0;
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
                           double_rounding * std::abs(reach);
      tau = std::max(tau, reach + wrong * safety);
      omega += level_weight(mu);
    }
    // N between two numbers; t = (1 - sum x_0) / omega is never above 1 / omega.
    double scale = numbers::rounded(pushes);
    double wrong = double_rounding * std::abs(scale) + rounding_ * std::abs(scale);
    for (const int k : sets.cones) {
      const double weight = level_weight(friction[static_cast<std::size_t>(k)]);
      const double rest = numbers::rounded(Real(Real(tau) - w[D * k]));
      scale += weight * rest;
      wrong += weight * (noise * roots_[D * k] + 8 * double_rounding * std::abs(rest));
    }
    wrong = safety *
            (wrong + double_rounding * static_cast<double>(sets.cones.size()) * std::abs(scale));
    const double trivial = (1 + 8 * double_rounding) / omega;
    if (tau < 0) return tau / (scale + wrong) * (1 - 2 * double_rounding);
    if (!(scale - wrong > 0)) return trivial;
    return std::min(trivial, tau / (scale - wrong) * (1 + 2 * double_rounding));
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  /// Covers the roundings of sums of a few hundred doubles that are all >= 0.
  static constexpr double safety = 1.001;
  static constexpr double double_rounding = 0x1p-51;

  [[nodiscard]] double normal_root(int candidate) const {
    return roots_[D * first_cones_[static_cast<std::size_t>(candidate)]];
  }

  /// Whether a cone takes part of the mending: the first one of a candidate of U.
  [[nodiscard]] bool carries(int cone, const NodeSets& sets) const {
    const auto owner = static_cast<std::size_t>(owners_[static_cast<std::size_t>(cone)]);
    return (sets.contact >> owner & 1) != 0 && first_cones_[owner] == cone;
  }

  /// A number that the least eigenvalue of F_nn, scaled to a unit diagonal, is not below: where
  /// Cholesky's method goes through for F - s I, F - s I + E is positive semidefinite with
  /// |E| <= (m + 4) u trace F. Zero if there is none.
  [[nodiscard]] double least_eigenvalue(const Matrix& compliance) const {
    const auto m = static_cast<Eigen::Index>(first_cones_.size());
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
    // The error of F, the scaling, the shift and the factorisation.
    const double wrong = 2 * size * (error_ + (size + 12) * numbers::unit_roundoff<Real>);
    const Eigen::MatrixXd rounded = scaled.template cast<double>();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(rounded, Eigen::EigenvaluesOnly);
    // What doubles cannot tell from zero is tried from there downwards.
    double shift = std::max(0.5 * eigen.eigenvalues()[0], 1e-13);
    for (; shift > 2 * wrong; shift /= 8) {
      Matrix shifted = scaled;
      for (Eigen::Index i = 0; i < m; ++i) shifted(i, i) -= Real(shift);
      if (Eigen::LLT<Matrix>(shifted).info() == Eigen::Success) return shift - wrong;
    }
    return 0;
  }

  double error_, rounding_;
  Eigen::VectorXd roots_;         // R of all rows of F, rounded up
  std::vector<int> owners_;       // of each cone
  std::vector<int> first_cones_;  // of each candidate
  double least_ = 0;              // s
};

}  // namespace kusabi::conic
