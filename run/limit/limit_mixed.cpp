// From the model to (29), to its root and its tree, and back to a load.
#include "run/limit/limit_mixed.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <boost/serialization/vector.hpp>

#include "engine/together.hpp"
#include "nodes/limit/motion_bounds.hpp"
#include "nodes/zero_one/root.hpp"
#include "nodes/zero_one/tree.hpp"
#include "problems/limit/mixed_limit.hpp"
#include "run/session/shown_search.hpp"

namespace kusabi::run {
namespace {

using limit::MotionBounds;
using limit::StaticCut;
using problems::LimitModel;

// What rank 0 knows of the search, for all.
struct Found {
  std::vector<double> motion;
  double lower = 0;
  std::uint64_t nodes = 0;
  std::uint64_t programs = 0;
  engine::Status status = engine::Status::solved;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& motion& lower& nodes& programs& status;
  }
};

// gamma_j <= |y|'z + |k| as a row.
void add_static_row(linear::LinearProgram& program, const LimitModel& model, const StaticCut& cut) {
  std::vector<linear::LinearTerm> terms;
  terms.push_back({model.free_count() + model.member_count() + cut.column, 1});
  for (const auto& [member, force] : cut.forces) {
    terms.push_back({model.free_count() + member, -std::abs(force)});
  }
  program.add_row({.upper = std::abs(cut.factor)}, terms);
}

}  // namespace

std::optional<MixedWorst> solve_mixed(Session& session, const LimitOptions& options,
                                      const LimitModel& model, double alpha,
                                      const limit::RootResult& root, limit::LoadFactor& load_factor,
                                      const engine::Budget& budget) {
  const double infinity = linear::infinity;
  const bool all = options.method == LimitMethod::all;
  MixedWorst result;
  zero_one::ZeroOneRootOptions root_options{
      .tighten = all || options.method == LimitMethod::tightened,
      .dive = false,
      .stop = budget.stop()};
  if (all || options.method == LimitMethod::disjunctive) {
    root_options.cuts = zero_one::ZeroOneCuts::disjunctive;
  }
  const auto& known = root.worst;
  const auto& cuts = root.cuts;
  const std::optional<MotionBounds> bounds =
      limit::motion_bounds(model, alpha, cuts, known->collapse.factor);
  Eigen::VectorXd big_m;
  Eigen::VectorXd most_motion = Eigen::VectorXd::Constant(model.free_count(), infinity);
  Eigen::VectorXd most_elongation = Eigen::VectorXd::Constant(model.member_count(), infinity);
  if (bounds) {
    most_elongation = bounds->elongation;
    for (int j = 0; j < model.uncertain_count(); ++j) {
      most_motion(model.uncertain[static_cast<std::size_t>(j)].degree) = bounds->motion(j);
    }
    big_m = 2 * bounds->motion;
  }
  if (options.big_m) {
    big_m.resize(model.uncertain_count());
    for (int j = 0; j < model.uncertain_count(); ++j) {
      const int degree = model.uncertain[static_cast<std::size_t>(j)].degree;
      big_m(j) = *options.big_m / model.displacement_unit(degree);
    }
  }
  if (big_m.size() == 0) {
    return std::nullopt;
  }
  auto mixed = problems::worst_case_program(model, alpha, big_m, most_motion, most_elongation);
  if (all) {
    for (const StaticCut& cut : cuts) add_static_row(mixed.program, model, cut);
    result.cuts = cuts.size();
  }
  if (root_options.tighten) {
    root_options.start = problems::worst_case_point(model, known->collapse.motion);
  }
  auto prepared = zero_one::prepare_root(std::move(mixed), root_options);
  // One rank that was stopped at the root stops all: their roots differ.
  const auto stopped =
      engine::meet(session.transport(), {.ranks = 1, .found = prepared.interrupted ? 1U : 0U});
  if (stopped.found != 0) {
    result.worst = *known;
    result.lower = std::max(root.lower, prepared.bound);
    result.status = budget.why();
    result.programs = prepared.counts.programs;
    return result;
  }
  if (prepared.status != linear::LinearStatus::optimal) {
    throw std::runtime_error("the relaxation of (29) was not solved");
  }
  result.cuts += prepared.counts.cuts;
  result.cut_programs = prepared.counts.cut_programs;
  const auto root_programs = prepared.counts.programs;
  const auto start = prepared.point;
  zero_one::ZeroOneTree tree(std::move(prepared));
  engine::Options search_options;
  search_options.goal = engine::Goal::best;
  const auto outcome = shown_search(session, tree, search_options, budget.left(), options.quiet,
                                    {model.factor_unit, known->collapse.factor, root.lower});
  const auto found = engine::from_first_rank(session.transport(), [&] {
    Found known_here;
    const auto total = outcome.tally();
    known_here.lower = tree.lower_bound(outcome.bound, total);
    known_here.nodes = outcome.opened();
    known_here.status = outcome.status;
    known_here.programs = root_programs + total.programs;
    auto best = start;
    if (!outcome.solutions.empty()) best = outcome.solutions.front().solution;
    if (best) {
      known_here.motion.assign(best->values.begin(), best->values.begin() + model.free_count());
    }
    return known_here;
  });
  result.status = found.status;
  if (found.motion.empty()) {
    if (found.status == engine::Status::solved) {
      throw WrongInput(
          "--cuts: (29) has no point, its M is too small; expected a larger --big-m, "
          "or none");
    }
    result.worst = *known;
    result.lower = found.lower;
    result.nodes = found.nodes;
    result.programs = found.programs;
    return result;
  }
  const Eigen::Map<const Eigen::VectorXd> motion(found.motion.data(), model.free_count());
  const auto descent =
      descend(model, load_factor, alpha, limit::worst_for(model, alpha, motion, known->zeta));
  result.worst = *known;
  if (descent.status == limit::LoadStatus::collapses &&
      descent.worst.collapse.factor < known->collapse.factor) {
    result.worst = descent.worst;
  }
  result.lower = all ? std::max(found.lower, root.lower) : found.lower;
  result.nodes = found.nodes;
  result.programs = found.programs;
  return result;
}

}  // namespace kusabi::run
