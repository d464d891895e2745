// Zeros of the relative interior, and programs of the leaves that they suggest.
#include "nodes/wedged/relaxation/degenerate_node.hpp"

#include <utility>

namespace kusabi::wedged {

using support::IndexSet;

bool DegenerateClassifier::is_degenerate(const conic::ConicResult& answer) const {
  return tolerances_.resolution >= rounding_of_files
             ? conic::is_within_tolerance(answer, tolerances_)
             : conic::is_unresolvable(answer, tolerances_);
}

DegenerateNode DegenerateClassifier::classify(BlockRelaxation& block, const PatternNode& node,
                                              const conic::ConicResult& answer,
                                              std::uint64_t& iterations) const {
  using Kind = DegenerateNode::Kind;
  const auto solved = [&](const SignPattern& leaf, conic::StopEarly stop) {
    const auto own = block.solver.solve(leaf.contact, block.all - leaf.contact, stop);
    iterations += static_cast<std::uint64_t>(own.iterations);
    return own;
  };
  const auto free = block.free(node.pattern);
  const Eigen::VectorXd multipliers = block.solver.multipliers();
  const auto inside = block.solver.relative_interior(node.pattern.contact, node.pattern.separated);
  if (!inside) return {};
  const auto& [loaded, moved] = *inside;
  if (loaded.empty()) return {.kind = Kind::infeasible, .multipliers = multipliers};
  const bool redundant = !loaded.includes(node.pattern.contact);
  if (redundant && (!thorough_ || free.empty())) return {.kind = Kind::redundant};
  const IndexSet both = loaded & moved;
  if (redundant || !both.empty())
    return {.kind = Kind::split, .undecided = both.empty() ? free : both};
  const PatternNode cone{
      node.block,
      {.contact = loaded, .separated = moved, .inactive = block.all - (loaded | moved)}};
  const IndexSet& inactive = cone.pattern.inactive;
  // If equilibrium makes all reactions of the free candidates zero, the node is degenerate, but the
  // single leaf below it with configurations may be solid.
  if (inactive.empty() && !free.empty()) {
    if (thorough_ || recorded_) return {.kind = Kind::split, .undecided = free};
    const auto own = solved(cone.pattern, {.when_infeasible = true, .when_feasible = false});
    if (own.sign == conic::Sign::feasible)
      return {.kind = Kind::leaf, .leaf = block.configuration(cone, LeafState::feasible, own)};
    if (!is_degenerate(own)) return {.kind = Kind::split, .undecided = free};
  }
  DegenerateNode flat{.kind = Kind::leaf,
                      .leaf = block.configuration(cone, LeafState::flat, answer)};
  // Inactive candidates have negligible reactions and gaps. The gaps may be positive nevertheless.
  if (inactive.meets(free) && solved(cone.pattern, {}).sign == conic::Sign::feasible)
    return {.kind = Kind::split, .undecided = inactive & free};
  return flat;
}

}  // namespace kusabi::wedged
