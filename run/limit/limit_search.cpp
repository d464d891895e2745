// Every rank does the work at the root alike, but for the pricing of cuts, which is shared.
#include "run/limit/limit_search.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>
#include <fmt/format.h>

#include "engine/budget.hpp"
#include "engine/shared_work.hpp"
#include "engine/signals.hpp"
#include "engine/together.hpp"
#include "nodes/limit/balanced_model.hpp"
#include "nodes/limit/load_curve.hpp"
#include "nodes/limit/sign_tree.hpp"
#include "problems/limit/limit_analysis.hpp"
#include "run/evidence/verified_structure.hpp"
#include "run/limit/limit_ends.hpp"
#include "run/limit/limit_mixed.hpp"
#include "run/output/standard_output.hpp"
#include "run/session/shown_search.hpp"

namespace kusabi::run {
namespace {

using limit::ClosedNode;
using limit::Collapse;
using limit::CurvePiece;
using limit::CurvePoint;
using limit::LoadFactor;
using limit::LoadStatus;
using limit::RootResult;
using limit::RootStatus;
using limit::SignTree;
using limit::StaticCut;
using limit::StaticPricing;
using limit::Worst;
using problems::LimitModel;
using problems::LimitProblem;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Samples in one piece of work: some milliseconds.
constexpr std::uint64_t samples_a_piece = 16;

/// Factors on a curve that differ by less are one, relative to the nominal one (at least 1 in
/// scaled units): a mode's line is known to 1e-12 or so.
constexpr double curve_tolerance = 1e-9;

/// How often a worst case that collapses in another order of forces than the nominal load is
/// searched for again, in that one.
constexpr int most_balances = 3;

/// What rank 0 tells of a proof.
struct ShownEnds {
  double lower = -infinity;
  double upper = -infinity;
  bool lower_proved = false;
  bool upper_proved = false;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& lower& upper& lower_proved& upper_proved;
  }
};

/// A model and what solves its programs; all are made anew when the model is scaled anew.
struct Solvers {
  LimitModel model;
  LoadFactor load_factor;
  StaticPricing pricing;
  Collapse nominal;

  Solvers(LimitModel of, const support::Stop& stop)
      : model(std::move(of)), load_factor(model, stop), pricing(model, stop) {}
};

class LimitSearch {
 public:
  LimitSearch(Session& session, const LimitOptions& options, const problems::Structure& truss,
              const LimitProblem& problem)
      : session_(session),
        options_(options),
        truss_(verified_structure(truss)),
        problem_(problem),
        budget_(options.limits, engine::asked_by_signal) {
    engine::heed_signals();
  }

  LimitFindings findings();

 private:
  [[nodiscard]] const LimitModel& model() const { return solvers_->model; }
  [[nodiscard]] double scaled_alpha() const { return *options_.alpha / model().force_unit; }
  [[nodiscard]] LimitCollapse in_units(const Collapse& collapse, const Eigen::VectorXd& dead);

  bool ended();
  support::Stop lockstep_stop();
  LoadStatus set_up(LimitModel model);
  void nominal(LimitAnswer& answer);
  void settle_for(double alpha);
  std::vector<StaticCut> price(const Eigen::VectorXd& z, std::span<const int> columns);
  void say(const std::string& what);
  RootResult root(double alpha);
  RootResult balanced_root();
  void tree(RootResult& root, double alpha, LimitWorstCase& worst, std::vector<ClosedNode>& nodes);
  void prove(const RootResult& root, std::vector<ClosedNode> nodes, LimitWorstCase& worst);
  void conclude(RootResult& root, LimitWorstCase& worst);
  LimitWorstCase worst_case();
  LimitWorstCase mixed_worst_case();
  std::vector<double> samples();
  std::vector<CurvePiece> curve(const Eigen::VectorXd& zeta);
  std::vector<CurvePiece> worst_curve();
  std::vector<CurvePiece> in_units(std::vector<CurvePiece> curve) const;

  Session& session_;
  const LimitOptions& options_;
  verify::Structure truss_;
  const LimitProblem& problem_;
  engine::Budget budget_;
  bool ended_ = false;    // all ranks have agreed to end
  bool sharing_ = false;  // each rank does something else just now
  std::unique_ptr<Solvers> solvers_;
  std::optional<verify::LimitCertificate> certificate_;
  std::chrono::steady_clock::time_point said_ = std::chrono::steady_clock::now();
};

// ---- together ----------------------------------------------------------------------------------

// Every rank must make this call, and all get the same answer.
bool LimitSearch::ended() {
  if (!ended_) ended_ = engine::from_first_rank(session_.transport(), budget_.stop());
  return ended_;
}

support::Stop LimitSearch::lockstep_stop() {
  return [this] { return sharing_ ? budget_.spent() : ended(); };
}

// What a long root is doing, every other second.
void LimitSearch::say(const std::string& what) {
  const auto now = std::chrono::steady_clock::now();
  if (!session_.speaks() || options_.quiet || now - said_ < std::chrono::seconds(2)) return;
  said_ = now;
  tell("at the root: {}\n", what);
}

// ---- the root ----------------------------------------------------------------------------------

LoadStatus LimitSearch::set_up(LimitModel model) {
  solvers_ = std::make_unique<Solvers>(std::move(model), lockstep_stop());
  const auto status = solvers_->load_factor.solve(solvers_->model.dead);
  if (status == LoadStatus::collapses) solvers_->nominal = solvers_->load_factor.collapse();
  return status;
}

LimitCollapse LimitSearch::in_units(const Collapse& collapse, const Eigen::VectorXd& dead) {
  auto least = solvers_->load_factor.least_factor(dead);
  if (least) {
    // Zero, which is carried where there is no load, to the last bit.
    if (std::abs(*least) <= limit::closed_gap) *least = 0;
    *least *= model().factor_unit;
  }
  return {collapse.factor * model().factor_unit, least,
          problems::forces_in_units(model(), collapse.forces),
          problems::motion_in_units(model(), collapse.motion)};
}

// The cuts do not depend on who makes them: see pricing_block.
std::vector<StaticCut> LimitSearch::price(const Eigen::VectorXd& z, std::span<const int> columns) {
  using limit::pricing_block;
  auto& pricing = solvers_->pricing;
  say(fmt::format("{} of {} uncertain components are looked at for cuts", columns.size(),
                  model().uncertain_count()));
  if (session_.ranks() == 1 || columns.size() <= pricing_block) {
    return price_alone(pricing, z, columns);
  }
  pricing.aim(z, columns.front());
  const auto blocks = (columns.size() + pricing_block - 1) / pricing_block;
  const auto block = [&](std::uint64_t number) {
    const auto first = number * pricing_block;
    return price_block(pricing,
                       columns.subspan(first, std::min(pricing_block, columns.size() - first)));
  };
  sharing_ = true;
  auto shared = engine::share_work<std::vector<StaticCut>>(session_.transport(), blocks, block);
  sharing_ = false;
  std::vector<StaticCut> cuts;
  for (auto& some : shared) std::move(some.begin(), some.end(), std::back_inserter(cuts));
  return cuts;
}

RootResult LimitSearch::root(double alpha) {
  solvers_->load_factor.restart();
  const double unit = model().factor_unit;
  return solve_root(
      model(), alpha, solvers_->nominal, solvers_->load_factor,
      [this](const Eigen::VectorXd& z, std::span<const int> columns) { return price(z, columns); },
      {.stop = lockstep_stop(), .watcher = [&](std::uint64_t round, double lower, double upper) {
         say(fmt::format("round {}, load factor {:.6g} ... {:.6g}", round, lower * unit,
                         upper * unit));
       }});
}

// Loads that are large against the nominal ones may break what those never touch.
RootResult LimitSearch::balanced_root() {
  RootResult result = root(scaled_alpha());
  for (int time = 0; time < most_balances; ++time) {
    const bool doubtful = result.status == RootStatus::open ||
                          result.status == RootStatus::unbounded ||
                          result.status == RootStatus::failed;
    if (!doubtful || !result.worst) break;
    const double size = limit::dissipation(problem_, model(), result.worst->collapse.motion);
    if (!limit::is_out_of_balance(size)) break;
    if (set_up(limit::rebalanced(problem_, model(), size, *options_.alpha)) !=
        LoadStatus::collapses)
      break;
    result = root(scaled_alpha());
  }
  return result;
}

// ---- below it ----------------------------------------------------------------------------------

// The tree of signs below an open root. The evidence is on rank 0, the worst load on all.
void LimitSearch::tree(RootResult& root, double alpha, LimitWorstCase& worst,
                       std::vector<ClosedNode>& nodes) {
  SignTree tree(model(), alpha, root, true, budget_.stop());
  engine::Options search_options;
  search_options.goal = engine::Goal::best;
  const ShownObjective shown{model().factor_unit, root.worst->collapse.factor, root.lower};
  const auto outcome =
      shown_search(session_, tree, search_options, budget_.left(), options_.quiet, shown);
  std::vector<SignTree::Solution> best;
  std::tie(best, worst.search) = engine::from_first_rank(session_.transport(), [&] {
    worst.nodes = outcome.opened();
    for (const auto& rank : outcome.ranks) {
      const auto& tally = rank.tally;
      worst.tree_programs +=
          tally.counts.load_factors + tally.counts.relaxations + tally.counts.pricings;
      nodes.insert(nodes.end(), tally.evidence.begin(), tally.evidence.end());
    }
    std::ranges::sort(nodes, {}, &ClosedNode::signs);
    std::vector<SignTree::Solution> found;
    if (!outcome.solutions.empty()) found.push_back(outcome.solutions.front().solution);
    return std::pair(found, outcome.status);
  });
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

// Both ends in exact arithmetic, on rank 0; all are told what has come of it.
void LimitSearch::prove(const RootResult& root, std::vector<ClosedNode> nodes,
                        LimitWorstCase& worst) {
  const double unit = model().factor_unit;
  const bool of_a_tree = nodes.size() > 1;
  const auto shown = engine::from_first_rank(session_.transport(), [&] {
    const bool again = worst.search == engine::Status::solved;
    const bool any = again || !nodes.front().forces.empty();  // else only the upper end is left
    auto ends = proved_ends({truss_, problem_, model(), *options_.alpha, *root.worst,
                             any ? root.cuts : std::vector<StaticCut>(), std::move(nodes)},
                            again);
    const double upper = ends.upper.value_or(root.worst->collapse.factor * unit);
    // What the nodes of a tree prove beyond the gap depends on what was known when they were
    // closed, and so on the number of ranks.
    const double most = of_a_tree ? upper - 2 * limit::closed_gap * unit : upper;
    const double lower = std::min(ends.lower.value_or(root.lower * unit), most);
    if (ends.lower && ends.upper) certificate_ = std::move(ends.certificate);
    return ShownEnds{lower, upper, ends.lower.has_value(), ends.upper.has_value()};
  });
  worst.lower = shown.lower;
  worst.upper = shown.upper;
  worst.lower_proved = shown.lower_proved;
  worst.upper_proved = shown.upper_proved;
  const bool near = worst.upper - worst.lower <= answered_gap * unit;
  worst.status = near ? RootStatus::closed : RootStatus::open;
  worst.proved = near && worst.lower_proved && worst.upper_proved;
}

// From the root on: the tree, if it is open, and the proof.
void LimitSearch::conclude(RootResult& root, LimitWorstCase& worst) {
  std::vector<ClosedNode> nodes;
  if (root.status == RootStatus::open || root.status == RootStatus::unbounded) {
    tree(root, scaled_alpha(), worst, nodes);
    // Nodes that do not cover all signs prove nothing, but the root still does.
    if (worst.search != engine::Status::solved) nodes.clear();
  }
  if (root.status == RootStatus::stopped) worst.search = budget_.why();
  if (root.status == RootStatus::not_carried) {
    worst.status = RootStatus::not_carried;
    worst.zeta = root.overpowering_load * model().force_unit;
    worst.proved = worst.upper_proved = shows_no_factor(
        truss_, problem_, model(), root.overpowering_load, root.overpowering_motion);
    return;
  }
  if (!root.worst) {
    // The nominal load is one of the admissible ones.
    root.worst = Worst{Eigen::VectorXd::Zero(model().uncertain_count()), solvers_->nominal};
  }
  if (nodes.empty()) {
    root.proof.signs.resize(model().uncertain.size());
    nodes.push_back(closed_node(root.proof, {}));
  }
  prove(root, std::move(nodes), worst);
  worst.zeta = root.worst->zeta * model().force_unit;
  worst.collapse = in_units(root.worst->collapse, dead_load(model(), root.worst->zeta));
}

LimitWorstCase LimitSearch::worst_case() {
  for (;;) {
    LimitWorstCase worst;
    RootResult result = balanced_root();
    worst.counts = result.counts;
    worst.cuts = result.cuts.size();
    conclude(result, worst);
    if (worst.proved || worst.search != engine::Status::solved) return worst;
    auto model_with_more = limit::with_more_yield(problem_, model());
    if (!model_with_more) return worst;
    if (set_up(*std::move(model_with_more)) != LoadStatus::collapses) return worst;
  }
}

// By (29), and then the ends by the same evidence as without it: what a 0-1 tree finds in floating
// point, with an M that is thought to be large enough, proves nothing.
LimitWorstCase LimitSearch::mixed_worst_case() {
  LimitWorstCase worst;
  RootResult result = balanced_root();
  const bool usable = result.worst && result.status != RootStatus::not_carried &&
                      result.status != RootStatus::stopped;
  if (!usable) {
    conclude(result, worst);
    return worst;
  }
  const auto found = solve_mixed(session_, options_, model(), scaled_alpha(), result,
                                 solvers_->load_factor, budget_);
  if (!found) {
    if (session_.speaks() && !options_.quiet) {
      tell(
          "--cuts: no safe M was found, and (29) was not tried; the ends are those of static "
          "cuts\n");
    }
    conclude(result, worst);
    return worst;
  }
  if (found->worst.collapse.factor < result.worst->collapse.factor) result.worst = found->worst;
  if (found->status == engine::Status::solved) {
    conclude(result, worst);
  } else {
    worst.search = found->status;
    result.status = RootStatus::closed;  // no tree of signs: there is no time left
    conclude(result, worst);
  }
  worst.zero_one_bound = std::min(found->lower * model().factor_unit, worst.upper);
  worst.cuts = found->cuts;
  worst.nodes = found->nodes;
  worst.tree_programs += found->programs;
  worst.counts.pricings = found->cut_programs;
  return worst;
}

// ---- what else is asked for --------------------------------------------------------------------

// Loads with |zeta|_inf = alpha, each from a generator of its own: the same on any number of ranks.
std::vector<double> LimitSearch::samples() {
  const double alpha = scaled_alpha();
  LoadFactor load_factor(model(), [this] { return budget_.spent(); });
  load_factor.solve(model().dead);
  const auto piece = [&](std::uint64_t number) {
    std::vector<double> factors;
    const auto first = number * samples_a_piece;
    const auto last = std::min(first + samples_a_piece, options_.samples);
    for (auto sample = first; sample < last && !budget_.spent(); ++sample) {
      std::seed_seq seed{options_.seed, sample};
      std::mt19937_64 bits(seed);
      Eigen::VectorXd zeta(model().uncertain_count());
      // The standard fixes what mt19937_64 yields, not what its distributions make of it.
      for (double& each : zeta) each = 2 * (static_cast<double>(bits() >> 11U) * 0x1p-53) - 1;
      if (zeta.size() > 0) zeta *= alpha / zeta.cwiseAbs().maxCoeff();
      load_factor.restart();
      const auto status = load_factor.solve(dead_load(model(), zeta));
      if (status == LoadStatus::undetermined) continue;
      factors.push_back(status == LoadStatus::collapses
                            ? load_factor.collapse().factor * model().factor_unit
                            : -infinity);
    }
    return factors;
  };
  std::vector<double> all;
  const auto pieces = (options_.samples + samples_a_piece - 1) / samples_a_piece;
  for (const auto& some :
       engine::share_work<std::vector<double>>(session_.transport(), pieces, piece)) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::vector<CurvePiece> LimitSearch::in_units(std::vector<CurvePiece> curve) const {
  for (auto& piece : curve) {
    piece.from.factor *= model().factor_unit;
    piece.from.slope *= model().factor_unit;
    piece.factor_at_end *= model().factor_unit;
    piece.from.motion = problems::motion_in_units(model(), piece.from.motion);
  }
  return curve;
}

// @param zeta in the unit of force
std::vector<CurvePiece> LimitSearch::curve(const Eigen::VectorXd& zeta) {
  const Eigen::VectorXd scaled = zeta / model().force_unit;
  const Eigen::VectorXd change = dead_load(model(), scaled) - model().dead;
  auto& load_factor = solvers_->load_factor;
  const auto solve = [&](double beta) -> std::optional<CurvePoint> {
    load_factor.restart();
    if (load_factor.solve(model().dead + beta * change) != LoadStatus::collapses) return {};
    auto collapse = load_factor.collapse();
    const double slope = -change.dot(collapse.motion);
    return CurvePoint{beta, collapse.factor, slope, std::move(collapse.motion)};
  };
  const double tolerance = curve_tolerance * std::max(1.0, std::abs(solvers_->nominal.factor));
  return in_units(limit::concave_curve(solve, 1, tolerance));
}

// lambda_min(beta alpha).
std::vector<CurvePiece> LimitSearch::worst_curve() {
  const double alpha = scaled_alpha();
  const auto solve = [&](double beta) -> std::optional<CurvePoint> {
    auto found = root(beta * alpha);
    if (found.status == RootStatus::open) {
      LimitWorstCase worst;
      std::vector<ClosedNode> nodes;
      tree(found, beta * alpha, worst, nodes);
      if (worst.search != engine::Status::solved) return {};
    } else if (found.status != RootStatus::closed) {
      return {};
    }
    if (found.status == RootStatus::not_carried) return {};
    auto& [zeta, collapse] = *found.worst;
    double slope = 0;
    for (const auto& [degree, weight] : model().uncertain) {
      slope -= alpha * weight * std::abs(collapse.motion(degree));
    }
    return CurvePoint{beta, collapse.factor, slope, std::move(collapse.motion)};
  };
  return in_units(limit::concave_curve(solve, 1, limit::closed_gap));
}

// The nominal load factor, in units that make it sure.
void LimitSearch::nominal(LimitAnswer& answer) {
  const auto shown = [&] {
    return shows_no_factor(truss_, problem_, model(),
                           Eigen::VectorXd::Zero(model().uncertain_count()),
                           solvers_->load_factor.overpowering_motion());
  };
  answer.status = set_up(limit_model(problem_));
  if (ended()) return;
  if (answer.status == LoadStatus::collapses) {
    const double size = limit::dissipation(problem_, model(), solvers_->nominal.motion);
    if (!limit::is_out_of_balance(size)) return;
  } else if (answer.status == LoadStatus::not_carried && shown()) {
    answer.no_factor_proved = true;
    return;
  }
  answer.status = set_up(limit::balanced_model(problem_, 0));
  answer.no_factor_proved = answer.status == LoadStatus::not_carried && shown();
}

// Units that are not far below the loads, if the simplex method can do with them.
void LimitSearch::settle_for(double alpha) {
  double load = 0;
  for (const auto& [degree, weight] : problem_.uncertain) load = std::max(load, alpha * weight);
  const double before = model().force_unit;
  constexpr double far = 0x1p6;
  if (load <= far * before) return;
  if (set_up(limit_model(problem_, load)) != LoadStatus::collapses) {
    set_up(limit_model(problem_, before));
  }
}

LimitFindings LimitSearch::findings() {
  LimitAnswer answer;
  nominal(answer);
  if (answer.status != LoadStatus::collapses) {
    if (answer.status == LoadStatus::undetermined && ended()) answer.rest = budget_.why();
    return {answer, {}};
  }
  answer.nominal = in_units(solvers_->nominal, model().dead);
  if (!options_.alpha) return {answer, {}};
  settle_for(*options_.alpha);
  const bool by_static_cuts = options_.method == LimitMethod::static_cuts;
  answer.worst = by_static_cuts ? worst_case() : mixed_worst_case();
  if (options_.samples > 0) {
    if (!ended()) answer.samples = samples();
    if (ended()) answer.rest = budget_.why();
  }
  if (options_.curve && answer.worst->collapse) {
    if (!ended()) {
      answer.curve = curve(answer.worst->zeta);
      answer.worst_curve = worst_curve();
    }
    if (ended()) answer.rest = budget_.why();
  }
  return {std::move(answer), std::move(certificate_)};
}

}  // namespace

bool LimitAnswer::whole() const {
  if (status == LoadStatus::undetermined || rest != engine::Status::solved) return false;
  if (status == LoadStatus::not_carried) return no_factor_proved;
  return !worst || (worst->proved && worst->search == engine::Status::solved);
}

LimitFindings limit_search(Session& session, const LimitOptions& options,
                           const problems::Structure& truss, const LimitProblem& problem) {
  return LimitSearch(session, options, truss, problem).findings();
}

}  // namespace kusabi::run
