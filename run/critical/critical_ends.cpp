// One tree of sign patterns an end, or several if an end has to give way.
#include "run/critical/critical_ends.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <fmt/format.h>

#include "engine/together.hpp"
#include "nodes/wedged/critical_friction.hpp"
#include "nodes/wedged/maximal_cones.hpp"
#include "nodes/wedged/sign_pattern.hpp"
#include "run/evidence/certificate_file.hpp"
#include "run/evidence/evidence_check.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/standard_output.hpp"
#include "run/session/shown_search.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

/// An end moves outwards by the width first, and eight times as far each time.
constexpr int most_moves = 7;
constexpr double growth = 8;

/// A bracket counts as wider than asked for from this many widths on: a coefficient that is itself
/// a multiple of the width has a neighbour on either side.
constexpr double wide = 2.5;

/// What lives at one coefficient.
struct Decided {
  std::string status;
  std::vector<wedged::Configuration> leaves;  ///< maximal cones and open leaves
  std::uint64_t alive = 0;                    ///< leaves that live by the verifier's test
  std::uint64_t unproved = 0;  ///< nodes whose evidence it refuses, or of which nothing is claimed

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& leaves& alive& unproved;
  }

  [[nodiscard]] bool solved() const { return status == "solved"; }
  [[nodiscard]] std::uint64_t count(wedged::LeafState state) const {
    return static_cast<std::uint64_t>(std::count_if(
        leaves.begin(), leaves.end(), [&](const auto& leaf) { return leaf.state == state; }));
  }
  [[nodiscard]] bool lives() const {
    return count(wedged::LeafState::alive) + count(wedged::LeafState::flat) != 0;
  }
};

// What one rank saw proved, and what not.
struct Proved {
  std::uint64_t alive = 0, unproved = 0;
};

class Ends {
 public:
  Ends(Session& session, const CriticalOptions& options, const problems::Structure& structure,
       const problems::WedgedProblem& problem, const engine::Budget& budget)
      : session_(session),
        options_(options),
        problem_(problem),
        budget_(budget),
        stiffness_(enclosed_stiffness(structure)) {}

  /// Why the ends cannot be put to the verifier's test; empty: they can.
  [[nodiscard]] std::string obstacle() const {
    const auto* const why = std::get_if<std::string>(&stiffness_);
    return why != nullptr ? *why : std::string{};
  }

  /// All sign patterns at one coefficient. @param certificate the evidence goes here; empty:
  /// nowhere
  /// @param wanted whether what was found is worth a certificate
  template <class Wanted>
  Decided decide(double factor, const std::string& certificate, Wanted wanted) {
    const auto friction = friction_at(problem_, factor, options_.file);
    wedged::SignPatternTree tree(
        problem_, friction, {.tolerances = wedged::CriticalFriction::tolerances, .thorough = true});
    support::Fingerprint fingerprint;
    fingerprint.add(problem_.fingerprint);
    fingerprint.add(factor);
    CertificateFile file(session_, certificate, options_.file, fingerprint.value(), false);
    std::optional<EvidenceCheck> check;
    if (obstacle().empty())
      check.emplace(problem_, std::get<verify::EnclosedMatrix>(stiffness_), friction);
    Proved own;
    tree.report_to([&](const auto& evidence) {
      const bool holds = !check || check->holds(evidence);
      if (!holds || evidence.kind == wedged::Evidence::Kind::marginal) ++own.unproved;
      if (holds && evidence.kind == wedged::Evidence::Kind::alive) ++own.alive;
      if (file.wanted()) file.add(evidence);
    });
    auto outcome = shown_search(session_, tree, {}, budget_.left(), options_.quiet);
    auto decided = engine::from_first_rank(session_.transport(), [&] {
      std::vector<wedged::Configuration> leaves;
      for (auto& found : outcome.solutions) leaves.push_back(std::move(found.solution));
      return Decided{.status = status_name(outcome.status),
                     .leaves = wedged::maximal_cones(std::move(leaves))};
    });
    const auto all =
        engine::meet(session_.transport(), {.ranks = 1, .open = own.unproved, .found = own.alive});
    decided.alive = all.found;
    decided.unproved = all.open;
    if (!file.wanted()) return decided;
    file.close();
    if (!session_.speaks()) return decided;
    if (decided.solved() && wanted(decided)) {
      file.put_in_place(certificate_header(problem_, friction));
      if (!options_.quiet) tell_written({certificate});
    } else {
      file.drop();
    }
    return decided;
  }

 private:
  Session& session_;
  const CriticalOptions& options_;
  const problems::WedgedProblem& problem_;
  const engine::Budget& budget_;
  std::variant<verify::EnclosedMatrix, std::string> stiffness_;
};

std::string name_of(const CriticalOptions& options, const char* end) {
  return options.certificate.empty() ? std::string{} : options.certificate + end;
}

// Down to where everything is dead, and the verifier says so. Without friction nothing wedges, K
// being definite, and for less than `least` nothing is computed.
void prove_lower(Ends& ends, const CriticalOptions& options, double least,
                 CriticalFindings& findings) {
  const auto all_dead = [](const Decided& decided) { return decided.leaves.empty(); };
  std::optional<double> dead;  // by the solver's own bounds
  double factor = findings.lower;
  double step = options.width;
  for (int move = 0; move < most_moves && factor >= least; ++move, step *= growth) {
    const auto decided = ends.decide(factor, name_of(options, ".lower"), all_dead);
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

CriticalEntry entry_of(const wedged::Configuration& leaf, const CriticalFindings& findings) {
  return {.block = leaf.block,
          .pattern = leaf.pattern,
          .lower = findings.lower,
          .upper = findings.upper,
          .reaction = leaf.reaction,
          .displacement = leaf.displacement};
}

// Up to where something lives, and the verifier says so of a solid cone. Where there are flat ones
// only, they are ties, and nothing above proves them better.
void prove_upper(Ends& ends, const CriticalOptions& options, double most,
                 CriticalFindings& findings) {
  const auto lives = [](const Decided& decided) { return decided.lives(); };
  const auto solid = [](const Decided& decided) {
    return decided.count(wedged::LeafState::alive) != 0;
  };
  std::optional<Decided> living;  // the first where something lives
  double factor = findings.upper.value_or(most);
  double step = options.width;
  for (int move = 0; move < most_moves && factor <= most; ++move, step *= growth) {
    auto decided = ends.decide(factor, name_of(options, ".upper"), lives);
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
  if (options.way != CriticalWay::global) return;
  for (const auto& leaf : living->leaves) {
    const bool cone =
        leaf.state == wedged::LeafState::alive || leaf.state == wedged::LeafState::flat;
    if (cone) findings.patterns.push_back(entry_of(leaf, findings));
  }
}

void say_what_is_open(const CriticalOptions& options, double most, CriticalFindings& findings) {
  if (findings.status != "solved") return;
  if (!findings.upper && findings.lower < most) {
    findings.open.push_back(
        fmt::format("between {:.12g} and {:.12g} it could not be told whether anything can wedge",
                    findings.lower, most));
  }
  if (findings.upper && *findings.upper - findings.lower > wide * options.width) {
    findings.open.push_back(
        fmt::format("the bracket is {:.2g} wide, wider than asked for ({:g}): in between, what can "
                    "wedge could not be told from what just cannot",
                    *findings.upper - findings.lower, options.width));
  }
  if (!findings.lower_proved) {
    findings.open.push_back(fmt::format(
        "that nothing wedges at {:.12g} is not proved in exact arithmetic", findings.lower));
  }
}

}  // namespace

void prove_ends(Session& session, const CriticalOptions& options,
                const problems::Structure& structure, const problems::WedgedProblem& problem,
                const engine::Budget& budget, CriticalFindings& findings) {
  // All ranks move the ends alike.
  const auto bracket = engine::from_first_rank(session.transport(), [&] {
    std::vector<double> known{findings.lower};
    if (findings.upper) known.push_back(*findings.upper);
    return known;
  });
  findings.lower = bracket[0];
  if (bracket.size() > 1) findings.upper = bracket[1];
  const double most = options.most.value_or(usual_most);
  Ends ends(session, options, structure, problem, budget);
  prove_lower(ends, options, wedged::CriticalFriction::range(problem).least, findings);
  if (findings.status == "solved" && findings.upper) prove_upper(ends, options, most, findings);
  say_what_is_open(options, most, findings);
}

}  // namespace kusabi::run
