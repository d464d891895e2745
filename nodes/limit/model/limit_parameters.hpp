// Options of a limit analysis: nominal load factor and worst case of uncertain loads.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include <Eigen/Core>

namespace kusabi::limit {

/// Method for the worst case. With a given M, `fixed` and `disjunctive` are the paper's method as
/// printed, without static cuts.
enum class LimitMethod {
  fixed,        ///< the 0-1 program (29) by Algorithm 4.2
  disjunctive,  ///< with the cuts of Algorithm 5.1: the paper's method
  tightened,    ///< with M minimised by optimisation-based bound tightening
  static_cuts,  ///< static cuts and the tree of signs, without (29) and M
  all,          ///< (29) with static cuts as rows, tightened M, and disjunctive cuts
};

/// Use of the corners of the uncertain loads, one by one, in place of static cuts.
enum class Corners {
  never,
  if_less_work,  ///< as predicted (nodes/limit/root/corner_choice.hpp)
  always,        ///< however many there are
};

/// Minimum number of uncertain loads for operator splitting, which is then faster than a linear
/// program for each cut (bench/history.md).
inline constexpr int default_split_from = 150;

/// The least load factor over all losses of up to `maximum` members.
struct LossParameters {
  int maximum = 1;                   ///< K
  std::optional<double> at_least{};  ///< required factor; nothing: the least one
  std::vector<int> kept{};           ///< members that are not lost
  double sudden = 1;                 ///< dynamic factor of the loads after the loss, >= 1
};

struct LimitParameters {
  /// Half-width of the uncertain loads, relative to those of the columns of T
  /// (`problems::set_half_widths`); nothing: nominal only.
  std::optional<double> alpha{};
  LimitMethod method = LimitMethod::static_cuts;
  std::optional<double> big_m{};  ///< M of (29), in the paper's units; nothing: derived
  /// True if evidence for both bounds is required: the method as printed then also proves them,
  /// after its tree. All other methods always prove them.
  bool evidence = false;
  /// Minimum number of uncertain loads for static cuts by operator splitting.
  int split_from = default_split_from;
  Corners corners = Corners::if_less_work;  ///< with `static_cuts`
  /// Number of random dead loads for comparison; `fixed` and `disjunctive` start from the best of
  /// them.
  std::uint64_t samples = 0;
  std::uint64_t seed = 1;  ///< random seed of these
  bool curve = false;      ///< true if the curve of the factor over the uncertainty is computed
  /// Load of a further curve, n^d, force; nothing: none.
  std::optional<Eigen::VectorXd> curve_load{};
  /// Loss of members, for the nominal load or, with alpha, all admissible loads; nothing: none.
  std::optional<LossParameters> loss{};
  double curve_to = 1;  ///< upper limit of beta of the curves, times alpha or times the load

  /// True if the method is the 0-1 program with the paper's means only.
  [[nodiscard]] bool of_the_paper() const {
    return method == LimitMethod::fixed || method == LimitMethod::disjunctive;
  }
  [[nodiscard]] bool as_printed() const { return of_the_paper() && big_m.has_value(); }
};

/// The given M is too small, since (29) has no solution.
class BigMTooSmall : public std::invalid_argument {
 public:
  BigMTooSmall()
      : std::invalid_argument("(29) has no point, its M is too small; expected a larger one") {}
};

}  // namespace kusabi::limit
