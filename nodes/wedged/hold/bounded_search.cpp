// Search without bounds up to a number of nodes, then anew with bounds.
#include "nodes/wedged/hold/bounded_search.hpp"

#include <cstdint>

#include "nodes/wedged/tree/preparation.hpp"

namespace kusabi::wedged {

HoldOutcome search_for_state(engine::Analysis& analysis, const LoadedProblem& block,
                             TreeEvidence& tree, const HoldParameters& parameters, bool recorded) {
  TreeEvidence* const evidence = recorded ? &tree : nullptr;
  tree.max_nodes = parameters.nodes_of_evidence;
  const auto new_tree = [&] {
    auto made = tree_of(block, tree, parameters.precision);
    made.try_suggested();
    return made;
  };
  const auto candidates = static_cast<int>(block.problem.contact_names.size());
  const bool automatic = parameters.tightening == Tightening::automatic;
  // All evidence is wanted.
  const bool plain_evidence = recorded && !parameters.nodes_of_evidence && !tree.may_have_bounds();
  if (plain_evidence || parameters.tightening == Tightening::never ||
      (automatic && candidates > max_candidates_to_bound)) {
    HoldTree plain = new_tree();
    return first_leaf(analysis, plain, evidence);
  }
  std::uint64_t opened = 0, iterations = 0;
  if (automatic) {
    HoldTree plain = new_tree();
    auto found = first_leaf_of_small(
        analysis, plain, static_cast<std::uint64_t>(nodes_per_candidate * candidates), evidence);
    if (found.status != engine::Status::node_limit) return found;
    opened = found.opened;
    iterations = found.tally.iterations;
  }
  HoldTree bounded = new_tree();
  CandidateBounding bounding = bounded.bounding();
  improve_bounds(analysis, bounding);
  bounded.tighten(bounding.bounds());
  const bool records = recorded && tree.may_have_bounds();
  if (records) {
    tree.bounds = bounding.proved();
    tree.weights = bounded.weights();
  }
  auto found = first_leaf(analysis, bounded, records ? &tree : nullptr);
  found.opened += opened;
  found.tally.iterations += iterations;
  return found;
}

}  // namespace kusabi::wedged
