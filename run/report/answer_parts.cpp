// Numbers are those of the file; names are shortened.
#include "run/report/answer_parts.hpp"

#include <fmt/format.h>

#include "run/report/facts.hpp"

namespace kusabi::run {

using pictures::Markup;

std::string title_of(const AnswerList& list, const Answer& answer) {
  auto thing = list.things.substr(0, list.things.size() - 1);
  thing.front() = static_cast<char>(thing.front() - 'a' + 'A');
  return fmt::format("{} {}{}", thing, answer.number, answer.load.empty() ? "" : ' ' + answer.load);
}

void open_answer(Markup& page, std::string_view tag, std::string_view kind, const Answer& answer,
                 std::size_t rank) {
  page.open(tag, {{"class", std::string(kind)},
                  {"id", fmt::format("answer-{}", answer.number)},
                  {"data-number", std::to_string(answer.number)},
                  {"data-rank", std::to_string(rank)},
                  {"data-order", answer.order ? fmt::format("{}", *answer.order) : ""},
                  {"data-size", std::to_string(answer.contact.size())},
                  {"data-contact", ResultJson(answer.contact).dump()}});
}

std::string meaning(const AnswerList& list, std::string_view key) {
  const bool loaded = list.things == "states";
  if (key == "margin") return "margin t*";
  if (key == "margin_upper") return "t* is at most";
  if (key == "lower") return loaded ? "cannot be held at μ" : "cannot stick at μ";
  if (key == "low") return "held from factor";
  if (key == "high") return "held to factor";
  return loaded ? "can be held at μ" : "sticks at μ";
}

void add_number(Markup& page, const AnswerNumber& number) {
  const auto& [key, value, text, standing] = number;
  const bool margin = key == "margin" || key == "margin_upper";
  if (text.empty())
    add_number(page, value, margin ? few_digits : many_digits, rounding_of(key));
  else
    page.element("data", text, {{"value", value->dump()}});
  if (!standing.empty()) page.words(fmt::format(" ({})", standing));
}

void add_needed(Markup& page, const Answer& answer) {
  if (!answer.needed) return add_number(page, nullptr);
  page.element("data", answer.needed_text, {{"value", ResultJson(*answer.needed).dump()}});
}

void add_terms(Markup& page, const AnswerList& list, const Answer& answer) {
  page.open("dl");
  const auto names = [&](const char* what, const std::vector<std::string>& set) {
    page.element("dt", what).element("dd", list.names.of(set));
  };
  names("in contact", answer.contact);
  names("separated", answer.separated);
  if (!answer.inactive.empty()) names("inactive", answer.inactive);
  if (!answer.state.empty()) page.element("dt", "remark").element("dd", answer.state);
  for (const auto& number : answer.numbers) {
    page.element("dt", meaning(list, number.key)).open("dd", {{"class", number.key}});
    add_number(page, number);
    page.close();
  }
  if (answer.needed) {
    page.element("dt", "reactions need μ").open("dd", {{"class", "needed"}});
    add_needed(page, answer);
    page.close();
    if (!answer.slips.empty()) names("slips first", answer.slips);
  }
  page.close();
}

void add_reactions(Markup& page, const ResultReader& reader, const AnswerList& list,
                   const Answer& answer) {
  if (answer.reaction == nullptr) return;
  constexpr const char* components[] = {"r_n", "r_t1", "r_t2"};
  const auto& problem = reader.at(reader.all(), "problem");
  const auto force = reader.text(reader.at(problem, "units"), "force");
  const auto& candidates = reader.list(problem, "contact");
  const auto d = static_cast<int>(reader.number(problem, "d"));
  page.open("details").element("summary", fmt::format("Reactions, {}", force));
  open_table(page, fmt::format("Reactions of {} along n and t, {}", title_of(list, answer), force));
  page.open("thead").open("tr").element("th", "candidate", {{"scope", "col"}});
  for (int axis = 0; axis < d; ++axis) page.element("th", components[axis], {{"scope", "col"}});
  page.close().close().open("tbody");
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto& row = (*answer.reaction)[i];
    if (reader.vector(row, d).isZero(0)) continue;
    page.open("tr").element("th", reader.text(candidates[i], "node"), {{"scope", "row"}});
    for (const auto& component : row) {
      page.open("td");
      add_number(page, &component);
      page.close();
    }
    page.close();
  }
  page.close().close().close().close();
}

}  // namespace kusabi::run
