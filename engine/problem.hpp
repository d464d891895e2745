// What a problem type must offer to be searched. (Something offered under one of these names but in
// another shape is an error: engine/detail/problem_check.hpp.)
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "engine/expansion.hpp"

namespace kusabi::engine {

/// A tree to search: its root, and a way to open a node.
///
/// `Node` and `Solution` are values that can be copied, assigned and made without arguments, and
/// that Boost.Serialization can write and read. A node is a subproblem and nothing else: whatever
/// is large or expensive to set up (a factorisation, a solver's workspace) belongs into the problem
/// object, of which every rank has its own. What `expand` does must depend on the node alone.
template <class P>
concept Problem = requires(P& problem, const P& looked_at, typename P::Node node,
                           Expansion<P>& out) {
  typename P::Solution;
  { looked_at.root() } -> std::same_as<typename P::Node>;
  problem.expand(std::move(node), out);
};

/// A problem with an objective to be made small: what Goal::best asks for.
template <class P>
concept Minimising = Problem<P> &&
    requires(const P& problem, const typename P::Solution& solution) {
  { problem.objective(solution) } -> std::convertible_to<double>;
};

/// A minimising problem that can tell, without opening a node, a lower bound of the objective of
/// every solution below it. Nodes whose bound is above the best known objective are not opened.
template <class P>
concept Bounded = Minimising<P> && requires(const P& problem, const typename P::Node& node) {
  { problem.bound(node) } -> std::convertible_to<double>;
};

/// A problem that counts things of its own while it expands nodes. Each rank's `tally()` (a
/// Boost-serialisable value of type `Tally`) comes with the outcome, in the order of the ranks.
template <class P>
concept Tallying = Problem<P> && requires(const P& problem) {
  { problem.tally() } -> std::convertible_to<typename P::Tally>;
};

/// The tally of a problem that keeps none.
struct NoTally {
  template <class Archive>
  void serialize(Archive& /*archive*/, unsigned /*version*/) {}
};

/// A problem that says how much work is usually below a node's first child, in units of the work
/// below each other child. Used only for the progress estimate.
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

/// What a rank hands in as its tally.
template <class P>
using TallyOf = typename detail::TallyOf<P>::type;

}  // namespace kusabi::engine
