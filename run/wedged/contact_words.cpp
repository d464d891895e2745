// Names are shortened, and counted if they are long.
#include "run/wedged/contact_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

#include "problems/wedged/problem_block.hpp"
#include "run/output/short_names.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

constexpr std::size_t longest_names = 90;  ///< characters of a list of names

std::string names_within(const problems::WedgedProblem& problem, std::uint32_t block,
                         const support::IndexSet& candidates) {
  const ShortNames names(candidate_names(problem, problems::blocks_of(problem)[block]));
  return names.of(candidate_names(problem, candidates), longest_names);
}

}  // namespace

std::string contact_words(const problems::WedgedProblem& problem, std::uint32_t block,
                          const support::IndexSet& contact, const support::IndexSet& inactive) {
  auto text = names_within(problem, block, contact);
  const bool all = text.starts_with("all ");
  if (all && !text.starts_with("all but "))
    text = contact.size() == 2 ? "both candidates" : text + " candidates";
  if (all && problem.blocks.size() > 1) text += " of its block";
  if (!inactive.empty())
    text += fmt::format(" ({} inactive)", names_within(problem, block, inactive));
  return "contact at " + text;
}

FrictionNeed friction_need(const problems::WedgedProblem& problem, std::uint32_t block,
                           const support::IndexSet& contact, std::span<const double> reaction) {
  // The cone program makes several inequalities equally near.
  constexpr double alike = 1.01;
  constexpr double none = 1e-9;  // rounding of reactions along the normal
  const auto d = static_cast<std::size_t>(problem.dimension);
  const auto r = of_all_candidates(problem, block, reaction);
  const auto needed = [&](int i) {
    const double cone = relative_friction(problem, i) * r[d * static_cast<std::size_t>(i)];
    return cone > 0 ? tangential_reaction(problem, r, i) / cone : 0.0;
  };
  FrictionNeed need;
  for (const int i : contact) need.coefficient = std::max(need.coefficient, needed(i));
  if (need.coefficient <= none) return {};
  for (const int i : contact) {
    if (needed(i) * alike > need.coefficient) need.slips.insert(i);
  }
  return need;
}

std::string slip_words(const problems::WedgedProblem& problem, std::uint32_t block,
                       const support::IndexSet& contact, const FrictionNeed& need) {
  const auto& slips = need.slips;
  if (slips == contact && slips.size() > 1)
    return slips.size() == 2 ? "both slip at once" : "all of them slip at once";
  return fmt::format("{} {}{}", names_within(problem, block, slips),
                     slips.size() == 1 ? "slips" : "slip", slips == contact ? "" : " first");
}

std::string angle_sentence(const problems::WedgedProblem& problem, double coefficient) {
  if (!problems::uniform_friction(problem)) return {};
  return fmt::format(" The angle of friction there is about {:.4g}°.",
                     std::atan(coefficient) * 180 / std::numbers::pi);
}

}  // namespace kusabi::run
