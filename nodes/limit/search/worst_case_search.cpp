// Every rank computes the root; rank 0 proves.
#include "nodes/limit/search/worst_case_search.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include "engine/collectives.hpp"
#include "nodes/limit/model/balanced_model.hpp"
#include "nodes/limit/root/corner.hpp"
#include "nodes/limit/search/proved_ends.hpp"
#include "nodes/limit/search/zero_one_worst.hpp"

namespace kusabi::limit {

namespace {

// Takes the best solution of a search, if there is one: a load with a smaller factor, or without.
void take(const std::vector<SignTree::Solution>& best, RootResult& root) {
  if (best.empty()) return;
  const auto vector = [](const std::vector<double>& values) {
    return Eigen::VectorXd(
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  const auto& found = best.front();
  if (std::isfinite(found.factor)) {
    root.worst =
        Worst{vector(found.zeta), {found.factor, vector(found.forces), vector(found.motion)}};
  } else {
    root.status = RootStatus::not_carried;
    root.overpowering_load = vector(found.zeta);
    root.overpowering_motion = vector(found.motion);
  }
}

// The worst load of a root if it is worse than that of another one.
std::vector<SignTree::Solution> worse_load(const RootResult& found, const RootResult& known) {
  const auto numbers = [](const Eigen::VectorXd& vector) {
    return std::vector<double>(vector.begin(), vector.end());
  };
  if (found.status == RootStatus::not_carried) {
    return {{-linear::infinity,
             numbers(found.overpowering_load),
             numbers(found.overpowering_motion),
             {}}};
  }
  if (!found.worst || found.worst->collapse.factor >= known.worst->collapse.factor) return {};
  const auto& [zeta, collapse] = *found.worst;
  return {{collapse.factor, numbers(zeta), numbers(collapse.motion), numbers(collapse.forces)}};
}

}  // namespace

SignSearch search_signs(RootSearch& search, RootResult& root, double alpha, NoFactorProof proof) {
  auto& analysis = search.analysis();
  SignTree tree(search.model(), alpha, root, true, analysis.budget().stop(), std::move(proof));
  engine::Options options;
  options.goal = engine::Goal::best;
  const auto outcome = analysis.search(
      tree, options, {search.model().factor_unit, root.worst->collapse.factor, root.lower});
  SignSearch result;
  std::vector<SignTree::Solution> best;
  std::tie(best, result.status) = engine::from_first_rank(analysis.transport(), [&] {
    result.nodes = outcome.opened();
    for (const auto* const reports : {&outcome.earlier, &outcome.ranks}) {
      for (const auto& rank : *reports) {
        const auto& tally = rank.tally;
        result.programs +=
            tally.counts.load_factors + tally.counts.relaxations + tally.counts.pricings;
        result.corners += tally.corners;
        result.closed.insert(result.closed.end(), tally.evidence.begin(), tally.evidence.end());
      }
    }
    std::ranges::sort(result.closed, {}, &ClosedNode::signs);
    std::vector<SignTree::Solution> found;
    if (!outcome.solutions.empty()) found.push_back(outcome.solutions.front().solution);
    return std::pair(found, outcome.status);
  });
  take(best, root);
  return result;
}

// Proves both bounds in exact arithmetic on rank 0 and broadcasts the result.
void WorstCaseSearch::prove(const RootResult& root, std::vector<ClosedNode> nodes,
                            LimitWorstCase& worst) {
  const double unit = model().factor_unit;
  const bool of_a_tree = nodes.size() > 1;
  const bool only_corners = std::ranges::all_of(nodes, [&](const ClosedNode& node) {
    return first_undecided(model(), search_.scaled(alpha()), node.signs) < 0;
  });
  const bool enough = root.status == RootStatus::enough;
  worst.ends = engine::from_first_rank(search_.analysis().transport(), [&] {
    const bool again = worst.search == engine::Status::solved && !enough;
    const bool any =
        again || !nodes.front().forces.empty();  // otherwise only the upper bound remains
    auto [ends, theorem] = proved_ends(
        {truss_, search_.problem(), model(), alpha(), *root.worst,
         any ? root.cuts : std::vector<StaticCut>(), std::move(nodes), root.nominal_basis,
         of_a_tree || !search_.splits() ? std::numeric_limits<double>::infinity()
                                        : root.lower * unit},
        again);
    if (enough) theorem.nodes.clear();
    if (ends.upper && (ends.lower || enough)) theorem_ = std::move(theorem);
    // Proofs of nodes beyond the gap depend on the incumbent when they were closed, and so on the
    // number of ranks; those of corners do not.
    const bool rounded = of_a_tree && !only_corners;
    const double below = rounded ? ends.at_most() - 2 * closed_gap * unit : ends.at_most();
    if (ends.lower) ends.lower->value = std::min(ends.lower->value, below);
    return ends;
  });
  const auto& ends = worst.ends;
  const double upper = ends.upper ? ends.upper->value : root.worst->collapse.factor * unit;
  const double lower = ends.lower ? ends.lower->value : root.lower * unit;
  const bool near = upper - lower <= answered_gap * unit;
  worst.status = near ? RootStatus::closed : RootStatus::open;
  worst.standing = support::proved_if(near && ends.has_proved_ends());
}

// Takes the result that a load has no factor, if the motion proves it.
// @param zeta scaled, as the motion
bool WorstCaseSearch::prove_no_factor(const Eigen::VectorXd& zeta, const Eigen::VectorXd& motion,
                                      LimitWorstCase& worst) {
  theorem_ = evidence_of_no_factor(truss_, search_.problem(), model(), alpha(), zeta, motion);
  if (!theorem_) return false;
  worst.status = RootStatus::not_carried;
  worst.ends = {};
  worst.zeta = zeta * model().force_unit;
  worst.overpowering_motion = problems::motion_in_units(model(), motion);
  worst.standing = support::Standing::proved;
  return true;
}

// Static cuts for a lower bound on rank 0, which proves it, after a search of corners was stopped. A
// worse load that they show is taken by all ranks.
void WorstCaseSearch::bound_in_little_time(RootResult& root) {
  using Clock = std::chrono::steady_clock;
  constexpr auto grace = std::chrono::milliseconds(300);
  // The stop test of a linear program is asked between pieces of it: larger ones would take seconds.
  constexpr std::uint64_t max_iterations = 4000;
  const auto iterations = search_.load_factor().first_iterations() * model().uncertain.size();
  if (iterations > max_iterations) return;
  take(engine::from_first_rank(search_.analysis().transport(),
                               [&] {
                                 const auto end = Clock::now() + grace;
                                 const support::Stop stop = [end] { return Clock::now() > end; };
                                 LoadFactor load_factor(model(), stop);
                                 load_factor.start_from(root.nominal_basis);
                                 load_factor.restart();
                                 StaticPricing pricing(model(), stop);
                                 auto found = solve_root(
                                     model(), search_.scaled(alpha()), search_.nominal(),
                                     load_factor,
                                     [&](const Eigen::VectorXd& z, std::span<const int> columns) {
                                       return price_alone(pricing, z, columns);
                                     },
                                     {.stop = stop});
                                 root.cuts = std::move(found.cuts);
                                 root.proof = std::move(found.proof);
                                 return worse_load(found, root);
                               }),
       root);
}

// Continues from the root with the tree, if it is open, and the proof.
void WorstCaseSearch::conclude(RootResult& root, LimitWorstCase& worst) {
  std::vector<ClosedNode> nodes;
  if (root.status == RootStatus::open || root.status == RootStatus::unbounded) {
    const auto has_no_factor = [this](const Eigen::VectorXd& zeta, const Eigen::VectorXd& motion) {
      return evidence_of_no_factor(truss_, search_.problem(), model(), alpha(), zeta, motion)
          .has_value();
    };
    auto tree = search_signs(search_, root, search_.scaled(alpha()), has_no_factor);
    worst.search = tree.status;
    worst.nodes = tree.nodes;
    worst.corners = tree.corners;
    worst.tree_programs += tree.programs;
    // Nodes that do not cover all signs prove nothing, but the root does.
    if (tree.status == engine::Status::solved) {
      nodes = std::move(tree.closed);
    } else if (root.status != RootStatus::not_carried && root.proof.forces.size() == 0) {
      bound_in_little_time(root);
      worst.cuts = root.cuts.size();
    }
  }
  if (root.status == RootStatus::stopped) worst.search = search_.analysis().budget().stop_reason();
  if (root.status == RootStatus::not_carried) {
    if (prove_no_factor(root.overpowering_load, root.overpowering_motion, worst)) return;
    // It is open whether the load has a factor: no lower bound holds.
    root.status = RootStatus::failed;
    root.lower = -linear::infinity;
    root.proof = {};
    nodes.clear();
  }
  if (!root.worst) {
    // The nominal load is admissible.
    root.worst = Worst{Eigen::VectorXd::Zero(model().uncertain_count()), search_.nominal()};
  }
  if (nodes.empty()) {
    root.proof.signs.resize(model().uncertain.size());
    nodes.push_back(closed_node(root.proof, {}));
  }
  prove(root, std::move(nodes), worst);
  worst.zeta = root.worst->zeta * model().force_unit;
  worst.collapse = search_.in_units(root.worst->collapse, dead_load(model(), root.worst->zeta));
}

LimitWorstCase WorstCaseSearch::by_static_cuts() {
  for (;;) {
    LimitWorstCase worst;
    RootResult result = search_.solve_balanced(alpha(), parameters_.corners);
    worst.counts = result.counts;
    worst.cuts = result.cuts.size();
    conclude(result, worst);
    if (worst.proved() || worst.search != engine::Status::solved) return worst;
    auto model_with_more = with_more_yield(search_.problem(), model());
    if (!model_with_more) return worst;
    if (search_.set_up(*std::move(model_with_more)) != LoadStatus::collapses) return worst;
  }
}

// Keeps the load of a motion, and the end of the descent from it, if its factor is smaller.
void WorstCaseSearch::take_if_worse(const Eigen::VectorXd& motion, Worst& known) {
  const auto descent = descend(model(), search_.load_factor(), search_.scaled(alpha()),
                               worst_for(model(), search_.scaled(alpha()), motion, known.zeta));
  if (descent.status == LoadStatus::collapses &&
      descent.worst.collapse.factor < known.collapse.factor) {
    known = descent.worst;
  }
}

// Solves (29), then proves the bounds by the same evidence as without it: a 0-1 tree in floating
// point with an M of assumed size proves nothing.
LimitWorstCase WorstCaseSearch::by_zero_one_program() {
  LimitWorstCase worst;
  RootResult result = search_.solve_balanced(alpha());
  worst.counts = result.counts;
  worst.cuts = result.cuts.size();
  const bool usable = result.worst && result.status != RootStatus::not_carried &&
                      result.status != RootStatus::stopped;
  std::optional<ZeroOneWorst> zero_one;
  if (usable) {
    zero_one = zero_one_worst(search_.analysis(), parameters_, model(), search_.scaled(alpha()),
                              result, start_);
    worst.no_safe_m = !zero_one;
  }
  if (zero_one) {
    if (zero_one->motion.size() > 0) take_if_worse(zero_one->motion, *result.worst);
    if (zero_one->status != engine::Status::solved) {
      worst.search = zero_one->status;
      result.status = RootStatus::closed;  // no tree of signs: the run is stopped
    }
  }
  conclude(result, worst);
  if (zero_one) worst.zero_one = zero_one->found;
  return worst;
}

// The load of the best point of (29), and its collapse by one program (5).
void WorstCaseSearch::show_critical_load(const Eigen::VectorXd& motion, LimitWorstCase& worst) {
  const Eigen::VectorXd plus = Eigen::VectorXd::Zero(model().uncertain_count());
  // The sign of t_j'u is that of the motion in the model's units, where t_j has several components.
  const Eigen::VectorXd scaled = motion.cwiseQuotient(model().displacement_unit);
  const auto zeta = worst_for(model(), search_.scaled(alpha()), scaled, plus);
  worst.zeta = zeta * model().force_unit;
  const auto dead = dead_load(model(), zeta);
  auto& load_factor = search_.load_factor();
  load_factor.restart();
  const auto status = load_factor.solve(dead);
  if (status == LoadStatus::collapses) {
    worst.collapse = search_.in_units(load_factor.collapse(), dead);
  }
  if (status == LoadStatus::not_carried)
    prove_no_factor(zeta, load_factor.overpowering_motion(), worst);
}

// The result of the paper's method by itself first; then, if requested, static evidence.
LimitWorstCase WorstCaseSearch::as_printed() {
  auto& analysis = search_.analysis();
  const auto printed = printed_worst(analysis, parameters_, search_.problem(), start_);
  LimitWorstCase worst;
  if (printed.status == engine::Status::solved && parameters_.evidence) {
    analysis.say("(29) is solved; its ends are tested by static cuts");
    worst = by_static_cuts();
  } else {
    worst.as_printed = true;
    worst.nodes = 0;
    worst.search = printed.status;
    worst.ends = {};
    if (std::isfinite(printed.found.lower)) worst.ends.lower = support::Bound{printed.found.lower};
    if (std::isfinite(printed.found.upper)) worst.ends.upper = support::Bound{printed.found.upper};
    const bool near = worst.ends.width() <= answered_gap * model().factor_unit;
    worst.status = near ? RootStatus::closed : RootStatus::open;
    if (printed.motion.size() > 0) show_critical_load(printed.motion, worst);
  }
  worst.zero_one = printed.found;
  return worst;
}

LimitWorstCase WorstCaseSearch::solve() {
  if (parameters_.method == LimitMethod::static_cuts) return by_static_cuts();
  return parameters_.as_printed() ? as_printed() : by_zero_one_program();
}

}  // namespace kusabi::limit
