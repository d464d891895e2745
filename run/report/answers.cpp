// Patterns, rays and critical patterns have a contact set and, mostly, a reaction.
#include "run/report/answers.hpp"

#include <string_view>

namespace kusabi::run {
namespace {

// Rays have a state for each candidate instead of sets of names.
void read_states(const ResultReader& reader, const ResultJson& ray, Answer& answer) {
  const auto& candidates = reader.list(reader.at(reader.all(), "problem"), "contact");
  const auto states = reader.names(ray, "state");
  if (states.size() != candidates.size()) reader.refuse("'state' has another length");
  for (std::size_t i = 0; i < states.size(); ++i) {
    auto& set = states[i] == "separates" ? answer.separated
                : states[i] == "idle"    ? answer.at_rest
                                         : answer.contact;
    set.push_back(reader.text(candidates[i], "node"));
  }
}

void read_sets(const ResultReader& reader, const ResultJson& pattern, Answer& answer) {
  answer.contact = reader.names(pattern, "contact");
  answer.separated = reader.names(pattern, "separated");
  if (ResultReader::find(pattern, "at_rest") != nullptr)
    answer.at_rest = reader.names(pattern, "at_rest");
  if (ResultReader::find(pattern, "state") != nullptr) answer.state = reader.text(pattern, "state");
}

}  // namespace

std::vector<Answer> answers(const ResultReader& reader, const ResultScenes& scenes) {
  std::vector<Answer> all;
  const auto command = reader.text(reader.all(), "command");
  if (command == "limit" || command == "sweep") return all;
  const bool rays = command == "rays";
  const std::vector<const char*> keys = rays ? std::vector<const char*>{}
                                        : command == "critical"
                                            ? std::vector<const char*>{"lower", "upper"}
                                            : std::vector<const char*>{"margin", "margin_upper"};
  const auto& list = reader.list(reader.at(reader.all(), "result"), rays ? "rays" : "patterns");
  const auto candidates = reader.list(reader.at(reader.all(), "problem"), "contact").size();
  for (const auto& entry : list) {
    Answer answer{};
    answer.number = all.size() + 1;
    if (rays) {
      read_states(reader, entry, answer);
    } else {
      read_sets(reader, entry, answer);
    }
    const char* const order = command == "critical" ? "upper" : "margin";
    for (const char* const key : keys) {
      const auto* const value = ResultReader::find(entry, key);
      answer.numbers.emplace_back(key, value);
      if (value == nullptr) continue;
      const double number = reader.number(entry, key);
      if (key == std::string_view(order)) answer.order = number;
    }
    if (ResultReader::find(entry, "reaction") != nullptr)
      answer.reaction = &reader.list(entry, "reaction", candidates);
    all.push_back(std::move(answer));
  }
  for (std::size_t i = 0; i < scenes.entries.size(); ++i)
    all.at(scenes.entries[i]).scene = &scenes.scenes[i];
  return all;
}

}  // namespace kusabi::run
