// From the file to the report, on all ranks: the nominal load factor, the worst case at the root
// and in the tree of signs, its proof, samples and curves.
#include "run/limit/limit.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <boost/serialization/utility.hpp>
#include <fmt/format.h>

#include "nodes/limit/load_curve.hpp"
#include "nodes/limit/sign_tree.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/limit_analysis.hpp"
#include "problems/limit/limit_problem.hpp"
#include "run/evidence/limit_evidence.hpp"
#include "run/limit/limit_mixed.hpp"
#include "run/limit/limit_report.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/last_steps.hpp"
#include "run/output/output_file.hpp"
#include "run/output/outputs.hpp"
#include "run/output/result_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/session/shared_work.hpp"
#include "run/session/shown_search.hpp"
#include "run/session/told.hpp"
#include "verify/limit_proof.hpp"

namespace kusabi::run {
namespace {

using nodes::limit::ClosedNode;
using nodes::limit::Collapse;
using nodes::limit::CurvePoint;
using nodes::limit::LoadFactor;
using nodes::limit::LoadStatus;
using nodes::limit::RootResult;
using nodes::limit::RootStatus;
using nodes::limit::SignTree;
using nodes::limit::StaticCut;
using nodes::limit::StaticPricing;
using nodes::limit::Worst;
using problems::LimitModel;
using problems::LimitProblem;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Samples in one piece of work: some milliseconds.
constexpr std::uint64_t samples_a_piece = 16;

/// Factors on a curve that differ by less are one, relative to the nominal one (at least 1 in
/// scaled units): a mode's line is known to 1e-12 or so.
constexpr double curve_tolerance = 1e-9;

/// All that one run of the command knows, on each rank alike but for what only rank 0 is told.
class LimitRun {
 public:
  LimitRun(Session& session, const LimitOptions& options, const LimitProblem& problem)
      : session_(session),
        options_(options),
        problem_(problem),
        model_(limit_model(problem)),
        load_factor_(model_),
        pricing_(model_) {}

  LimitAnswer answer();

  /// The evidence of the worst case, if there is one; on rank 0.
  [[nodiscard]] const std::optional<verify::LimitCertificate>& certificate() const {
    return certificate_;
  }

 private:
  [[nodiscard]] LimitCollapse in_units(const Collapse& collapse) const;
  std::vector<StaticCut> price(const Eigen::VectorXd& z, std::span<const int> columns);
  void say_round(std::size_t columns);
  RootResult root(double alpha);
  LimitWorstCase worst_case();
  LimitWorstCase mixed_worst_case();
  void tree(RootResult& root, double alpha, LimitWorstCase& worst, std::vector<ClosedNode>& nodes);
  bool prove(const RootResult& root, const std::vector<ClosedNode>& nodes, LimitWorstCase& worst);
  std::vector<double> samples();
  std::vector<nodes::limit::CurvePiece> curve(const Eigen::VectorXd& zeta);
  std::vector<nodes::limit::CurvePiece> worst_curve();
  std::vector<nodes::limit::CurvePiece> in_units(std::vector<nodes::limit::CurvePiece> curve) const;

  Session& session_;
  const LimitOptions& options_;
  const LimitProblem& problem_;
  LimitModel model_;
  LoadFactor load_factor_;
  StaticPricing pricing_;
  Collapse nominal_;
  std::optional<verify::LimitCertificate> certificate_;
  std::chrono::steady_clock::time_point said_ = std::chrono::steady_clock::now();
};

LimitCollapse LimitRun::in_units(const Collapse& collapse) const {
  return {collapse.factor * model_.factor_unit,
          (collapse.forces + model_.shift) * model_.force_unit,
          collapse.motion * (model_.factor_unit / model_.force_unit)};
}

// The cuts do not hang on who makes them: see pricing_block.
std::vector<StaticCut> LimitRun::price(const Eigen::VectorXd& z, std::span<const int> columns) {
  using nodes::limit::pricing_block;
  say_round(columns.size());
  if (session_.ranks() == 1 || columns.size() <= pricing_block) {
    return price_alone(pricing_, z, columns);
  }
  pricing_.aim(z, columns.front());
  const auto blocks = (columns.size() + pricing_block - 1) / pricing_block;
  const auto block = [&](std::uint64_t number) {
    const auto first = number * pricing_block;
    return price_block(pricing_,
                       columns.subspan(first, std::min(pricing_block, columns.size() - first)));
  };
  std::vector<StaticCut> cuts;
  for (auto& some : share_work<std::vector<StaticCut>>(session_, blocks, block)) {
    std::move(some.begin(), some.end(), std::back_inserter(cuts));
  }
  return cuts;
}

// What a long root is doing, every other second.
void LimitRun::say_round(std::size_t columns) {
  const auto now = std::chrono::steady_clock::now();
  if (!session_.speaks() || options_.quiet || now - said_ < std::chrono::seconds(2)) return;
  said_ = now;
  tell("at the root: {} of {} uncertain components are looked at for cuts\n", columns,
       model_.uncertain_count());
}

RootResult LimitRun::root(double alpha) {
  load_factor_.restart();
  return solve_root(
      model_, alpha, nominal_, load_factor_,
      [this](const Eigen::VectorXd& z, std::span<const int> columns) { return price(z, columns); });
}

// The tree of signs below an open root. The evidence is on rank 0, the worst load on all.
void LimitRun::tree(RootResult& root, double alpha, LimitWorstCase& worst,
                    std::vector<ClosedNode>& nodes) {
  SignTree tree(model_, alpha, root, true);
  engine::Options search_options;
  search_options.goal = engine::Goal::best;
  const auto outcome =
      shown_search(session_, tree, search_options, options_.limits, options_.quiet);
  std::vector<SignTree::Solution> best;
  std::tie(best, worst.search) = told_by_first_rank(session_, [&] {
    worst.nodes = outcome.opened();
    for (const auto& rank : outcome.ranks) {
      const auto& [branched, closed, counts, evidence] = rank.tally;
      worst.tree_programs += counts.load_factors + counts.relaxations + counts.pricings;
      nodes.insert(nodes.end(), evidence.begin(), evidence.end());
    }
    std::ranges::sort(nodes, {}, &ClosedNode::signs);
    std::vector<SignTree::Solution> found;
    if (!outcome.solutions.empty()) found.push_back(outcome.solutions.front().solution);
    return std::pair(found, outcome.status);
  });
  if (!best.empty()) {
    const auto vector = [](const std::vector<double>& values) {
      return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(
          values.data(), static_cast<Eigen::Index>(values.size())));
    };
    const auto& found = best.front();
    root.worst =
        Worst{vector(found.zeta), {found.factor, vector(found.forces), vector(found.motion)}};
  }
}

// Both ends in exact arithmetic, on rank 0. @return whether both are shown, on all ranks
bool LimitRun::prove(const RootResult& root, const std::vector<ClosedNode>& nodes,
                     LimitWorstCase& worst) {
  const bool nodes_of_a_tree = root.status == RootStatus::open;
  const auto verdict = session_.on_first_rank([&]() -> std::string {
    certificate_ =
        limit_certificate(problem_, model_, *options_.alpha, *root.worst, root.cuts, nodes);
    const verify::LimitProof proof(*certificate_);
    const auto upper = proof.upper();
    if (const auto* value = std::get_if<mpq_class>(&upper)) {
      worst.upper = verify::rounded_up(*value);
    }
    worst.lower = -infinity;
    if (!proof.stable() || verify::flaw_of_sign_cover(*certificate_)) return "no";
    double least = infinity;
    for (const auto& node : certificate_->nodes) {
      const auto lower = proof.lower(node);
      const auto* value = std::get_if<mpq_class>(&lower);
      if (value == nullptr) return "no";
      least = std::min(least, verify::rounded_down(*value));
    }
    // What the nodes of a tree prove beyond the gap hangs on what was known when they were closed,
    // and so on the number of ranks.
    const double gap = 2 * nodes::limit::closed_gap * model_.factor_unit;
    worst.lower =
        nodes_of_a_tree ? std::min(least, worst.upper - gap) : std::min(least, worst.upper);
    return "yes";
  });
  return verdict == "yes";
}

LimitWorstCase LimitRun::worst_case() {
  const double alpha = *options_.alpha / model_.force_unit;
  LimitWorstCase worst;
  RootResult result = root(alpha);
  worst.status = result.status;
  worst.counts = result.counts;
  worst.cuts = result.cuts.size();
  worst.lower = worst.upper = -infinity;
  if (result.status == RootStatus::failed) {
    throw std::runtime_error("the simplex method failed on the relaxation of the worst case");
  }
  if (result.status == RootStatus::not_carried) {
    worst.zeta = result.overpowering_load * model_.force_unit;
    return worst;
  }
  std::vector<ClosedNode> nodes;
  if (result.status == RootStatus::closed) nodes.push_back(closed_node(result.proof, {}));
  if (result.status == RootStatus::open) {
    tree(result, alpha, worst, nodes);
    // Nodes that do not cover all signs prove nothing, but the root still does.
    if (worst.search != engine::Status::solved) nodes = {closed_node(result.proof, {})};
    worst.status = RootStatus::closed;
  }
  const bool proved = prove(result, nodes, worst);
  if (!proved && worst.status == RootStatus::closed) worst.status = RootStatus::open;
  worst.zeta = result.worst->zeta * model_.force_unit;
  worst.collapse = in_units(result.worst->collapse);
  return worst;
}

// By (29). The upper end is exact as well; the lower end is what the zero-one tree says.
LimitWorstCase LimitRun::mixed_worst_case() {
  const auto found = solve_mixed(session_, options_, model_, *options_.alpha / model_.force_unit,
                                 nominal_, load_factor_);
  LimitWorstCase worst;
  worst.status = RootStatus::closed;
  worst.zeta = found.worst.zeta * model_.force_unit;
  worst.collapse = in_units(found.worst.collapse);
  worst.cuts = found.cuts;
  worst.nodes = found.nodes;
  worst.tree_programs = found.programs;
  worst.counts.pricings = found.cut_programs;
  const auto evidence = limit_certificate(problem_, model_, *options_.alpha, found.worst, {}, {});
  const auto upper = verify::LimitProof(evidence).upper();
  const auto* value = std::get_if<mpq_class>(&upper);
  worst.upper = value == nullptr ? worst.collapse->factor : verify::rounded_up(*value);
  worst.lower = std::min(found.lower * model_.factor_unit, worst.upper);
  worst.proved = found.proved;
  worst.search = found.status;
  return worst;
}

// Loads with |zeta|_inf = alpha, each from a generator of its own: the same on any number of ranks.
std::vector<double> LimitRun::samples() {
  const double alpha = *options_.alpha / model_.force_unit;
  const auto piece = [&](std::uint64_t number) {
    std::vector<double> factors;
    const auto first = number * samples_a_piece;
    const auto last = std::min(first + samples_a_piece, options_.samples);
    for (auto sample = first; sample < last; ++sample) {
      std::seed_seq seed{options_.seed, sample};
      std::mt19937_64 bits(seed);
      Eigen::VectorXd zeta(model_.uncertain_count());
      // The standard fixes what mt19937_64 yields, not what its distributions make of it.
      for (double& each : zeta) each = 2 * (static_cast<double>(bits() >> 11U) * 0x1p-53) - 1;
      if (zeta.size() > 0) zeta *= alpha / zeta.cwiseAbs().maxCoeff();
      load_factor_.restart();
      const auto status = load_factor_.solve(dead_load(model_, zeta));
      factors.push_back(status == LoadStatus::collapses
                            ? load_factor_.collapse().factor * model_.factor_unit
                            : -infinity);
    }
    return factors;
  };
  std::vector<double> all;
  const auto pieces = (options_.samples + samples_a_piece - 1) / samples_a_piece;
  for (const auto& some : share_work<std::vector<double>>(session_, pieces, piece)) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::vector<nodes::limit::CurvePiece> LimitRun::in_units(
    std::vector<nodes::limit::CurvePiece> curve) const {
  for (auto& piece : curve) {
    piece.from.factor *= model_.factor_unit;
    piece.from.slope *= model_.factor_unit;
    piece.factor_at_end *= model_.factor_unit;
    piece.from.motion *= model_.factor_unit / model_.force_unit;
  }
  return curve;
}

// @param zeta in the unit of force
std::vector<nodes::limit::CurvePiece> LimitRun::curve(const Eigen::VectorXd& zeta) {
  const Eigen::VectorXd scaled = zeta / model_.force_unit;
  const Eigen::VectorXd change = dead_load(model_, scaled) - model_.dead;
  const auto solve = [&](double beta) -> std::optional<CurvePoint> {
    load_factor_.restart();
    if (load_factor_.solve(model_.dead + beta * change) != LoadStatus::collapses) return {};
    auto collapse = load_factor_.collapse();
    const double slope = -change.dot(collapse.motion);
    return CurvePoint{beta, collapse.factor, slope, std::move(collapse.motion)};
  };
  const double tolerance = curve_tolerance * std::max(1.0, std::abs(nominal_.factor));
  return in_units(nodes::limit::concave_curve(solve, 1, tolerance));
}

// lambda_min(beta alpha).
std::vector<nodes::limit::CurvePiece> LimitRun::worst_curve() {
  const double alpha = *options_.alpha / model_.force_unit;
  const auto solve = [&](double beta) -> std::optional<CurvePoint> {
    auto found = root(beta * alpha);
    if (found.status == RootStatus::open) {
      LimitWorstCase worst;
      std::vector<ClosedNode> nodes;
      tree(found, beta * alpha, worst, nodes);
    } else if (found.status != RootStatus::closed) {
      return {};
    }
    auto& [zeta, collapse] = *found.worst;
    double slope = 0;
    for (const auto& [degree, weight] : model_.uncertain) {
      slope -= alpha * weight * std::abs(collapse.motion(degree));
    }
    return CurvePoint{beta, collapse.factor, slope, std::move(collapse.motion)};
  };
  return in_units(nodes::limit::concave_curve(solve, 1, nodes::limit::closed_gap));
}

LimitAnswer LimitRun::answer() {
  LimitAnswer answer;
  answer.status = load_factor_.solve(model_.dead);
  if (answer.status == LoadStatus::undetermined) {
    throw std::runtime_error("the simplex method failed on the nominal load factor");
  }
  if (answer.status != LoadStatus::collapses) return answer;
  nominal_ = load_factor_.collapse();
  answer.nominal = in_units(nominal_);
  if (!options_.alpha) return answer;
  const bool by_static_cuts = options_.method == LimitMethod::static_cuts;
  answer.worst = by_static_cuts ? worst_case() : mixed_worst_case();
  if (options_.samples > 0) answer.samples = samples();
  if (options_.curve && answer.worst->collapse) {
    answer.curve = curve(answer.worst->zeta);
    answer.worst_curve = worst_curve();
  }
  return answer;
}

void announce(const LimitOptions& options, const LimitProblem& problem, int ranks) {
  tell(
      "kusabi {} · limit · {}\n"
      "{}: {}, {} nodes, {} members, {} free displacements; {}\n",
      KUSABI_VERSION, options.file, problem.name,
      problem.dimension == 2 ? "in the plane" : "in space", problem.node_names.size(),
      problem.member_count(), problem.free_count(),
      ranks == 1 ? "1 rank" : fmt::format("{} ranks", ranks));
}

}  // namespace

int limit(Session& session, const LimitOptions& options) {
  std::optional<ResultFile> result_file;
  std::optional<OutputFile> certificate_file;
  const std::string text = session.on_first_rank([&] {
    auto content = problems::file_text(options.file);
    check_outputs(options.file,
                  {{"--output", options.output}, {"--certificate", options.certificate}});
    result_file.emplace(options.output, options.file);
    certificate_file.emplace("--certificate", options.certificate, options.file);
    return content;
  });
  // Every rank works the problem out by itself: the same text gives the same bits everywhere.
  const auto problem = problems::limit_problem(problems::read_structure(text, options.file));
  session.agree(problem.fingerprint);
  if (session.speaks() && !options.quiet) announce(options, problem, session.ranks());
  LimitRun run(session, options, problem);
  const auto answer = run.answer();
  const bool open = answer.worst && (answer.worst->status == RootStatus::open ||
                                     answer.worst->status == RootStatus::unbounded ||
                                     answer.worst->search != engine::Status::solved);
  if (session.speaks()) {
    const LimitReport report{options, problem, answer, session.ranks()};
    do_all({[&] { result_file->write(report.json()); },
            [&] {
              if (!certificate_file->wanted() || !run.certificate()) return;
              certificate_file->stream() << limit_certificate_text(*run.certificate());
              certificate_file->put_in_place();
            },
            [&] {
              if (!options.quiet) print_answer(report.table());
            }});
    if (!options.quiet) tell_written({options.output, options.certificate});
  }
  return open ? stopped_early : solved;
}

}  // namespace kusabi::run
