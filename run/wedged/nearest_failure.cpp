// Inequalities candidate by candidate, in the frames of the candidates.
#include "run/wedged/nearest_failure.hpp"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "problems/wedged/problem_block.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

// Relative tolerance: the cone program makes several inequalities equally near; the one with the
// highest friction utilisation is reported.
constexpr double alike = 1.01;

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
  NearestFailure nearest;
  nearest.need = friction_need(problem, block, pattern.contact, reaction);
  for (const int i : pattern.contact) {
    const double normal = r[d * static_cast<std::size_t>(i)];
    const double tangential = tangential_reaction(problem, r, i);
    const double phi = relative_friction(problem, i);
    const double cone = (phi == 0 ? 1 : coefficient * phi) * normal;
    const double used = phi * normal > 0 ? tangential / cone : 0;
    take_if_nearer(nearest.contact, {.candidate = i, .amount = cone - tangential, .used = used});
  }
  for (const int j : pattern.separated)
    take_if_nearer(nearest.gap,
                   {.candidate = j, .amount = u[d * static_cast<std::size_t>(j)], .used = 0});
  if (nearest.contact && nearest.gap) {
    const auto own = problems::block_problem(problem, problems::blocks_of(problem)[block]);
    nearest.gap_first =
        nearest.gap->amount * alike < nearest.contact->amount * problems::margin_unit(own);
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
  return fmt::format(" If the normal reactions sum to {}, {}.", scale, text);
}

}  // namespace kusabi::run
