// CheckedProblem: compile-time check of a problem type, with one sentence per fault.
//
// A function that does not match a concept of engine/problem.hpp would otherwise be ignored
// silently: a bound() that is not const would prune nothing.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "engine/detail/member_names.hpp"
#include "engine/detail/serializable.hpp"
#include "engine/expansion.hpp"
#include "engine/problem.hpp"

namespace kusabi::engine {

template <class P>
struct Outcome;

enum class Fault {
  none,
  no_node,
  no_solution,
  node_not_a_value,
  solution_not_a_value,
  node_not_serializable,
  solution_not_serializable,
  root,
  expand,
  objective,
  bound,
  bound_without_objective,
  maximises,
  emit,
  tally,
  tally_not_a_value,
  tally_not_serializable,
  work_of_first_child,
};

/// A default constructible, copyable and assignable type.
template <class Value>
concept PlainValue = std::copyable<Value> && std::default_initializable<Value>;

/// First fault of a problem type.
template <class P>
consteval Fault fault_of() {
  if constexpr (!requires { typename P::Node; }) {
    return Fault::no_node;
  } else if constexpr (!requires { typename P::Solution; }) {
    return Fault::no_solution;
  } else if constexpr (!PlainValue<typename P::Node>) {
    return Fault::node_not_a_value;
  } else if constexpr (!PlainValue<typename P::Solution>) {
    return Fault::solution_not_a_value;
  } else if constexpr (!Serializable<typename P::Node>) {
    return Fault::node_not_serializable;
  } else if constexpr (!Serializable<typename P::Solution>) {
    return Fault::solution_not_serializable;
  } else if constexpr (!requires(const P& problem) {
                         { problem.root() } -> std::same_as<typename P::Node>;
                       }) {
    return Fault::root;
  } else if constexpr (!Problem<P>) {
    return Fault::expand;
  } else if constexpr (NamesObjective<P> && !Optimising<P>) {
    return Fault::objective;
  } else if constexpr (NamesBound<P> && !Optimising<P>) {
    return Fault::bound_without_objective;
  } else if constexpr (NamesBound<P> && !Bounded<P>) {
    return Fault::bound;
  } else if constexpr (NamesMaximises<P> && !WithSense<P>) {
    return Fault::maximises;
  } else if constexpr (NamesEmit<P> && !Emitting<P>) {
    return Fault::emit;
  } else if constexpr (NamesTally<P> && !Tallying<P>) {
    return Fault::tally;
  } else if constexpr (!PlainValue<TallyOf<P>>) {
    return Fault::tally_not_a_value;
  } else if constexpr (!Serializable<TallyOf<P>>) {
    return Fault::tally_not_serializable;
  } else if constexpr (NamesWorkOfFirstChild<P> && !Uneven<P>) {
    return Fault::work_of_first_child;
  } else {
    return Fault::none;
  }
}

/// Fails to compile, with a sentence, unless `P` is a problem.
template <class P>
struct CheckedProblem {
  static constexpr Fault fault = fault_of<P>();
  static constexpr bool sound = fault == Fault::none;

  static_assert(fault != Fault::no_node, "a problem needs a type Node: a subproblem");
  static_assert(fault != Fault::no_solution,
                "a problem needs a type Solution: the result of a leaf");
  static_assert(fault != Fault::node_not_a_value,
                "a Node must be default constructible, copyable and assignable");
  static_assert(fault != Fault::solution_not_a_value,
                "a Solution must be default constructible, copyable and assignable");
  static_assert(fault != Fault::node_not_serializable,
                "a Node needs `template <class Archive> void serialize(Archive& archive, unsigned "
                "version)`, or what Boost.Serialization has for its type must be included");
  static_assert(fault != Fault::solution_not_serializable,
                "a Solution needs `template <class Archive> void serialize(Archive& archive, "
                "unsigned version)`, or what Boost.Serialization has for its type must be "
                "included");
  static_assert(fault != Fault::root, "a problem needs `Node root() const`");
  static_assert(fault != Fault::expand,
                "a problem needs `void expand(Node&& node, kusabi::engine::Expansion<P>& out)`, "
                "where P is the problem itself");
  static_assert(fault != Fault::objective,
                "objective must be `double objective(const Solution& solution) const`");
  static_assert(fault != Fault::bound, "bound must be `double bound(const Node& node) const`");
  static_assert(fault != Fault::bound_without_objective,
                "a problem with a bound needs `double objective(const Solution& solution) const`");
  static_assert(fault != Fault::maximises,
                "maximises must be `static constexpr bool maximises = true`");
  static_assert(fault != Fault::emit,
                "emit must be `bool emit(const kusabi::engine::Path& path, Solution& solution)`");
  static_assert(fault != Fault::tally,
                "tally must be `Tally tally() const`, and Tally a type of the problem");
  static_assert(fault != Fault::tally_not_a_value,
                "a Tally must be default constructible, copyable and assignable");
  static_assert(fault != Fault::tally_not_serializable,
                "a Tally needs `template <class Archive> void serialize(Archive& archive, unsigned "
                "version)`, or what Boost.Serialization has for its type must be included");
  static_assert(fault != Fault::work_of_first_child,
                "work_of_first_child must be a `static constexpr double` greater than 0");

  /// Result type of a search; void if `P` cannot be searched, to avoid further errors.
  using OutcomeOrNothing = std::conditional_t<sound, Outcome<P>, void>;
};

/// The outcome of a search; void unless `P` is a problem.
template <class P>
using OutcomeOf = typename CheckedProblem<P>::OutcomeOrNothing;

}  // namespace kusabi::engine
