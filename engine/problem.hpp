// Concepts of a problem type. (A function of one of these names with another signature is an error:
// engine/detail/problem_check.hpp.)
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "engine/expansion.hpp"

namespace kusabi::engine {

/// A tree to search: its root, and the expansion of a node.
///
/// `Node` and `Solution` are default constructible, copyable, assignable and Boost-serialisable. A
/// node describes a subproblem only: large or expensive data (a factorisation, a solver's
/// workspace) belong in the problem object, of which every rank has its own. The effect of `expand`
/// must depend on the node alone.
template <class P>
concept Problem = requires(P& problem, const P& constant, typename P::Node node,
                           Expansion<P>& out) {
  typename P::Solution;
  { constant.root() } -> std::same_as<typename P::Node>;
  problem.expand(std::move(node), out);
};

/// A problem with an objective, required by Goal::best. It is minimised unless the problem has
/// `static constexpr bool maximises = true`.
template <class P>
concept Optimising = Problem<P> &&
    requires(const P& problem, const typename P::Solution& solution) {
  { problem.objective(solution) } -> std::convertible_to<double>;
};

/// A problem with a bound of the objectives of all solutions below a node, a lower one if it
/// minimises and an upper one if it maximises, computed without opening the node. Nodes whose bound
/// is worse than the incumbent's objective are pruned.
template <class P>
concept Bounded = Optimising<P> && requires(const P& problem, const typename P::Node& node) {
  { problem.bound(node) } -> std::convertible_to<double>;
};

/// A problem that may take its solutions itself with Goal::all, on the rank that found them and
/// with the path of their node. `emit` returns true if it has taken the solution: the engine counts
/// but does not keep it. Otherwise the solution must be unchanged, and the engine keeps it.
template <class P>
concept Emitting = Problem<P> &&
    requires(P& problem, const Path& path, typename P::Solution& solution) {
  { problem.emit(path, solution) } -> std::same_as<bool>;
};

/// A problem with counts of its own. The `tally()` of each rank (a Boost-serialisable value of type
/// `Tally`) is part of the outcome, in the order of the ranks.
template <class P>
concept Tallying = Problem<P> && requires(const P& problem) {
  { problem.tally() } -> std::convertible_to<typename P::Tally>;
};

/// Tally of a problem without counts.
struct NoTally {
  template <class Archive>
  void serialize(Archive& /*archive*/, unsigned /*version*/) {}
};

/// A problem with an estimate of the work below a node's first child, relative to that below each
/// other child. Used only for the progress estimate.
template <class P>
concept Uneven = Problem<P> && requires {
  { P::work_of_first_child } -> std::convertible_to<double>;
  typename std::enable_if_t<(P::work_of_first_child > 0)>;
};

namespace detail {
template <class P>
struct TallyOf {
  using type = NoTally;
};
template <Tallying P>
struct TallyOf<P> {
  using type = typename P::Tally;
};
}  // namespace detail

/// Tally type of a problem.
template <class P>
using TallyOf = typename detail::TallyOf<P>::type;

}  // namespace kusabi::engine
