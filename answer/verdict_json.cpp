// The key `verdict` of a result file, and the answer by its list of fields.
#include "answer/verdict_json.hpp"

#include "answer/ending.hpp"
#include "answer/schema.hpp"
#include "answer/words.hpp"

namespace kusabi::answer {
namespace {

/// A verdict with its sentences.
struct WrittenVerdict {
  static constexpr const char* title = "verdict";
  std::string sentence;
  std::vector<std::string> details, reservations;
  bool answered = false;
  int exit_code = 0;
  engine::Status ended{};
  std::optional<std::uint64_t> nodes_left{};
  std::vector<std::string> missing;

  static constexpr auto fields() {
    return std::tuple{
        field("sentence", &WrittenVerdict::sentence, "the answer"),
        field("details", &WrittenVerdict::details, "sentences that belong to it"),
        field("reservations", &WrittenVerdict::reservations,
              "what is open, then what is computed and not proved"),
        field("answered", &WrittenVerdict::answered, "nothing that was requested is open"),
        field("exit_code", &WrittenVerdict::exit_code),
        field("ended", &WrittenVerdict::ended, "of the searches"),
        field("nodes_left", &WrittenVerdict::nodes_left,
              "open nodes; null: the search ended early, and they are not counted"),
        field("missing", &WrittenVerdict::missing, "requested outputs that were not made")};
  }
};

}  // namespace

nlohmann::ordered_json verdict_json(const Verdict& verdict) {
  WrittenVerdict json{
      .sentence = headline(verdict),
      .details = verdict.details,
      .reservations = {},
      .answered = is_answered(verdict),
      .exit_code = static_cast<int>(exit_code(verdict)),
      .ended = verdict.ended,
      .nodes_left = verdict.ended == engine::Status::solved ? 0 : verdict.nodes_left,
      .missing = verdict.missing};
  for (const auto& each : reservations(verdict)) json.reservations.push_back(each.sentence);
  return written(json);
}

nlohmann::ordered_json answer_json(const Verdict& verdict) {
  return std::visit(
      []<class Answer>(const Answer& answer) -> nlohmann::ordered_json {
        if constexpr (HasKind<Answer>)
          return written(answer);
        else
          return nullptr;
      },
      verdict.answer);
}

namespace {

template <class... Each>
void add_kinds(const std::variant<Each...>* /*answers*/, nlohmann::ordered_json& definitions) {
  const auto add = [&]<class One>(const One* /*answer*/) {
    if constexpr (HasKind<One>)
      definitions[One::kind] = detail::object_schema<One>(definitions, false);
  };
  (add(static_cast<const Each*>(nullptr)), ...);
}

}  // namespace

nlohmann::ordered_json answer_definitions() {
  auto definitions = nlohmann::ordered_json::object();
  schema_of<WrittenVerdict>(definitions);
  add_kinds(static_cast<const AnyAnswer*>(nullptr), definitions);
  return definitions;
}

}  // namespace kusabi::answer
