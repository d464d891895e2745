// Leaves sorted by blocks, and their counts.
#include "nodes/wedged/pattern_search.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "engine/collectives.hpp"
#include "nodes/wedged/primal/primal_leaf.hpp"
#include "nodes/wedged/simple_leaves.hpp"
#include "nodes/wedged/tree/evidence_check.hpp"
#include "nodes/wedged/tree/preparation.hpp"
#include "nodes/wedged/tree/stiffness_enclosure.hpp"
#include "problems/wedged/problem_block.hpp"
#include "problems/wedged/scale_ratio.hpp"

namespace kusabi::wedged {
namespace {

// Adds known patterns that a stopped search has not found, up to a maximum number in all.
void add_missing(std::vector<Configuration>& known, std::uint64_t maximum,
                 std::vector<Configuration>& leaves) {
  for (auto& leaf : known) {
    const bool found = std::ranges::any_of(leaves, [&](const auto& other) {
      return other.block == leaf.block && other.pattern == leaf.pattern;
    });
    if (!found && leaves.size() < maximum) leaves.push_back(std::move(leaf));
  }
}

/// Enclosure of K for the exact test, if requested or required by the scales of the structure.
std::optional<verify::EnclosedProblem> enclosed_for_test(engine::Analysis& analysis,
                                                         const problems::WedgedProblem& problem,
                                                         const PatternParameters& parameters,
                                                         ExactTest& exact) {
  const auto* const structure = parameters.structure;
  if (structure == nullptr) return {};
  exact.scale_ratio = problems::scale_ratio(*structure, problem);
  const bool asked = exact.asked = parameters.proving == Proving::always;
  if (!asked && exact.scale_ratio <= max_safe_scale_ratio) return {};
  auto enclosed = enclosed_within(analysis, *structure,
                                  asked ? enclosed_stiffness_without_limit : enclosed_stiffness);
  if (!enclosed) {
    exact.unable = "the search ended before the exact test began";
    return {};
  }
  if (auto* why = std::get_if<std::string>(&*enclosed)) {
    exact.unable = *why + (asked ? "" : ", as does --prove");
    return {};
  }
  exact.done = true;
  return std::get<verify::EnclosedProblem>(*std::move(enclosed));
}

/// Result of a search for one pattern: nothing, an undecided leaf, or a pattern.
enum class FirstLeaf : char { none, open, cone };

FirstLeaf first_leaf(engine::Analysis& analysis, const PatternFindings& findings) {
  return engine::from_first_rank(analysis.transport(), [&] {
    const auto& leaves = findings.outcome.solutions;
    if (leaves.empty()) return FirstLeaf::none;
    return std::ranges::any_of(
               leaves, &Configuration::is_cone,
               [](const auto& found) -> const Configuration& { return found.solution; })
               ? FirstLeaf::cone
               : FirstLeaf::open;
  });
}

// Searches one pattern, the first in the order of the tree. If its first leaf is undecided, other
// nodes may show a pattern, and all are searched.
void search_first(engine::Analysis& analysis, SignPatternTree& tree, engine::Options search,
                  PatternFindings& findings) {
  search.goal = engine::Goal::first;
  findings.outcome = analysis.search(tree, search);
  const auto leaf = first_leaf(analysis, findings);
  if (leaf == FirstLeaf::cone) findings.outcome.status = engine::Status::solution_limit;
  if (leaf != FirstLeaf::open || findings.outcome.status != engine::Status::solved) return;
  search.goal = engine::Goal::all;
  search.checkpoint = {};
  findings.outcome = analysis.search(tree, search);
}

/// Enclosure of K for an optional test; nothing if it is too large, or there is no time.
std::optional<verify::EnclosedProblem> enclosed_if_small(engine::Analysis& analysis,
                                                         const PatternParameters& parameters) {
  if (parameters.structure == nullptr) return {};
  auto enclosed = enclosed_within(analysis, *parameters.structure, enclosed_stiffness);
  if (!enclosed || std::holds_alternative<std::string>(*enclosed)) return {};
  return std::get<verify::EnclosedProblem>(*std::move(enclosed));
}

// Patterns found without a tree: simple leaves, and for --exists one of the primal heuristic.
std::vector<Configuration> known_patterns(engine::Analysis& analysis,
                                          const problems::WedgedProblem& problem,
                                          std::span<const double> friction,
                                          const PatternParameters& parameters,
                                          const conic::Tolerances& tolerances) {
  auto known = simple_leaves(analysis, problem, friction, tolerances);
  if (!parameters.exists || !known.empty()) return known;
  if (auto leaf = leaf_without_tree(analysis, problem, friction, tolerances))
    known.push_back(std::move(*leaf));
  return known;
}

void sort_by_blocks(const problems::WedgedProblem& problem, std::span<const Preparation> prepared,
                    PatternFindings& findings) {
  for (const auto& candidates : problems::blocks_of(problem)) {
    const auto& own = prepared[findings.blocks.size()];
    findings.blocks.push_back({.candidates = candidates,
                               .branching = own.branching,
                               .bound_programs = own.root.programs,
                               .cones = 0,
                               .unresolved = 0});
  }
  for (const auto& leaf : findings.leaves) {
    auto& block = findings.blocks[leaf.block];
    switch (leaf.state) {
      case LeafState::flat:
        ++findings.flat;
        [[fallthrough]];
      case LeafState::feasible:
        ++block.cones;
        break;
      case LeafState::marginal:
        ++findings.marginal;
        ++block.unresolved;
        break;
      case LeafState::undecided:
        ++findings.undecided;
        ++block.unresolved;
        break;
    }
  }
}

// The counts of the tree: every leaf was opened once, even if a resumed run has recorded it twice.
void count_kept(PatternFindings& findings) {
  auto tally = findings.outcome.tally();
  for (std::size_t block = 0; block < tally.of_block.size(); ++block)
    findings.blocks[block].cones += tally.of_block[block];
  findings.largest = std::move(tally.largest);
}

// Every node is tested exactly; nodes that fail are refused.
void test_all_nodes(SignPatternTree& tree, const EvidenceCheck& check, bool unconstrained,
                    PatternFindings& findings) {
  findings.exact.done = check.can_prove();
  // For constrained bodies the bounds of the solver are valid without the test. For unconstrained
  // ones they depend on its tolerances for rigid-body modes.
  if (!check.can_prove() && unconstrained)
    findings.exact.unable = "its stiffness is too ill-conditioned for an exact factor";
  if (check.can_prove() || unconstrained)
    tree.test_with([&check](const auto& evidence) { return check.proof(evidence); }, true);
}

void test_degenerate_nodes(SignPatternTree& tree, const EvidenceCheck& check) {
  tree.test_with(
      [&check](const auto& evidence) {
        return evidence.kind == Evidence::Kind::no_claim ? check.proof(evidence)
                                                         : NodeProof::complete;
      },
      false);
}

// The maximal cones of all leaves, and the counts of the exact test.
// @param known patterns found before the search, up to `maximum`
void collect_leaves(PatternFindings& findings, std::vector<Configuration>& known,
                    std::uint64_t maximum) {
  std::vector<Configuration> leaves;
  for (const auto& found : findings.outcome.solutions) leaves.push_back(found.solution);
  if (!findings.whole()) add_missing(known, maximum, leaves);
  findings.leaves = maximal_cones(std::move(leaves));
  const auto tally = findings.outcome.tally();
  findings.tested = tally.tested;
  std::ranges::sort(findings.tested, [](const auto& a, const auto& b) {
    return a.block != b.block ? a.block < b.block : comes_before(a.pattern, b.pattern);
  });
  findings.exact.refused = tally.refused;
  findings.exact.unproved = tally.unproved;
  findings.exact.closed_unproved = tally.closed_unproved;
  if (tally.except_large_displacements > 0)
    findings.exact.displacement_ratio = verify::largest_displacement_ratio;
}

}  // namespace

PatternFindings find_patterns(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                              std::span<const double> friction,
                              const PatternParameters& parameters) {
  PatternFindings findings;
  auto options = parameters.tree;
  const auto enclosed = enclosed_for_test(analysis, problem, parameters, findings.exact);
  options.thorough = options.thorough || enclosed;
  options.tolerances =
      resolving(options.tolerances, enclosed ? exact_test_resolution : rounding_of_files);
  SignPatternTree tree(problem, friction, options);
  std::vector<Configuration> known;
  if (options.facets == 0 && !enclosed && !parameters.kept)
    known = known_patterns(analysis, problem, friction, parameters, parameters.tree.tolerances);
  auto search = parameters.search;
  // No search if the known patterns suffice.
  const auto maximum =
      parameters.exists ? 1 : std::min(analysis.budget().left().solutions, search.limits.solutions);
  const bool enough = known.size() >= maximum;
  if (enough) search.limits.nodes = 0;
  const SignPatternOptions as_it_is{.tolerances = options.tolerances,
                                    .branching = Branching::relative,
                                    .tightening = Tightening::never};
  auto prepared = prepare(analysis, problem, friction, enough ? as_it_is : options);
  // A certificate makes no claim on degenerate nodes. For unconstrained bodies the exact test
  // proves that the configurations of some of them are those of other leaves.
  std::optional<verify::EnclosedProblem> of_unconstrained;
  if (!enclosed && parameters.recorder && problem.modes.matrix.cols() > 0)
    of_unconstrained = enclosed_if_small(analysis, parameters);
  std::optional<EvidenceCheck> check;
  if (enclosed || of_unconstrained) {
    const bool badly_scaled = enclosed && findings.exact.scale_ratio > max_safe_scale_ratio;
    check.emplace(problem, enclosed ? *enclosed : *of_unconstrained, friction,
                  proved_bounds(prepared),
                  badly_scaled ? LargeDisplacements::counted : LargeDisplacements::left_out);
    if (check->can_prove() && !check->proves_bounds()) remove_bounds(prepared);
  }
  configure(tree, prepared);
  if (parameters.recorder) tree.report_to(parameters.recorder);
  if (parameters.kept) tree.keep_found(parameters.kept);
  findings.bounds = proved_bounds(prepared);
  if (enclosed) test_all_nodes(tree, *check, problem.modes.matrix.cols() > 0, findings);
  if (of_unconstrained) test_degenerate_nodes(tree, *check);
  if (parameters.exists && !enough)
    search_first(analysis, tree, search, findings);
  else
    findings.outcome = analysis.search(tree, search);
  if (enough) findings.outcome.status = engine::Status::solution_limit;
  collect_leaves(findings, known, maximum);
  sort_by_blocks(problem, prepared, findings);
  if (parameters.kept) count_kept(findings);
  return findings;
}

void PatternFindings::remove_flat(const std::function<bool(const Configuration&)>& is_removed) {
  std::erase_if(leaves, [&](const auto& leaf) {
    if (leaf.state != LeafState::flat || !is_removed(leaf)) return false;
    --flat;
    --blocks[leaf.block].cones;
    return true;
  });
}

support::ExactCount PatternFindings::count() const {
  std::vector<std::uint64_t> cones;
  for (const auto& block : blocks) cones.push_back(block.cones);
  return combinations(cones);
}

support::IndexSet PatternFindings::inactive() const {
  support::IndexSet candidates;
  if (!whole()) return candidates;
  for (const auto& block : blocks) {
    if (block.is_inactive()) candidates |= block.candidates;
  }
  return candidates;
}

}  // namespace kusabi::wedged
