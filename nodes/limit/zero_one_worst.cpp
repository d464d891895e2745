// From the model to (29), to its root and its tree, and back to a load.
#include "nodes/limit/zero_one_worst.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/together.hpp"
#include "nodes/limit/motion_bounds.hpp"
#include "nodes/zero_one/mixed_search.hpp"
#include "problems/limit/mixed_limit.hpp"

namespace kusabi::limit {
namespace {

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

// (29) with the M asked for or a safe one; nothing if none is found.
std::optional<linear::MixedProgram> worst_case_program(const LimitQuestion& question,
                                                       const LimitModel& model, double alpha,
                                                       const RootResult& root) {
  const auto bounds = motion_bounds(model, alpha, root.cuts, root.worst->collapse.factor);
  Eigen::VectorXd big_m;
  Eigen::VectorXd most_motion = Eigen::VectorXd::Constant(model.free_count(), linear::infinity);
  Eigen::VectorXd most_elongation =
      Eigen::VectorXd::Constant(model.member_count(), linear::infinity);
  if (bounds) {
    most_elongation = bounds->elongation;
    for (int j = 0; j < model.uncertain_count(); ++j) {
      const auto& direction = model.uncertain[static_cast<std::size_t>(j)].direction;
      if (direction.size() == 1) most_motion(direction.front().degree) = bounds->motion(j);
    }
    big_m = 2 * bounds->motion;
  }
  if (question.big_m) {
    big_m.resize(model.uncertain_count());
    for (int j = 0; j < model.uncertain_count(); ++j) {
      big_m(j) = *question.big_m * model.direction_unit(j) / model.factor_unit;
    }
  }
  if (big_m.size() == 0) return std::nullopt;
  return problems::worst_case_program(model, alpha, big_m, most_motion, most_elongation);
}

}  // namespace

std::optional<ZeroOneWorst> zero_one_worst(engine::Campaign& campaign,
                                           const LimitQuestion& question, const LimitModel& model,
                                           double alpha, const RootResult& root,
                                           LoadFactor& load_factor) {
  const bool all = question.method == LimitMethod::all;
  zero_one::ZeroOneRootOptions root_options{
      .tighten = all || question.method == LimitMethod::tightened, .dive = false};
  if (all || question.method == LimitMethod::disjunctive) {
    root_options.cuts = zero_one::ZeroOneCuts::disjunctive;
  }
  const auto& known = *root.worst;
  auto mixed = worst_case_program(question, model, alpha, root);
  if (!mixed) return std::nullopt;
  ZeroOneWorst result;
  result.worst = known;
  if (all) {
    for (const StaticCut& cut : root.cuts) add_static_row(mixed->program, model, cut);
    result.cuts = root.cuts.size();
  }
  if (root_options.tighten) {
    root_options.start = problems::worst_case_point(model, known.collapse.motion);
  }
  auto prepared = zero_one::mixed_root(campaign, *mixed, root_options);
  const auto counts = prepared.root.counts;
  if (prepared.stopped) {
    result.lower = std::max(root.lower, prepared.root.bound);
    result.status = campaign.budget().why();
    result.programs = counts.programs;
    return result;
  }
  if (prepared.unbounded || prepared.root.status != linear::LinearStatus::optimal) {
    throw std::runtime_error("the relaxation of (29) was not solved");
  }
  result.cuts += counts.cuts;
  result.cut_programs = counts.cut_programs;
  const auto start = prepared.root.point;
  const auto answer =
      zero_one::search_tree(campaign, std::move(prepared), zero_one::ZeroOneBranching::paper, {},
                            {model.factor_unit, known.collapse.factor, root.lower});
  const auto found = engine::from_first_rank(campaign.transport(), [&] {
    Found known_here;
    known_here.lower = answer.bound();
    known_here.nodes = answer.outcome.opened();
    known_here.status = answer.outcome.status;
    known_here.programs = counts.programs + answer.outcome.tally().programs;
    const auto* const best = answer.point() != nullptr ? answer.point() : start ? &*start : nullptr;
    if (best != nullptr) {
      known_here.motion.assign(best->values.begin(), best->values.begin() + model.free_count());
    }
    return known_here;
  });
  result.lower = found.lower;
  result.nodes = found.nodes;
  result.programs = found.programs;
  result.status = found.status;
  if (found.motion.empty()) {
    if (found.status == engine::Status::solved) throw BigMTooSmall();
    return result;
  }
  const Eigen::Map<const Eigen::VectorXd> motion(found.motion.data(), model.free_count());
  const auto descent =
      descend(model, load_factor, alpha, worst_for(model, alpha, motion, known.zeta));
  if (descent.status == LoadStatus::collapses &&
      descent.worst.collapse.factor < known.collapse.factor) {
    result.worst = descent.worst;
  }
  if (all) result.lower = std::max(result.lower, root.lower);
  return result;
}

}  // namespace kusabi::limit
