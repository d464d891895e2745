// One tree of sign patterns an end, or several if an end has to move.
#include "nodes/wedged/critical_ends.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/together.hpp"
#include "nodes/wedged/candidate_friction.hpp"
#include "nodes/wedged/critical_friction.hpp"
#include "nodes/wedged/evidence_check.hpp"
#include "nodes/wedged/maximal_cones.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/preparation.hpp"
#include "problems/wedged/scale_ratio.hpp"

namespace kusabi::wedged {
namespace {

/// An end moves outwards by the width first, and eight times as far each time.
constexpr int most_moves = 7;
constexpr double growth = 8;

/// A bracket counts as wider than asked for from this many widths on: a coefficient that is itself
/// a multiple of the width has a neighbour on either side.
constexpr double wide = 2.5;

/// What lives at one coefficient.
struct Decided {
  engine::Status status = engine::Status::solved;
  std::vector<Configuration> leaves;  ///< maximal cones and open leaves
  std::uint64_t alive = 0;            ///< leaves that live by the verifier's test
  std::uint64_t unproved = 0;         ///< closed nodes of which it proves nothing

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& leaves& alive& unproved;
  }

  [[nodiscard]] bool solved() const { return status == engine::Status::solved; }
  [[nodiscard]] std::uint64_t count(LeafState state) const {
    return static_cast<std::uint64_t>(std::count_if(
        leaves.begin(), leaves.end(), [&](const auto& leaf) { return leaf.state == state; }));
  }
  [[nodiscard]] bool lives() const { return count(LeafState::alive) + count(LeafState::flat) != 0; }
  [[nodiscard]] bool is_proved_alive() const { return alive != 0; }
  [[nodiscard]] bool is_proved_dead() const { return leaves.empty() && unproved == 0; }
};

class Ends {
 public:
  Ends(engine::Campaign& campaign, const problems::Structure& structure,
       const problems::WedgedProblem& problem, const EndsQuestion& question,
       const EndRecorder& recorder)
      : campaign_(campaign),
        problem_(problem),
        question_(question),
        recorder_(recorder),
        stiffness_(enclosed_stiffness(structure)),
        scale_ratio_(problems::scale_ratio(structure, problem)) {}

  /// Whether the search may be wrong by more than an end can be moved, and all can be put to the
  /// verifier's test.
  [[nodiscard]] bool is_to_bisect() const {
    return scale_ratio_ > wide_scales && problem_.motions.cols() > 0 &&
           std::holds_alternative<verify::EnclosedProblem>(stiffness_);
  }
  void bisect(CriticalFindings& findings);
  void prove_lower(CriticalFindings& findings);
  void prove_upper(CriticalFindings& findings);
  void note_what_is_open(CriticalFindings& findings) const;

 private:
  /// All sign patterns at one coefficient; what that takes is added to the costs.
  /// @param wanted whether what was found is worth a record
  template <class Wanted>
  Decided decide(CriticalEnd end, double factor, const EndRecorder& recorder, Wanted wanted,
                 std::vector<CriticalCost>& costs);
  void take_patterns(const Decided& decided, CriticalFindings& findings) const;

  engine::Campaign& campaign_;
  const problems::WedgedProblem& problem_;
  const EndsQuestion& question_;
  const EndRecorder& recorder_;
  /// Or why the ends cannot be put to the verifier's test.
  std::variant<verify::EnclosedProblem, std::string> stiffness_;
  double scale_ratio_;
};

template <class Wanted>
Decided Ends::decide(CriticalEnd end, double factor, const EndRecorder& recorder, Wanted wanted,
                     std::vector<CriticalCost>& costs) {
  const auto friction = candidate_friction(problem_, factor);
  SignPatternOptions options{.tolerances = CriticalFriction::tolerances,
                             .tightening = question_.tightening,
                             .thorough = true};
  if (is_to_bisect()) options.tolerances.resolution = finest;
  SignPatternTree tree(problem_, friction, options);
  const auto prepared = prepare(campaign_, problem_, friction, options);
  inform(tree, prepared);
  const auto bounds = proved_bounds(prepared);
  const auto record = recorder ? recorder(end, factor, friction) : nullptr;
  std::optional<EvidenceCheck> check;
  if (const auto* const stiffness = std::get_if<verify::EnclosedProblem>(&stiffness_)) {
    check.emplace(problem_, *stiffness, friction, bounds,
                  is_to_bisect() ? FarMotion::counted : FarMotion::left_out);
    tree.judge_by([&check](const auto& evidence) { return check->holds(evidence); },
                  is_to_bisect());
  }
  if (record) tree.report_to([&record](const auto& evidence) { record->add(evidence); });
  // A record is of one run.
  auto outcome = record ? campaign_.search_anew(tree, {}) : campaign_.search(tree, {});
  const bool lower = end == CriticalEnd::lower;
  costs.push_back({lower ? CriticalPhase::lower_end : CriticalPhase::upper_end, factor,
                   outcome.opened(), outcome.opened()});
  auto decided = engine::from_first_rank(campaign_.transport(), [&] {
    std::vector<Configuration> leaves;
    for (auto& found : outcome.solutions) leaves.push_back(std::move(found.solution));
    const auto judged = outcome.tally();
    return Decided{.status = outcome.status,
                   .leaves = maximal_cones(std::move(leaves)),
                   .alive = judged.proved,
                   .unproved = judged.doubted + judged.unproved};
  });
  if (record) record->end(bounds, decided.solved() && wanted(decided));
  return decided;
}

constexpr auto proved_dead = [](const Decided& decided) { return decided.is_proved_dead(); };
constexpr auto all_dead = [](const Decided& decided) { return decided.leaves.empty(); };
constexpr auto lives = [](const Decided& decided) { return decided.lives(); };

// The verifier's test alone says where something lives: what lives at a coefficient lives above it.
// The search's own ends are asked first.
void Ends::bisect(CriticalFindings& findings) {
  double dead = 0;
  double not_dead = std::numeric_limits<double>::infinity();
  std::optional<double> alive;
  const auto ask = [&](double factor) {
    const auto decided = decide(CriticalEnd::lower, factor, {}, proved_dead, findings.costs);
    findings.status = decided.status;
    if (!decided.solved()) return;
    (decided.is_proved_dead() ? dead : not_dead) = factor;
    if (decided.is_proved_alive()) alive = factor;
  };
  const double least = CriticalFriction::range(problem_).least;
  for (const double end : {findings.lower, findings.upper.value_or(question_.most), question_.most})
    if (end > std::max(dead, least) && end < not_dead && findings.status == engine::Status::solved)
      ask(end);
  while (findings.status == engine::Status::solved && std::isfinite(not_dead) &&
         not_dead - dead > question_.width && std::midpoint(dead, not_dead) > least)
    ask(std::midpoint(dead, not_dead));
  findings.lower = dead;
  findings.lower_proved = true;
  findings.upper = alive;
  findings.upper_proved = alive.has_value();
  findings.patterns.clear();
  if (findings.status != engine::Status::solved) return;
  if (recorder_ && dead > 0)
    decide(CriticalEnd::lower, dead, recorder_, proved_dead, findings.costs);
  if (alive && (recorder_ || question_.with_patterns))
    take_patterns(decide(CriticalEnd::upper, *alive, recorder_, lives, findings.costs), findings);
}

// Down to where everything is dead, and the verifier says so. Without friction nothing wedges, K
// being definite, and for less than the least nothing is computed.
void Ends::prove_lower(CriticalFindings& findings) {
  const double least = CriticalFriction::range(problem_).least;
  std::optional<double> dead;  // by the solver's own bounds
  double factor = findings.lower;
  double step = question_.width;
  for (int move = 0; move < most_moves && factor >= least; ++move, step *= growth) {
    const auto decided = decide(CriticalEnd::lower, factor, recorder_, all_dead, findings.costs);
    findings.status = decided.status;
    if (!decided.solved()) return;
    if (all_dead(decided) && !dead) dead = factor;
    if (decided.is_proved_dead()) {
      findings.lower = factor;
      findings.lower_proved = true;
      return;
    }
    factor -= step;
  }
  findings.lower = dead.value_or(0);
  findings.lower_proved = findings.lower == 0;
}

CriticalEntry entry_of(const Configuration& leaf, const CriticalFindings& findings) {
  return {.block = leaf.block,
          .pattern = leaf.pattern,
          .lower = findings.lower,
          .upper = findings.upper,
          .reaction = leaf.reaction,
          .displacement = leaf.displacement};
}

// Up to where something lives, and the verifier says so of a solid cone. Where there are flat ones
// only, they are ties, and nothing above proves them better.
void Ends::prove_upper(CriticalFindings& findings) {
  std::optional<Decided> living;  // the first where something lives
  double factor = findings.upper.value_or(question_.most);
  double step = question_.width;
  for (int move = 0; move < most_moves && factor <= question_.most; ++move, step *= growth) {
    auto decided = decide(CriticalEnd::upper, factor, recorder_, lives, findings.costs);
    findings.status = decided.status;
    if (!decided.solved()) return;
    if (lives(decided) && !living) {
      living = decided;
      findings.upper = factor;
    }
    findings.upper_proved = decided.is_proved_alive();
    if (findings.upper_proved) {
      living = std::move(decided);
      findings.upper = factor;
    }
    if (findings.upper_proved || (living && living->count(LeafState::alive) == 0)) break;
    factor += step;
  }
  if (!living) {
    findings.upper.reset();
    return;
  }
  take_patterns(*living, findings);
}

void Ends::take_patterns(const Decided& decided, CriticalFindings& findings) const {
  if (!question_.with_patterns) return;
  for (const auto& leaf : decided.leaves) {
    const bool cone = leaf.state == LeafState::alive || leaf.state == LeafState::flat;
    if (cone) findings.patterns.push_back(entry_of(leaf, findings));
  }
}

void Ends::note_what_is_open(CriticalFindings& findings) const {
  if (findings.status != engine::Status::solved) return;
  if (!findings.upper && findings.lower < question_.most) {
    findings.open.push_back(CriticalDoubt::no_upper_end);
  }
  if (findings.upper && *findings.upper - findings.lower > wide * question_.width) {
    findings.open.push_back(CriticalDoubt::wide_bracket);
  }
  if (!findings.lower_proved) findings.open.push_back(CriticalDoubt::lower_not_proved);
}

}  // namespace

void prove_ends(engine::Campaign& campaign, const problems::Structure& structure,
                const problems::WedgedProblem& problem, const EndsQuestion& question,
                const EndRecorder& recorder, CriticalFindings& findings) {
  // All ranks move the ends alike.
  const auto bracket = engine::from_first_rank(campaign.transport(), [&] {
    std::vector<double> known;
    for (const auto& end : {std::optional(findings.lower), findings.upper})
      if (end) known.push_back(*end);
    return known;
  });
  findings.lower = bracket[0];
  if (bracket.size() > 1) findings.upper = bracket[1];
  Ends ends(campaign, structure, problem, question, recorder);
  if (ends.is_to_bisect()) {
    ends.bisect(findings);
    ends.note_what_is_open(findings);
    return;
  }
  ends.prove_lower(findings);
  if (findings.status == engine::Status::solved && findings.upper) ends.prove_upper(findings);
  ends.note_what_is_open(findings);
}

}  // namespace kusabi::wedged
