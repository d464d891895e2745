// Patterns, rays and critical patterns have a contact set and, mostly, a reaction.
#include "run/report/answers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string_view>

#include "answer/words.hpp"
#include "run/output/rounded_within.hpp"
#include "run/report/facts.hpp"

namespace kusabi::run {
namespace {

// Rays have a state for each candidate instead of sets of names.
void read_states(const ResultReader& reader, const ResultJson& ray, Answer& answer) {
  const auto& candidates = reader.list(reader.at(reader.all(), "problem"), "contact");
  const auto states = reader.names(ray, "state");
  if (states.size() != candidates.size()) reader.refuse("'state' has another length");
  for (std::size_t i = 0; i < states.size(); ++i) {
    auto& set = states[i] == "separates" ? answer.separated
                : states[i] == "idle"    ? answer.inactive
                                         : answer.contact;
    set.push_back(reader.text(candidates[i], "node"));
  }
}

std::string in_words(const std::string& state) {
  if (state == "feasible") return {};
  if (state == "flat") return answer::of_flat_pattern;
  if (state == "marginal" || state == "undecided") return "numerically undecided";
  return state;
}

void read_sets(const ResultReader& reader, const ResultJson& pattern, Answer& answer) {
  answer.contact = reader.names(pattern, "contact");
  answer.separated = reader.names(pattern, "separated");
  if (ResultReader::find(pattern, "inactive") != nullptr)
    answer.inactive = reader.names(pattern, "inactive");
  if (ResultReader::find(pattern, "state") != nullptr)
    answer.state = in_words(reader.text(pattern, "state"));
}

// Coefficients that candidates need, and those on the edge of their cones at the largest.
// @param friction at which the reactions are in their cones, up to rounding
void take_needs(const std::vector<std::pair<std::string, double>>& needs, double friction,
                Answer& answer) {
  constexpr double alike = 1.01;  // as in the conclusion of a run
  constexpr double none = 1e-9;   // rounding of reactions along the normal
  double maximum = 0;
  for (const auto& [name, need] : needs) maximum = std::max(maximum, need);
  answer.needed = maximum <= none ? 0 : is_all_friction(maximum, friction) ? friction : maximum;
  answer.needed_text = needed_friction_text(*answer.needed, friction, few_digits);
  for (const auto& [name, need] : needs) {
    if (need > none && need * alike > maximum) answer.slips.push_back(name);
  }
}

// Friction coefficient that a configuration needs, from the reactions of all candidates.
void read_need(const ResultReader& reader, const ResultJson& candidates, double coefficient,
               Answer& answer) {
  const auto d = static_cast<int>(reader.number(reader.at(reader.all(), "problem"), "d"));
  std::vector<std::pair<std::string, double>> needs;
  bool friction = false;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Eigen::Vector3d force = reader.vector((*answer.reaction)[i], d);
    const double cone = reader.number(candidates[i], "friction") * force.x();
    friction = friction || cone > 0;
    if (cone > 0)
      needs.emplace_back(reader.text(candidates[i], "node"), force.tail<2>().norm() / cone);
  }
  if (friction) take_needs(needs, coefficient, answer);
}

// States of equilibrium under load.
std::vector<Answer> states(const ResultReader& reader) {
  std::map<std::string, double> friction;
  const auto& problem = reader.at(reader.all(), "problem");
  for (const auto& each : reader.list(problem, "contact"))
    friction[reader.text(each, "node")] = reader.number(each, "friction");
  const auto d = static_cast<int>(reader.number(problem, "d"));
  const auto given = given_friction(reader);
  std::vector<Answer> all;
  for (const auto* const entry : held_states(reader)) {
    Answer answer{};
    answer.number = all.size() + 1;
    read_sets(reader, reader.at(*entry, "pattern"), answer);
    const auto [low, high] = held_range(reader, *entry);
    if (ResultReader::find(*entry, "below") != nullptr) {
      const auto shown = shown_ends(low, high, many_digits);
      const auto [from, to] = held_ends(reader, *entry);
      const auto standing = reader.text(*entry, "standing");
      if (from != nullptr) answer.numbers.push_back({"low", from, shown.low, standing});
      if (to != nullptr) answer.numbers.push_back({"high", to, shown.high, standing});
    } else {
      for (const char* const key : {"lower", "upper"}) {
        const auto* const value = reader.bound_value(*entry, key);
        if (value != nullptr)
          answer.numbers.push_back({key, value, {}, standing_of(reader, entry, key)});
      }
      answer.order = reader.bound(*entry, "upper");
    }
    const auto& state = reader.at(*entry, "state");
    answer.load = under_factor(reader.number(state, "factor"), low, high);
    std::vector<std::pair<std::string, double>> needs;
    for (const auto& [name, value] : reader.at(state, "reactions").items()) {
      const Eigen::Vector3d force = reader.vector(value, d);
      const double cone = friction[name] * force.x();
      needs.emplace_back(name, cone > 0 ? force.tail<2>().norm() / cone : 0);
    }
    take_needs(needs, given ? *given : answer.order.value_or(0), answer);
    all.push_back(std::move(answer));
  }
  return all;
}

// Keys of the numbers of an answer; the second is that of its order.
std::pair<std::vector<const char*>, std::string_view> keys_of(const std::string& command) {
  if (command == "rays") return {{}, {}};
  if (command == "critical") return {{"lower", "upper"}, "upper"};
  return {{"margin", "margin_upper"}, "margin"};
}

}  // namespace

std::vector<Answer> answers(const ResultReader& reader) {
  std::vector<Answer> all;
  const auto command = reader.text(reader.all(), "command");
  if (command == "hold") return states(reader);
  if (command != "patterns" && command != "rays" && command != "critical") return all;
  const bool rays = command == "rays";
  const auto [keys, order] = keys_of(command);
  const auto& result = reader.at(reader.all(), "result");
  const auto& list = reader.list(result, rays ? "rays" : "patterns");
  const auto& candidates = reader.list(reader.at(reader.all(), "problem"), "contact");
  for (const auto& entry : list) {
    Answer answer{};
    answer.number = all.size() + 1;
    if (rays) {
      read_states(reader, entry, answer);
    } else {
      read_sets(reader, entry, answer);
    }
    for (const char* const key : keys) {
      const auto* const value = ResultReader::find(entry, key);
      answer.numbers.push_back({key, value});
      if (value == nullptr) continue;
      const double number = reader.number(entry, key);
      if (key == order) answer.order = number;
    }
    if (ResultReader::find(entry, "reaction") != nullptr) {
      answer.reaction = &reader.list(entry, "reaction", candidates.size());
      const auto coefficient =
          command == "critical" ? answer.order : std::optional(reader.number(result, "friction"));
      if (coefficient) read_need(reader, candidates, *coefficient, answer);
    }
    all.push_back(std::move(answer));
  }
  return all;
}

std::vector<std::size_t> by_rank(const ResultReader& reader, const std::vector<Answer>& answers) {
  constexpr double last = std::numeric_limits<double>::infinity();
  const auto command = reader.text(reader.all(), "command");
  const auto weakness = [&](std::size_t i) {
    const auto& answer = answers[i];
    if (command == "rays") return answer.needed.value_or(last);
    const double order = answer.order.value_or(command == "critical" ? last : -last);
    return command == "critical" ? order : -order;
  };
  std::vector<std::size_t> order(answers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, weakness);
  return order;
}

void attach(const ResultScenes& scenes, std::vector<Answer>& answers) {
  for (std::size_t i = 0; i < scenes.entries.size(); ++i)
    answers.at(scenes.entries[i]).scene = &scenes.scenes[i];
}

}  // namespace kusabi::run
