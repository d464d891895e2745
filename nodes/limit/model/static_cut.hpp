// Static cuts: valid inequalities of (29) derived from equilibrium.
//
// For column j of T, t_j = weight_j d_j, let y be member forces and k a factor with B y - k f_R =
// d_j. Then |d_j'u| = |y'B'u - k f_R'u| <= |y|'z + |k| for every (u, z) of (14), and so
//   gamma_j <= |y|'z + |k|,   where gamma_j stands for |d_j'u|.
// The best cut at z is a linear program: min sum_i z_i |y_i| + |k|. Its dual is max { d_j'v : |B'v|
// <= z, |f_R'v| <= 1 }: with all cuts, each gamma_j may still belong to a motion of its own within
// the elongations z.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/checked_simplex.hpp"

namespace kusabi::limit {

struct StaticCut {
  int column = 0;                              ///< j of T
  double factor = 0;                           ///< k
  std::vector<std::pair<int, double>> forces;  ///< the nonzero y_i, by member

  /// |y|'z + |k|, the bound of |d_j'u|.
  [[nodiscard]] double bound(const Eigen::VectorXd& z) const;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& column& factor& forces;
  }
};

/// Pricing programs with warm starts.
class StaticPricing {
 public:
  /// @param stop ends a long solve, which then has no cut
  explicit StaticPricing(const problems::LimitModel& model, support::Stop stop = {});

  /// Sets the point for the next cuts.
  /// @param z n^m, >= 0
  /// @param first a column of T; its program is solved, and restart() goes back to its basis
  void set_point(const Eigen::VectorXd& z, int first);

  /// Makes the results of cut() depend on z and on later calls only.
  void restart();

  /// The best cut for a column of T; nothing if no answer passes its check.
  std::optional<StaticCut> cut(int column);

  /// True if the run is to stop.
  [[nodiscard]] bool stopped() const { return support::is_requested(stop_); }
  [[nodiscard]] std::uint64_t solves() const { return simplex_.solves(); }
  [[nodiscard]] std::uint64_t iterations() const { return simplex_.iterations(); }

 private:
  void aim_at(int column);
  [[nodiscard]] const std::vector<problems::UncertainColumn::Component>& direction(int j) const {
    return model_.uncertain[static_cast<std::size_t>(j)].direction;
  }

  const problems::LimitModel& model_;
  support::Stop stop_;
  linear::CheckedSimplex simplex_;
  std::optional<linear::Basis> start_;
  int last_column_ = -1;
};

}  // namespace kusabi::limit
