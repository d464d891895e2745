// One tree of sign patterns an end, or several if an end has to give way.
#include "run/critical_ends.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <fmt/format.h>

#include "nodes/critical_friction.hpp"
#include "nodes/maximal_cones.hpp"
#include "nodes/sign_pattern.hpp"
#include "problems/fingerprint.hpp"
#include "run/certificate_file.hpp"
#include "run/rank_table.hpp"
#include "run/shown_search.hpp"
#include "run/standard_output.hpp"
#include "run/told.hpp"

namespace kusabi::run {
namespace {

/// An end moves outwards by the width first, and eight times as far each time.
constexpr int most_moves = 24;
constexpr double growth = 8;

/// A bracket counts as wider than asked for from this many widths on: a coefficient that is itself a
/// multiple of the width has a neighbour on either side.
constexpr double wide = 2.5;

/// What lives at one coefficient.
struct Decided {
  std::string status;
  std::vector<nodes::Configuration> leaves;  ///< maximal cones and open leaves

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& leaves;
  }

  [[nodiscard]] bool solved() const { return status == "solved"; }
  [[nodiscard]] std::uint64_t count(nodes::LeafState state) const {
    return static_cast<std::uint64_t>(std::count_if(
        leaves.begin(), leaves.end(), [&](const auto& leaf) { return leaf.state == state; }));
  }
  [[nodiscard]] bool lives() const {
    return count(nodes::LeafState::alive) + count(nodes::LeafState::flat) != 0;
  }
};

class Ends {
 public:
  Ends(Session& session, const CriticalOptions& options, const problems::WedgedProblem& problem,
       const Budget& budget)
      : session_(session), options_(options), problem_(problem), budget_(budget) {}

  /// All sign patterns at one coefficient. @param certificate the evidence goes here; empty: nowhere
  /// @param wanted whether what was found is worth a certificate
  template <class Wanted>
  Decided decide(double factor, const std::string& certificate, Wanted wanted) {
    std::vector<double> friction = problem_.friction;
    for (double& mu : friction) mu *= factor;
    nodes::SignPatternTree tree(problem_, friction,
                                {.tolerances = nodes::CriticalFriction::tolerances});
    problems::Fingerprint fingerprint;
    fingerprint.add(problem_.fingerprint);
    fingerprint.add(factor);
    CertificateFile file(session_, certificate, options_.file, fingerprint.value(), false);
    if (file.wanted()) tree.report_to([&](const auto& evidence) { file.add(evidence); });
    auto outcome = shown_search(session_, tree, {}, budget_.left(), options_.quiet);
    const auto decided = told_by_first_rank(session_, [&] {
      std::vector<nodes::Configuration> leaves;
      for (auto& found : outcome.solutions) leaves.push_back(std::move(found.solution));
      return Decided{status_name(outcome.status), nodes::maximal_cones(std::move(leaves))};
    });
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
  const Budget& budget_;
};

std::string name_of(const CriticalOptions& options, const char* end) {
  return options.certificate.empty() ? std::string{} : options.certificate + end;
}

// Down to where everything is dead. Without friction nothing wedges, K being definite.
void prove_lower(Ends& ends, const CriticalOptions& options, CriticalFindings& findings) {
  double step = options.width;
  const auto all_dead = [](const Decided& decided) { return decided.leaves.empty(); };
  for (int move = 0; move < most_moves && findings.lower > 0; ++move, step *= growth) {
    const auto decided = ends.decide(findings.lower, name_of(options, ".lower"), all_dead);
    findings.status = decided.status;
    if (!decided.solved()) return;
    findings.lower_proved = all_dead(decided);
    if (findings.lower_proved) return;
    findings.lower = std::max(0.0, findings.lower - step);
  }
  findings.lower_proved = findings.lower == 0;
}

CriticalEntry entry_of(const nodes::Configuration& leaf, const CriticalFindings& findings) {
  return {.block = leaf.block,
          .pattern = leaf.pattern,
          .lower = findings.lower,
          .upper = findings.upper,
          .reaction = leaf.reaction,
          .displacement = leaf.displacement};
}

// Up to where something lives; solid cones are proved, flat ones hold within rounding.
void prove_upper(Ends& ends, const CriticalOptions& options, double most,
                 CriticalFindings& findings) {
  const bool list = options.way == CriticalWay::global;
  const auto lives = [](const Decided& decided) { return decided.lives(); };
  double step = options.width;
  for (int move = 0; move < most_moves && findings.upper; ++move, step *= growth) {
    const auto decided = ends.decide(*findings.upper, name_of(options, ".upper"), lives);
    findings.status = decided.status;
    if (!decided.solved()) return;
    findings.upper_proved = decided.count(nodes::LeafState::alive) != 0;
    if (decided.lives()) {
      for (const auto& leaf : decided.leaves) {
        const bool cone = leaf.state == nodes::LeafState::alive ||
                          leaf.state == nodes::LeafState::flat;
        if (list && cone) findings.patterns.push_back(entry_of(leaf, findings));
      }
      return;
    }
    const double next = *findings.upper + step;
    findings.upper = next <= most ? std::optional(next) : std::nullopt;
  }
}

void say_what_is_open(const CriticalOptions& options, double most, CriticalFindings& findings) {
  if (findings.status != "solved") return;
  if (!findings.upper && findings.lower < most) {
    findings.open.push_back(
        fmt::format("between {:.10g} and {:.10g} it could not be told whether anything can wedge",
                    findings.lower, most));
  }
  if (findings.upper && *findings.upper - findings.lower > wide * options.width) {
    findings.open.push_back(
        fmt::format("the bracket is {:.2g} wide, wider than asked for ({:g}): in between, what can "
                    "wedge could not be told from what just cannot",
                    *findings.upper - findings.lower, options.width));
  }
  if (!findings.lower_proved)
    findings.open.push_back(fmt::format("the lower end {:.10g} is not proved", findings.lower));
}

}  // namespace

void prove_ends(Session& session, const CriticalOptions& options,
                const problems::WedgedProblem& problem, const Budget& budget,
                CriticalFindings& findings) {
  // All ranks move the ends alike.
  const auto bracket = told_by_first_rank(session, [&] {
    std::vector<double> known{findings.lower};
    if (findings.upper) known.push_back(*findings.upper);
    return known;
  });
  findings.lower = bracket[0];
  if (bracket.size() > 1) findings.upper = bracket[1];
  const double most = options.most.value_or(usual_most);
  Ends ends(session, options, problem, budget);
  prove_lower(ends, options, findings);
  if (findings.status == "solved") prove_upper(ends, options, most, findings);
  say_what_is_open(options, most, findings);
}

}  // namespace kusabi::run
