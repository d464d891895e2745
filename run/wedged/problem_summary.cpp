// Problem as a line and as JSON.
#include "run/wedged/problem_summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "problems/wedged/problem_block.hpp"
#include "run/output/name_ranges.hpp"
#include "run/output/values.hpp"
#include "run/pictures/structure_json.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

ordered_json contact_frames(const problems::WedgedProblem& problem) {
  auto list = ordered_json::array();
  for (std::size_t i = 0; i < problem.contact_names.size(); ++i) {
    ordered_json frame;
    frame["node"] = problem.contact_names[i];
    const char* const axes[] = {"n", "t1", "t2"};
    for (int axis = 0; axis < problem.dimension; ++axis) {
      const Eigen::VectorXd direction = problem.frames[i].col(axis);
      frame[axes[axis]] = std::vector<double>(direction.begin(), direction.end());
    }
    frame["friction"] = problem.friction[i];
    list.push_back(std::move(frame));
  }
  return list;
}

// Unconstrained bodies: first node, number of nodes, and a sentence about their rigid-body modes.
ordered_json rigid_motions_json(const problems::WedgedProblem& problem) {
  auto list = ordered_json::array();
  for (const auto& [node, nodes, motions] : problem.modes.bodies)
    list.push_back({{"node", node}, {"nodes", nodes}, {"motions", motions}});
  return list;
}

}  // namespace

std::string problem_line(const problems::WedgedProblem& problem) {
  auto sizes = answer::counted(problem.provenance.nodes, "node");
  if (problem.provenance.members > 0)
    sizes += ", " + answer::counted(problem.provenance.members, "member");
  if (problem.provenance.elements > 0)
    sizes += ", " + answer::counted(problem.provenance.elements, "element");
  auto line = fmt::format("{}: {}, {}, {}", problem.provenance.name,
                          problem.dimension == 2 ? "in the plane" : "in space", sizes,
                          answer::counted(problem.contact_names.size(), "contact candidate"));
  const auto& bodies = problem.modes.bodies;
  constexpr std::size_t max_described = 3;
  for (std::size_t k = 0; k < std::min(bodies.size(), max_described); ++k) {
    line += bodies.size() == 1 ? "; unconstrained: "
                               : fmt::format("; unconstrained from node {} on: ", bodies[k].node);
    line += bodies[k].motions;
  }
  if (bodies.size() > max_described)
    line += fmt::format("; and {} more unconstrained {}", bodies.size() - max_described,
                        bodies.size() - max_described == 1 ? "body" : "bodies");
  return line;
}

std::string friction_text(const problems::WedgedProblem& problem, double coefficient) {
  return answer::friction_words(coefficient, !problems::uniform_friction(problem));
}

ordered_json problem_json(const problems::Structure& structure,
                          const problems::WedgedProblem& problem, const std::string& file) {
  ordered_json json{
      {"file", file},
      {"name", problem.provenance.name},
      {"d", problem.dimension},
      {"m", problem.contact_names.size()},
      {"nodes", problem.provenance.nodes},
      {"members", problem.provenance.members},
      {"elements", problem.provenance.elements},
      {"units",
       {{"length", problem.provenance.units.length}, {"force", problem.provenance.units.force}}},
      {"contact", contact_frames(problem)},
      {"fingerprint", hexadecimal(problem.provenance.fingerprint)}};
  if (!problem.modes.bodies.empty()) json["rigid_motions"] = rigid_motions_json(problem);
  json["structure"] = structure_json(structure);
  return json;
}

std::vector<double> friction_at(const problems::WedgedProblem& problem, double coefficient,
                                const std::string& file) {
  std::vector<double> friction = problem.friction;
  for (std::size_t i = 0; i < friction.size(); ++i) {
    friction[i] *= coefficient;
    if (friction[i] == 0) continue;
    if (friction[i] >= wedged::min_friction && friction[i] <= wedged::max_friction) continue;
    throw WrongInput(fmt::format(
        "{}: the friction coefficient at {} is {:g}; expected 0, or {:g} to {:g}, by "
        "another coefficient or another relative friction",
        file, problem.contact_names[i], friction[i], wedged::min_friction, wedged::max_friction));
  }
  return friction;
}

std::vector<std::string> candidate_names(const problems::WedgedProblem& problem,
                                         const support::IndexSet& candidates) {
  std::vector<std::string> names;
  for (const int candidate : candidates)
    names.push_back(problem.contact_names[static_cast<std::size_t>(candidate)]);
  return names;
}

std::string contact_text(const problems::WedgedProblem& problem,
                         const wedged::SignPattern& pattern) {
  const auto names = [&](const support::IndexSet& set) {
    return with_ranges(candidate_names(problem, set));
  };
  const auto& [contact, separated, inactive] = pattern;
  auto text = names(contact);
  if (!inactive.empty()) return text + "  inactive: " + names(inactive);
  if (problem.blocks.size() > 1) return text;  // the other candidates of its block
  const auto rest = separated.empty() ? std::string("all") : "all but " + names(separated);
  return shown_width(rest) < shown_width(text) ? rest : text;
}

ordered_json pattern_json(const problems::WedgedProblem& problem, std::uint32_t block,
                          const wedged::SignPattern& pattern, const support::IndexSet& inactive) {
  ordered_json json;
  if (problem.blocks.size() > 1) json["block"] = block + 1;
  json["contact"] = candidate_names(problem, pattern.contact);
  json["separated"] = candidate_names(problem, pattern.separated);
  const auto all_inactive = pattern.inactive | inactive;
  if (!all_inactive.empty()) json["inactive"] = candidate_names(problem, all_inactive);
  return json;
}

std::string listed(const std::vector<std::string>& words) {
  return words.empty() ? "-" : fmt::format("{}", fmt::join(words, " "));
}

ordered_json candidate_rows(std::span<const double> values, int dimension) {
  auto list = ordered_json::array();
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t at = 0; at < values.size(); at += d) {
    list.push_back(std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(at),
                                       values.begin() + static_cast<std::ptrdiff_t>(at + d)));
  }
  return list;
}

std::vector<double> of_all_candidates(const problems::WedgedProblem& problem, std::uint32_t block,
                                      std::span<const double> values) {
  const auto d = static_cast<std::size_t>(problem.dimension);
  const auto candidates = problems::blocks_of(problem)[block];
  std::vector<double> whole(d * problem.contact_names.size(), 0);
  auto next = values.begin();
  for (const int i : candidates) {
    std::copy_n(next, d, whole.begin() + std::ptrdiff_t{problem.dimension} * i);
    next += problem.dimension;
  }
  return whole;
}

ordered_json block_rows(const problems::WedgedProblem& problem, std::uint32_t block,
                        std::span<const double> values) {
  return candidate_rows(of_all_candidates(problem, block, values), problem.dimension);
}

double relative_friction(const problems::WedgedProblem& problem, int candidate) {
  return problem.friction.empty() ? 1.0 : problem.friction[static_cast<std::size_t>(candidate)];
}

double tangential_reaction(const problems::WedgedProblem& problem,
                           std::span<const double> reactions, int candidate) {
  const auto at = static_cast<std::size_t>(problem.dimension * candidate);
  return problem.dimension == 2 ? std::abs(reactions[at + 1])
                                : std::hypot(reactions[at + 1], reactions[at + 2]);
}

nlohmann::ordered_json exact_json(const wedged::ExactTest& test) {
  return {{"scale_ratio", answer::number_or_null(test.scale_ratio)},
          {"done", test.done},
          {"refused", test.refused},
          {"refused_needed", test.closed_unproved},
          {"unproved", test.unproved}};
}

std::optional<answer::ExactRemainder> remainder_of(const wedged::ExactTest& test) {
  if (!test.is_open()) return std::nullopt;
  return answer::ExactRemainder{test.scale_ratio.value(), test.unable,
                                test.closed_unproved + test.unproved};
}

}  // namespace kusabi::run
