// What can be asked of a truss: its load factor, and how low uncertain loads can bring it.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>

#include <Eigen/Core>

namespace kusabi::limit {

/// How the worst case is found. With an M that is given, `fixed` and `disjunctive` are the paper's
/// method as printed, which takes nothing from static cuts.
enum class LimitMethod {
  fixed,        ///< the 0-1 program (29) by Algorithm 4.2, as it is
  disjunctive,  ///< with the cuts of Algorithm 5.1: the paper's method
  tightened,    ///< with M made as small as can be by optimisation
  static_cuts,  ///< static cuts and the tree of signs: neither (29) nor M
  all,          ///< (29) with static cuts as rows, tightened M, and disjunctive cuts
};

/// From so many uncertain loads on splitting is faster than a linear program for each cut
/// (bench/README.md).
inline constexpr int usual_split_from = 150;

struct LimitQuestion {
  /// Half-width of the uncertain loads, relative to those of the columns of T
  /// (`problems::settle_half_widths`); nothing: nominal only.
  std::optional<double> alpha{};
  LimitMethod method = LimitMethod::static_cuts;
  std::optional<double> big_m{};  ///< M of (29), in the paper's units; nothing: derived
  /// The evidence of both ends is wanted: of the method as printed they are proved, too, once its
  /// tree is done. All other methods prove them anyway.
  bool evidence = false;
  /// From so many uncertain loads on static cuts come from operator splitting.
  int split_from = usual_split_from;
  /// Random dead loads to compare with; `fixed` and `disjunctive` start from the best of them.
  std::uint64_t samples = 0;
  std::uint64_t seed = 1;  ///< of those
  bool curve = false;      ///< how the factor falls as the uncertainty grows
  /// How it falls as this load grows, n^d, force; nothing: not asked.
  std::optional<Eigen::VectorXd> curve_load{};
  double curve_to = 1;  ///< curves are over beta from 0 to this, times alpha or times the load

  /// The 0-1 program with the paper's means alone.
  [[nodiscard]] bool of_the_paper() const {
    return method == LimitMethod::fixed || method == LimitMethod::disjunctive;
  }
  [[nodiscard]] bool as_printed() const { return of_the_paper() && big_m.has_value(); }
};

/// (29) has no point: the M that was asked for is too small.
class BigMTooSmall : public std::invalid_argument {
 public:
  BigMTooSmall()
      : std::invalid_argument("(29) has no point, its M is too small; expected a larger one") {}
};

}  // namespace kusabi::limit
