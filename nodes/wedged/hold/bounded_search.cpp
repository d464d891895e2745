// First the beginning of the tree without bounds, which is the whole of a small one.
#include "nodes/wedged/hold/bounded_search.hpp"

#include <cstdint>

#include "nodes/wedged/tree/preparation.hpp"

namespace kusabi::wedged {

HoldOutcome search_for_state(engine::Analysis& analysis, const LoadedProblem& block,
                             TreeEvidence& tree, const HoldParameters& parameters, bool recorded) {
  const auto made = [&] {
    return HoldTree(block, tree.shares, tree.mu, parameters.precision, tree.grip);
  };
  HoldTree plain = made();
  const auto candidates = static_cast<int>(block.problem.contact_names.size());
  if (recorded) return first_leaf(analysis, plain, &tree);
  if (parameters.tightening == Tightening::never || candidates > max_candidates_to_bound)
    return first_leaf(analysis, plain);
  std::uint64_t opened = 0;
  if (parameters.tightening == Tightening::automatic) {
    auto found = first_leaf_of_small(analysis, plain,
                                     static_cast<std::uint64_t>(nodes_a_candidate * candidates));
    if (found.status != engine::Status::node_limit) return found;
    opened = found.opened;
  }
  HoldTree bounded = made();
  CandidateBounding bounding = bounded.bounding();
  improve_bounds(analysis, bounding);
  bounded.tighten(bounding.bounds());
  auto found = first_leaf(analysis, bounded);
  found.opened += opened;
  return found;
}

}  // namespace kusabi::wedged
