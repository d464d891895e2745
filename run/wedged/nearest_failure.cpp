// Inequalities candidate by candidate, in the frames of the candidates.
#include "run/wedged/nearest_failure.hpp"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "problems/wedged/problem_block.hpp"
#include "run/output/name_ranges.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

// Relative tolerance: the cone program makes several inequalities equally near; the one with the
// highest friction utilisation is reported, and those that slip with it.
constexpr double alike = 1.01;

// State of one candidate.
struct Local {
  double normal_reaction;
  double tangential_reaction;
  double gap;
};

Local local(const std::vector<double>& reaction, const std::vector<double>& displacement,
            std::size_t dimension, int candidate) {
  const auto at = dimension * static_cast<std::size_t>(candidate);
  return {
      reaction[at],
      dimension == 2 ? std::abs(reaction[at + 1]) : std::hypot(reaction[at + 1], reaction[at + 2]),
      displacement[at]};
}

void take_if_nearer(std::optional<Slack>& minimum, const Slack& other) {
  const bool nearer = !minimum || other.amount * alike < minimum->amount;
  const bool as_near =
      minimum && other.amount < minimum->amount * alike && other.used > minimum->used;
  if (nearer || as_near) minimum = other;
}

// Units of the file; problems made by programs may have none.
std::string amount_in(double amount, const std::string& unit, const char* what) {
  return unit.empty() ? fmt::format("{:.3g} (in the file's unit of {})", amount, what)
                      : fmt::format("{:.3g} {}", amount, unit);
}

// Friction of a candidate relative to the coefficient of the search.
double relative_friction(const problems::WedgedProblem& problem, int candidate) {
  return problem.friction.empty() ? 1.0 : problem.friction[static_cast<std::size_t>(candidate)];
}

std::string contact_text(const problems::WedgedProblem& problem, const Slack& slack) {
  const auto& name = problem.contact_names[static_cast<std::size_t>(slack.candidate)];
  const auto force = amount_in(slack.amount, problem.provenance.units.force, "force");
  constexpr double half = 0.5;
  if (slack.used < half) {
    return fmt::format("{} is closest to separation, with {} = {}", name,
                       relative_friction(problem, slack.candidate) == 0 ? "r_n" : "mu r_n - |r_t|",
                       force);
  }
  return fmt::format(
      "{} is closest to slipping, with mu r_n - |r_t| = {} ({:.0f} % of mu r_n used)", name, force,
      std::floor(100 * slack.used));
}

std::string gap_text(const problems::WedgedProblem& problem, const Slack& slack) {
  return fmt::format("{} is closest to touching, at a gap of {}",
                     problem.contact_names[static_cast<std::size_t>(slack.candidate)],
                     amount_in(slack.amount, problem.provenance.units.length, "length"));
}

}  // namespace

NearestFailure nearest_failure(const problems::WedgedProblem& problem, double coefficient,
                               std::uint32_t block, const wedged::SignPattern& pattern,
                               std::span<const double> reaction,
                               std::span<const double> displacement) {
  const auto d = static_cast<std::size_t>(problem.dimension);
  const auto r = of_all_candidates(problem, block, reaction);
  const auto u = of_all_candidates(problem, block, displacement);
  const auto needed = [&](int i) {
    const auto here = local(r, u, d, i);
    const double cone = relative_friction(problem, i) * here.normal_reaction;
    return cone > 0 ? here.tangential_reaction / cone : 0.0;
  };
  NearestFailure nearest;
  for (const int i : pattern.contact) {
    const auto here = local(r, u, d, i);
    const double phi = relative_friction(problem, i);
    const double cone = (phi == 0 ? 1 : coefficient * phi) * here.normal_reaction;
    take_if_nearer(nearest.contact, {.candidate = i,
                                     .amount = cone - here.tangential_reaction,
                                     .used = needed(i) / coefficient});
    nearest.holds_from = std::max(nearest.holds_from, needed(i));
  }
  for (const int i : pattern.contact) {
    if (needed(i) > 0 && needed(i) * alike > nearest.holds_from) nearest.slips_there.push_back(i);
  }
  for (const int j : pattern.separated)
    take_if_nearer(nearest.gap, {.candidate = j, .amount = local(r, u, d, j).gap, .used = 0});
  if (nearest.contact && nearest.gap) {
    const auto own = problems::block_problem(problem, problems::blocks_of(problem)[block]);
    nearest.gap_first = nearest.gap->amount * alike <
                        nearest.contact->amount * problems::mean_normal_compliance(own);
  }
  return nearest;
}

std::string nearest_failure_text(const problems::WedgedProblem& problem,
                                 const NearestFailure& nearest) {
  if (!nearest.contact) return {};
  const auto scale = problem.provenance.units.force.empty() ? std::string("1")
                                                            : "1 " + problem.provenance.units.force;
  auto text = contact_text(problem, *nearest.contact);
  if (nearest.gap) {
    const auto gap = gap_text(problem, *nearest.gap);
    text = nearest.gap_first ? gap + "; " + text : text + "; " + gap;
  }
  text = fmt::format("If the normal reactions sum to {}, {}.", scale, text);
  if (nearest.holds_from == 0) return text + " This configuration needs no friction.";
  support::IndexSet slips;
  for (const int i : nearest.slips_there) slips |= support::IndexSet::single(i);
  return fmt::format(
      "{} This configuration needs a friction coefficient of at least {}{}; with less, {} {}.",
      text, support::rounded_down(nearest.holds_from),
      answer::of_each_candidate(!problems::uniform_friction(problem)),
      with_ranges(candidate_names(problem, slips)),
      nearest.slips_there.size() == 1 ? "slips" : "slip");
}

}  // namespace kusabi::run
