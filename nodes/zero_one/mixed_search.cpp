// Root on every rank, tree on all ranks, and the combined result.
#include "nodes/zero_one/mixed_search.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "engine/collectives.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::zero_one {
namespace {

// Fingerprint of the initial data of the search, which every rank has computed.
std::uint64_t fingerprint_of(const ZeroOneRoot& root) {
  support::Fingerprint fingerprint;
  const auto& program = root.relaxation.program();
  for (const auto& column : program.columns) {
    fingerprint.add(column.lower);
    fingerprint.add(column.upper);
  }
  for (const auto& row : program.rows) {
    fingerprint.add(row.lower);
    fingerprint.add(row.upper);
  }
  for (const auto& entry : program.entries) fingerprint.add(entry.value);
  fingerprint.add(root.bound);
  fingerprint.add(root.point ? root.point->objective : linear::infinity);
  return fingerprint.value();
}

// The outcome of a stopped root: its bound and its point, and one open node.
engine::Outcome<ZeroOneTree> outcome_of_root(const ZeroOneTree& tree, int ranks,
                                             engine::Status why) {
  engine::Outcome<ZeroOneTree> outcome;
  outcome.status = why;
  outcome.open = 1;
  outcome.bound = tree.prepared().bound;
  if (const auto& point = tree.prepared().point) outcome.solutions.push_back({{}, *point});
  outcome.ranks.resize(static_cast<std::size_t>(ranks));
  return outcome;
}

// If the relaxation is unbounded, which is proved, so is the program if it has a point: the direction
// of decreasing objective does not change the binaries. The search then only needs a point.
bool without_bound(ZeroOneRoot& root, const linear::MixedProgram& mixed,
                   const ZeroOneRootOptions& options) {
  if (root.status != linear::LinearStatus::unbounded || root.interrupted) return false;
  auto any_point = mixed;
  for (auto& column : any_point.program.columns) column.cost = 0;
  root = prepare_root(std::move(any_point), options);
  return true;
}

}  // namespace

MixedRoot mixed_root(engine::Analysis& analysis, const linear::MixedProgram& mixed,
                     ZeroOneRootOptions options) {
  options.stop = analysis.budget().stop();
  MixedRoot result{.root = prepare_root(mixed, options)};
  result.unbounded = without_bound(result.root, mixed, options);
  // A rank stopped at the root stops all, since their roots differ.
  const std::uint64_t interrupted = result.root.interrupted ? 1 : 0;
  const auto all = engine::all_reduce(analysis.transport(), {.ranks = 1, .found = interrupted});
  result.stopped = all.found != 0;
  if (!result.stopped)
    engine::require_equal_on_all_ranks(analysis.transport(), fingerprint_of(result.root));
  return result;
}

MixedAnswer search_tree(engine::Analysis& analysis, MixedRoot root, ZeroOneBranching branching,
                        engine::Options options, const engine::ShownObjective& shown) {
  MixedAnswer answer{ZeroOneTree(std::move(root.root), branching), {}, root.unbounded};
  options.goal = engine::Goal::best;
  // Points are feasible within tolerances only, so that their objective may be below a proved
  // bound; the report compares both.
  options.bound_tolerance = std::numeric_limits<double>::infinity();
  answer.outcome = root.stopped ? outcome_of_root(answer.tree, analysis.transport().size(),
                                                  analysis.budget().stop_reason())
                                : analysis.search(answer.tree, std::move(options), shown);
  return answer;
}

MixedAnswer solve_mixed(engine::Analysis& analysis, const linear::MixedProgram& mixed,
                        const ZeroOneRootOptions& root_options, ZeroOneBranching branching,
                        const engine::Options& options, const engine::ShownObjective& shown) {
  return search_tree(analysis, mixed_root(analysis, mixed, root_options), branching, options,
                     shown);
}

MixedStatus MixedAnswer::status() const {
  const bool whole = outcome.status == engine::Status::solved;
  if (point() == nullptr) {
    return whole && outcome.tally().unproved == 0 ? MixedStatus::infeasible : MixedStatus::unknown;
  }
  if (unbounded) return MixedStatus::unbounded;
  const double objective = point()->objective;
  const double missing = std::abs(objective - bound());
  const double maximum = optimality_tolerance * std::abs(objective);
  return whole && missing <= maximum ? MixedStatus::optimal : MixedStatus::feasible;
}

const ZeroOnePoint* MixedAnswer::point() const {
  return outcome.solutions.empty() ? nullptr : &outcome.solutions.front().solution;
}

double MixedAnswer::bound() const {
  if (unbounded) return -linear::infinity;  // the tree is that of the program without costs
  return tree.lower_bound(outcome.bound, outcome.tally());
}

bool MixedAnswer::answered() const {
  const auto found = status();
  return outcome.status == engine::Status::solved && found != MixedStatus::feasible &&
         found != MixedStatus::unknown;
}

}  // namespace kusabi::zero_one
