// Program (29) from the model, its root and tree, and the motion of its best point.
#include "nodes/limit/search/zero_one_worst.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/collectives.hpp"
#include "nodes/limit/root/motion_bounds.hpp"
#include "nodes/zero_one/mixed_search.hpp"
#include "problems/limit/mixed_limit.hpp"

namespace kusabi::limit {
namespace {

using problems::LimitModel;
using zero_one::ZeroOneRootOptions;

// Results on rank 0, for broadcast.
struct Found {
  std::vector<double> motion;
  double lower = 0;
  double upper = linear::infinity;
  std::uint64_t nodes = 0;
  std::uint64_t programs = 0;
  engine::Status status = engine::Status::solved;
  bool infeasible = false;  // the program is proved to have no point

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& motion& lower& upper& nodes& programs& status& infeasible;
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

// (29) with the given M or a safe one; nothing if none is found.
std::optional<linear::MixedProgram> bounded_program(const LimitParameters& parameters,
                                                    const LimitModel& model, double alpha,
                                                    const RootResult& root) {
  const auto bounds = motion_bounds(model, alpha, root.cuts, root.worst->collapse.factor);
  Eigen::VectorXd big_m;
  Eigen::VectorXd max_motion = Eigen::VectorXd::Constant(model.free_count(), linear::infinity);
  Eigen::VectorXd max_elongation =
      Eigen::VectorXd::Constant(model.member_count(), linear::infinity);
  if (bounds) {
    max_elongation = bounds->elongation;
    for (int j = 0; j < model.uncertain_count(); ++j) {
      const auto& direction = model.uncertain[static_cast<std::size_t>(j)].direction;
      if (direction.size() == 1) max_motion(direction.front().degree) = bounds->motion(j);
    }
    big_m = 2 * bounds->motion;
  }
  if (parameters.big_m) big_m = *parameters.big_m * model.direction_unit / model.factor_unit;
  if (big_m.size() == 0) return std::nullopt;
  return problems::worst_case_program(model, alpha, big_m, max_motion, max_elongation);
}

// (27) as printed: u and gamma are bounded by the rows only, which imply z >= 0.
linear::MixedProgram printed_program(const LimitModel& model, double alpha, double big_m) {
  const auto none = [](int count) { return Eigen::VectorXd::Constant(count, linear::infinity); };
  // There M is for gamma_j = |t_j'u|, which is weight_j |d_j'u|.
  Eigen::VectorXd of_directions(model.uncertain_count());
  for (int j = 0; j < model.uncertain_count(); ++j) {
    const double weight = model.uncertain[static_cast<std::size_t>(j)].weight;
    of_directions(j) = weight == 0 ? big_m : big_m / weight;
  }
  auto mixed = problems::worst_case_program(model, alpha, of_directions, none(model.free_count()),
                                            none(model.member_count()));
  const int first = model.free_count() + model.member_count();
  for (int gamma = first; gamma < first + model.uncertain_count(); ++gamma) {
    mixed.program.columns[static_cast<std::size_t>(gamma)].lower = -linear::infinity;
  }
  return mixed;
}

zero_one::ZeroOneCuts cuts_of(LimitMethod method) {
  return method == LimitMethod::all || method == LimitMethod::disjunctive
             ? zero_one::ZeroOneCuts::disjunctive
             : zero_one::ZeroOneCuts::none;
}

// The point of a known collapse, with v^U unchanged.
void start_from(const LimitModel& model, const std::optional<ZeroOneStart>& start,
                ZeroOneRootOptions& options) {
  if (!start) return;
  const Eigen::VectorXd motion = start->motion.cwiseQuotient(model.displacement_unit);
  options.incumbent = zero_one::ZeroOnePoint{start->factor / model.factor_unit,
                                             problems::worst_case_point(model, motion)};
}

void note_root(const zero_one::ZeroOneRoot& root, double unit, LimitZeroOne& found) {
  const auto& counts = root.counts;
  found.first_bound = counts.first_bound * unit;
  found.last_bound = counts.last_bound * unit;
  found.cut_rounds = counts.cut_rounds;
  found.cut_programs = counts.cut_programs;
  found.cuts = counts.cuts;
  found.root_programs = counts.programs - counts.cut_programs;
}

// Result of the root and the tree of (29). With a derived M there are points, so a stopped search
// without one proves nothing.
ZeroOneWorst search(engine::Analysis& analysis, const LimitModel& model,
                    const linear::MixedProgram& mixed, const ZeroOneRootOptions& options,
                    const LimitParameters& parameters, const engine::ShownObjective& shown) {
  const bool m_is_given = parameters.big_m.has_value();
  ZeroOneWorst result;
  if (options.incumbent) {
    const auto& [objective, values, proved] = *options.incumbent;
    result.found.upper = objective * model.factor_unit;
    result.motion = Eigen::Map<const Eigen::VectorXd>(
        values.data(), static_cast<Eigen::Index>(model.free_count()));
  }
  auto prepared = zero_one::mixed_root(analysis, mixed, options);
  note_root(prepared.root, model.factor_unit, result.found);
  if (prepared.stopped) {
    result.found.lower = prepared.root.bound * model.factor_unit;
    result.status = analysis.budget().stop_reason();
    return result;
  }
  if (m_is_given && prepared.root.status == linear::LinearStatus::infeasible &&
      prepared.root.relaxation.contradiction()) {
    throw BigMTooSmall();
  }
  if (prepared.unbounded || prepared.root.status != linear::LinearStatus::optimal) return result;
  const auto point = prepared.root.point;
  const auto answer = zero_one::search_tree(analysis, std::move(prepared),
                                            zero_one::ZeroOneBranching::paper, {}, shown);
  const auto found = engine::from_first_rank(analysis.transport(), [&] {
    Found known;
    known.lower = answer.bound();
    known.nodes = answer.outcome.opened();
    known.status = answer.outcome.status;
    known.programs = answer.outcome.tally().programs;
    known.infeasible = answer.status() == zero_one::MixedStatus::infeasible;
    const auto* const best = answer.point() != nullptr ? answer.point() : point ? &*point : nullptr;
    if (best != nullptr) {
      known.upper = best->objective;
      known.motion.assign(best->values.begin(), best->values.begin() + model.free_count());
    }
    return known;
  });
  result.found.lower = found.lower * model.factor_unit;
  result.found.upper = found.upper * model.factor_unit;
  result.found.nodes = found.nodes;
  result.found.programs = found.programs;
  result.status = found.status;
  if (m_is_given && found.infeasible) throw BigMTooSmall();
  if (found.motion.empty()) return result;
  result.motion = Eigen::Map<const Eigen::VectorXd>(found.motion.data(),
                                                    static_cast<Eigen::Index>(found.motion.size()));
  return result;
}

}  // namespace

ZeroOneWorst printed_worst(engine::Analysis& analysis, const LimitParameters& parameters,
                           const problems::LimitProblem& problem,
                           const std::optional<ZeroOneStart>& start) {
  const auto model = problems::unscaled_model(problem);
  ZeroOneRootOptions options{
      .cuts = cuts_of(parameters.method), .tighten = false, .dive = false, .as_printed = true};
  start_from(model, start, options);
  auto result =
      search(analysis, model, printed_program(model, *parameters.alpha, *parameters.big_m), options,
             parameters, {});
  result.found.big_m = parameters.big_m;
  if (start) result.found.start = start->factor;
  return result;
}

std::optional<ZeroOneWorst> zero_one_worst(engine::Analysis& analysis,
                                           const LimitParameters& parameters,
                                           const LimitModel& model, double alpha,
                                           const RootResult& root,
                                           const std::optional<ZeroOneStart>& start) {
  const bool all = parameters.method == LimitMethod::all;
  auto mixed = bounded_program(parameters, model, alpha, root);
  if (!mixed) return std::nullopt;
  ZeroOneRootOptions options{.cuts = cuts_of(parameters.method),
                             .tighten = all || parameters.method == LimitMethod::tightened,
                             .dive = false};
  const auto& known = root.worst->collapse;
  if (all) {
    for (const StaticCut& cut : root.cuts) add_static_row(mixed->program, model, cut);
  }
  if (options.tighten) {
    options.start = problems::worst_case_point(model, known.motion);
    options.incumbent = zero_one::ZeroOnePoint{known.factor, options.start};
  }
  if (parameters.of_the_paper()) start_from(model, start, options);
  auto result = search(analysis, model, *mixed, options, parameters,
                       {model.factor_unit, known.factor, root.lower});
  result.found.big_m = parameters.big_m;
  if (start && parameters.of_the_paper()) result.found.start = start->factor;
  return result;
}

}  // namespace kusabi::limit
