// Flat cones: patterns feasible only with t* = 0, recognised as degenerate leaves with inactive
// candidates over a range of coefficients.
#include <algorithm>

#include "nodes/wedged/friction/critical_friction.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

// Relative distance of the coefficients at which a degenerate leaf is solved again: much larger
// than the range in which a pattern is degenerate near its own critical coefficient, and too small
// for another pattern to become feasible.
constexpr double beside = 1e-4;

}  // namespace

bool CriticalFriction::feasible_alone(const support::IndexSet& contact,
                                      const support::IndexSet& separated) {
  ++programs_;
  const auto both = contact | separated;
  if (!unconstrained_) {
    const auto others = support::IndexSet::below(static_cast<int>(own_.size())) - both;
    return solver_.solve(contact, separated, {}, others).sign == conic::Sign::feasible;
  }
  std::vector<double> friction;
  for (const int i : both) friction.push_back(friction_[static_cast<std::size_t>(i)]);
  ContactSolver alone(problems::problem_without_others(*unconstrained_, both), friction,
                      tolerances);
  alone.end_when(stop_);
  return alone.solve(problems::in_block(contact, both), problems::in_block(separated, both), {})
             .sign == conic::Sign::feasible;
}

bool CriticalFriction::is_flat(const SignPattern& pattern, double factor) {
  set_friction(factor);
  const auto inside = solver_.relative_interior(pattern.contact, pattern.separated);
  return inside && feasible_without_inactive(pattern, *inside) &&
         lasts(pattern, factor, tolerances);
}

// At the end of its range, where it becomes solid, a flat cone is degenerate on one side only.
bool CriticalFriction::lasts(const SignPattern& leaf, double factor,
                             const conic::Tolerances& zero) {
  return is_degenerate(leaf, factor * (1 + beside), zero) ||
         is_degenerate(leaf, std::max(range_.minimum, factor * (1 - beside)), zero);
}

// True if some candidates of the leaf are inactive, and the others are feasible without them.
bool CriticalFriction::feasible_without_inactive(const SignPattern& leaf,
                                                 const conic::RelativeInterior& inside) {
  const auto& [loaded, moved] = inside;
  if (loaded.empty() || loaded.meets(moved)) return false;
  return (loaded | moved) != (leaf.contact | leaf.separated) && feasible_alone(loaded, moved);
}

bool CriticalFriction::is_degenerate(const SignPattern& leaf, double factor,
                                     const conic::Tolerances& zero) {
  ++programs_;
  set_friction(factor);
  return conic::is_within_tolerance(solver_.solve(leaf.contact, leaf.separated, {}), zero);
}

LeafStage CriticalFriction::stage(const SignPattern& leaf, std::int64_t point) {
  using Kind = LeafStage::Kind;
  constexpr conic::Tolerances of_tree;  // the tolerances of the tree of sign patterns
  const double factor = at(point);
  if (factor < range_.minimum) return {point == 0 ? Kind::infeasible : Kind::unresolved, {}, {}};
  ++programs_;
  set_friction(factor);
  const auto answer = solver_.solve(leaf.contact, leaf.separated, sign_only);
  if (answer.sign == conic::Sign::infeasible) return {Kind::infeasible, {}, {}};
  if (answer.sign == conic::Sign::feasible) return {Kind::solid, {}, {}};
  const LeafStage open{Kind::unresolved, {}, {}};
  if (!conic::is_within_tolerance(answer, of_tree)) return open;
  const auto inside = solver_.relative_interior(leaf.contact, leaf.separated);
  if (!inside) return open;
  if (inside->loaded.empty()) return {Kind::infeasible, {}, {}};  // by less than the tolerance
  return feasible_without_inactive(leaf, *inside) && lasts(leaf, factor, of_tree)
             ? LeafStage{Kind::flat, inside->loaded, inside->moved}
             : open;
}

}  // namespace kusabi::wedged
