// One tree of sign patterns an end, or several if an end has to give way.
#include "nodes/wedged/critical_ends.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/counts.hpp"
#include "engine/expansion.hpp"
#include "engine/together.hpp"
#include "nodes/wedged/candidate_friction.hpp"
#include "nodes/wedged/critical_friction.hpp"
#include "nodes/wedged/evidence_check.hpp"
#include "nodes/wedged/maximal_cones.hpp"
#include "nodes/wedged/preparation.hpp"

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
  std::uint64_t unproved = 0;  ///< nodes whose evidence it refuses, or of which nothing is claimed

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
};

/// The problem type that engine::search searches: a tree of sign patterns that counts what the
/// verifier says of its nodes, so that the counts go with the search wherever it goes on.
class JudgedTree {
 public:
  using Node = SignPatternTree::Node;
  using Solution = SignPatternTree::Solution;
  static constexpr auto work_of_first_child = SignPatternTree::work_of_first_child;

  struct Tally : engine::Counts<Tally> {
    std::uint64_t alive = 0;     ///< leaves that live by the verifier's test
    std::uint64_t unproved = 0;  ///< nodes of which it proves nothing

    static constexpr auto fields() {
      return std::tuple{field("alive", &Tally::alive), field("unproved", &Tally::unproved)};
    }
  };

  /// @param holds whether the verifier accepts what is said of a node
  JudgedTree(SignPatternTree tree, std::function<bool(const Evidence&)> holds)
      : tree_(std::move(tree)), holds_(std::move(holds)) {
    tree_.report_to([this](const auto& evidence) {
      const bool held = holds_(evidence);
      if (!held || evidence.kind == Evidence::Kind::marginal) ++tally_.unproved;
      if (held && evidence.kind == Evidence::Kind::alive) ++tally_.alive;
    });
  }
  JudgedTree(const JudgedTree&) = delete;
  JudgedTree& operator=(const JudgedTree&) = delete;
  ~JudgedTree() = default;

  Node root() const { return tree_.root(); }
  Tally tally() const { return tally_; }

  void expand(Node&& node, engine::Expansion<JudgedTree>& out) {
    auto fate = tree_.decide(node);
    if (fate.leaf) out.solution(std::move(*fate.leaf));
    for (const Node& child : fate.children) out.branch(child);
  }

 private:
  SignPatternTree tree_;
  std::function<bool(const Evidence&)> holds_;
  Tally tally_;
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
        stiffness_(enclosed_stiffness(structure)) {}

  void prove_lower(CriticalFindings& findings);
  void prove_upper(CriticalFindings& findings);
  void note_what_is_open(CriticalFindings& findings) const;

 private:
  /// All sign patterns at one coefficient; what that takes is added to the costs.
  /// @param wanted whether what was found is worth a record
  template <class Wanted>
  Decided decide(CriticalEnd end, double factor, Wanted wanted, std::vector<CriticalCost>& costs);

  engine::Campaign& campaign_;
  const problems::WedgedProblem& problem_;
  const EndsQuestion& question_;
  const EndRecorder& recorder_;
  /// Or why the ends cannot be put to the verifier's test.
  std::variant<verify::EnclosedProblem, std::string> stiffness_;
};

template <class Wanted>
Decided Ends::decide(CriticalEnd end, double factor, Wanted wanted,
                     std::vector<CriticalCost>& costs) {
  const auto friction = candidate_friction(problem_, factor);
  const SignPatternOptions options{.tolerances = CriticalFriction::tolerances,
                                   .tightening = question_.tightening,
                                   .thorough = true};
  SignPatternTree patterns(problem_, friction, options);
  const auto prepared = prepare(campaign_, problem_, friction, options);
  inform(patterns, prepared);
  const auto bounds = proved_bounds(prepared);
  const auto record = recorder_ ? recorder_(end, factor, friction) : nullptr;
  std::optional<EvidenceCheck> check;
  if (const auto* const stiffness = std::get_if<verify::EnclosedProblem>(&stiffness_)) {
    check.emplace(problem_, *stiffness, friction, bounds);
  }
  JudgedTree tree(std::move(patterns), [&](const auto& evidence) {
    if (record) record->add(evidence);
    return !check || check->holds(evidence);
  });
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
                   .alive = judged.alive,
                   .unproved = judged.unproved};
  });
  if (record) record->end(bounds, decided.solved() && wanted(decided));
  return decided;
}

// Down to where everything is dead, and the verifier says so. Without friction nothing wedges, K
// being definite, and for less than the least nothing is computed.
void Ends::prove_lower(CriticalFindings& findings) {
  const double least = CriticalFriction::range(problem_).least;
  const auto all_dead = [](const Decided& decided) { return decided.leaves.empty(); };
  std::optional<double> dead;  // by the solver's own bounds
  double factor = findings.lower;
  double step = question_.width;
  for (int move = 0; move < most_moves && factor >= least; ++move, step *= growth) {
    const auto decided = decide(CriticalEnd::lower, factor, all_dead, findings.costs);
    findings.status = decided.status;
    if (!decided.solved()) return;
    if (all_dead(decided) && !dead) dead = factor;
    if (all_dead(decided) && decided.unproved == 0) {
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
  const auto lives = [](const Decided& decided) { return decided.lives(); };
  const auto solid = [](const Decided& decided) { return decided.count(LeafState::alive) != 0; };
  std::optional<Decided> living;  // the first where something lives
  double factor = findings.upper.value_or(question_.most);
  double step = question_.width;
  for (int move = 0; move < most_moves && factor <= question_.most; ++move, step *= growth) {
    auto decided = decide(CriticalEnd::upper, factor, lives, findings.costs);
    findings.status = decided.status;
    if (!decided.solved()) return;
    if (lives(decided) && !living) {
      living = decided;
      findings.upper = factor;
    }
    findings.upper_proved = decided.alive != 0;
    if (findings.upper_proved) {
      living = std::move(decided);
      findings.upper = factor;
    }
    if (findings.upper_proved || (living && !solid(*living))) break;
    factor += step;
  }
  if (!living) {
    findings.upper.reset();
    return;
  }
  if (!question_.with_patterns) return;
  for (const auto& leaf : living->leaves) {
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
  ends.prove_lower(findings);
  if (findings.status == engine::Status::solved && findings.upper) ends.prove_upper(findings);
  ends.note_what_is_open(findings);
}

}  // namespace kusabi::wedged
