// Relative interior of the solutions of a degenerate node, from the decrease of reactions and gaps
// with the width of the bracket (docs/theory/wedged.md, "Relative interior at a degenerate node").
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "solvers/conic/node_solver.hpp"

namespace kusabi::conic {

using support::IndexSet;

// sum_k R_k |r_k| over all components, R = sqrt(F_kk). Times R_j it is the magnitude of u_nj
// without cancellation, and large compared with the rounding of directions and positions in the
// file, carried into F. (F_jk itself is not a measure: for a candidate held by a single bar it
// consists of that rounding.)
template <int D, class Real>
double NodeSolver<D, Real>::reaction_size() const {
  double sum = 0;
  for (Eigen::Index i = 0; i < reaction_.size(); ++i)
    sum += own_root(i) * std::abs(numbers::rounded(reaction_[i]));
  return sum;
}

// r_n and u_n of all candidates relative to that magnitude, in two groups of m numbers. Zero for
// values that the node fixes at zero.
template <int D, class Real>
std::vector<double> NodeSolver<D, Real>::sizes() {
  const auto m = static_cast<std::size_t>(program_.candidates());
  std::vector<double> sizes(2 * m, 0.0);
  const double whole = reaction_size();
  const Vector& normal = program_.normal_displacements(reaction_, motion_);
  for (const int k : program_.cones())
    sizes[static_cast<std::size_t>(k)] =
        std::max(0.0, numbers::rounded(reaction_[D * k]) * own_root(D * k) / whole);
  for (const int j : program_.gap_rows())
    sizes[m + static_cast<std::size_t>(j)] =
        std::max(0.0, numbers::rounded(normal[j]) / (own_root(D * j) * whole));
  return sizes;
}

// Violation of the wedging conditions by the reaction, relative to the magnitudes compared.
template <int D, class Real>
double NodeSolver<D, Real>::violation() {
  double maximum = 0;
  const double whole = reaction_size();
  const Vector& normal = program_.normal_displacements(reaction_, motion_);
  for (const int j : program_.gap_rows())
    maximum = std::max(maximum, -numbers::rounded(normal[j]) / (own_root(D * j) * whole));
  for (const int k : program_.cones()) {
    const double mu = program_.friction()[static_cast<std::size_t>(k)];
    const Real tangential = reaction_.template segment<D - 1>(D * k + 1).norm();
    const double outside = numbers::rounded(Real(tangential - Real(mu) * reaction_[D * k]));
    maximum = std::max(maximum, outside * own_root(D * k) / (whole * std::max(mu, 1.0)));
  }
  return maximum;
}

namespace {

/// A range of widths of the bracket, in which sizes are compared at its beginning and at its end.
struct Window {
  double widest, opens, closes, minimum;
};

/// The window above the rounding of the file: a normal with sixteen digits that should be parallel
/// to a bar gives a degenerate node at t* = 1e-17 only, and below that the points tend to a vertex
/// of X.
constexpr Window shallow{1e-5, 1e-7, 1e-12, 3e-15};
/// The window for small values that do not vanish, if t* is exactly zero.
constexpr Window deep{1e-9, 1e-11, 1e-19, 0};

/// A size that decreases by less than `stays` does not vanish. A size that vanishes decreases at
/// least with the root of the ratio of the widths, within a factor `miss`.
constexpr double stays = 0.1, miss = 3;

/// Rounding level of the file.
constexpr double file_rounding = 1e-13;

IndexSet set_of(const std::vector<int>& candidates) {
  IndexSet set;
  for (const int i : candidates) set.insert(i);
  return set;
}

/// The points at the beginning and at the end of the window; null if the path has none.
template <class Point>
std::pair<const Point*, const Point*> ends_of(const Window& window,
                                              const std::vector<Point>& path) {
  const Point* open = nullptr;
  const Point* closed = nullptr;
  for (const Point& point : path) {
    if (point.width <= window.widest && (open == nullptr || point.width >= window.opens))
      open = &point;
    if (point.width >= window.minimum) closed = &point;
    if (point.width <= window.closes && closed == &point) break;
  }
  return {open, closed};
}

/// The candidates whose sizes do not vanish between the two points; nothing if one is undecided.
/// @param carriers candidates with a reaction  @param movers candidates with a gap
template <class Point>
std::optional<RelativeInterior> remaining(const Point& open, const Point& closed,
                                          const IndexSet& carriers, const IndexSet& movers) {
  const double falls = miss * std::sqrt(closed.width / open.width);
  if (!(falls < stays / 2)) return std::nullopt;
  RelativeInterior result;
  const std::size_t m = open.sizes.size() / 2;
  for (std::size_t i = 0; i < 2 * m; ++i) {
    const auto candidate = static_cast<int>(i % m);
    if (!(i < m ? carriers : movers).contains(candidate)) continue;
    // A value fixed at zero by an equation does not decrease: it is rounding from the start.
    if (closed.sizes[i] <= std::max(falls * open.sizes[i], file_rounding)) continue;
    if (closed.sizes[i] < stays * open.sizes[i]) return std::nullopt;
    (i < m ? result.loaded : result.moved).insert(candidate);
  }
  return result;
}

}  // namespace

template <int D, class Real>
std::optional<RelativeInterior> NodeSolver<D, Real>::relative_interior(const IndexSet& contact,
                                                                       const IndexSet& separated,
                                                                       const IndexSet& ignored) {
  ConicResult answer = nothing_known();
  std::vector<Snapshot> path;
  const auto ends = [&](ExaminedBound side) {
    if (side == ExaminedBound::upper) return false;
    // Bracket of the iteration itself, without the rounding errors of the bounds.
    const Real width = iteration_.complementarity() * program_.level(Real(0));
    path.push_back({numbers::rounded(width), sizes(), reaction_, motion_});
    return path.back().width <= deep.closes;
  };
  do {
    if (!begin(contact, separated, ignored, {})) return std::nullopt;
    path.clear();
    iterate(answer, Keep::latest, ends);
  } while (lift_off());
  program_.displacement(reaction_, motion_, displacement_);
  if (!is_within_tolerance(answer, tolerances_)) return std::nullopt;
  // Infeasible by more than the rounding of the file: X is empty.
  if (answer.upper < 0 && violation() > 10 * file_rounding) return RelativeInterior{};
  const IndexSet carriers = set_of(program_.cones());
  const IndexSet movers = set_of(program_.gap_rows());
  const auto m = static_cast<std::size_t>(program_.candidates());
  if (answer.lower > 0) {  // feasible, though within the tolerance: nothing vanishes
    const auto& last = path.back().sizes;
    bool all = true;
    for (const int i : program_.cones())
      all = all && last[static_cast<std::size_t>(i)] > file_rounding;
    for (const int i : program_.gap_rows())
      all = all && last[m + static_cast<std::size_t>(i)] > file_rounding;
    if (all) return RelativeInterior{carriers, movers};
  }
  for (const Window& window : {shallow, deep}) {
    if (window.minimum == 0 && (answer.lower > 0 || answer.upper < 0)) continue;
    const auto [open, closed] = ends_of(window, path);
    if (open == nullptr || closed == nullptr) continue;
    const auto result = remaining(*open, *closed, carriers, movers);
    if (!result) continue;
    reaction_ = closed->reaction;
    motion_ = closed->motion;
    program_.displacement(reaction_, motion_, displacement_);
    return result;
  }
  return std::nullopt;
}

template std::optional<RelativeInterior> NodeSolver<2, numbers::Precise>::relative_interior(
    const IndexSet&, const IndexSet&, const IndexSet&);
template std::optional<RelativeInterior> NodeSolver<3, numbers::Precise>::relative_interior(
    const IndexSet&, const IndexSet&, const IndexSet&);

}  // namespace kusabi::conic
