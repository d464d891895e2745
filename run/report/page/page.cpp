// Sections of a page, from the verdict to the origin of the result.
#include "run/report/page/page.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "answer/words.hpp"
#include "pictures/html/markup.hpp"
#include "pictures/svg/inline_picture.hpp"
#include "run/report/answers.hpp"
#include "run/report/facts.hpp"
#include "run/report/first_sentence.hpp"
#include "run/report/gallery.hpp"
#include "run/report/limit_section.hpp"
#include "run/report/page/page_parts.hpp"
#include "run/report/page/page_script.hpp"
#include "run/report/page/turning_script.hpp"
#include "run/report/problem_facts.hpp"
#include "run/report/sweep_section.hpp"
#include "run/results/hold_chart.hpp"
#include "run/results/result_scenes.hpp"
#include "run/results/result_verdict.hpp"

namespace kusabi::run {
namespace {

using pictures::Markup;

// The answer in a sentence, the verdict, and all that qualifies it.
void add_verdict(Markup& page, const answer::Verdict& verdict, const std::string& sentence) {
  if (!sentence.empty()) page.element("p", sentence, {{"id", "answer"}});
  page.element("p", answer::headline(verdict), {{"id", "verdict"}});
  std::vector<std::string> sentences;
  for (const auto& each : verdict.warnings) sentences.push_back("Warning: " + each);
  add_list(page, "warnings", sentences);
  sentences.clear();
  for (const auto& each : answer::reservations(verdict)) sentences.push_back(each.sentence);
  add_list(page, "reservations", sentences);
  // Names of the first way are in the sentence already; a state under load needs its explanation.
  if (!sentence.empty() && !std::holds_alternative<answer::HoldingBracket>(verdict.answer)) return;
  for (const auto& each : verdict.details) page.element("p", each);
}

// Facts, and the undeformed structure.
void add_problem_section(Markup& page, const ResultReader& reader, const ResultScenes& scenes,
                         bool with_legend) {
  page.open("section", {{"id", "problem"}}).element("h2", "Problem");
  page.verbatim(
      inline_svg({"structure", "The undeformed structure",
                  fmt::format("{} nodes, {} contact candidates", scenes.structure.positions.cols(),
                              scenes.structure.candidates.size()),
                  true},
                 scenes.structure));
  add_problem(page, reader);
  if (with_legend && !scenes.scenes.empty()) {
    page.element("h3", "Legend of the pictures");
    page.verbatim(inline_legend(
        {"legend", "Legend", "Legend of the pictures; pointing at a dot shows its name."},
        pictures::common_legend(scenes.scenes)));
  }
  page.close();
}

// Both bounds with their standing.
void add_bracket(Markup& page, const answer::CriticalBracket& found) {
  page.open("section", {{"id", "bracket"}}).element("h2", "Critical friction coefficient");
  auto facts = ResultJson::object();
  const auto take = [&](const std::optional<support::Bound>& bound, const std::string& name) {
    if (!bound) return;
    const bool proved = bound->standing == support::Standing::proved;
    facts[fmt::format("{} ({})", name, proved ? "proved" : "computed, not proved")] = bound->value;
  };
  take(found.bracket.lower, "cannot stick at");
  take(found.bracket.upper, "sticks at");
  add_facts(page, "Bracket", facts);
  page.close();
}

void add_held_loads(Markup& page, const ResultReader& reader, const answer::Verdict& verdict) {
  const auto chart = hold_chart(reader, answer::headline(verdict));
  if (!chart) return;
  page.open("section", {{"id", "loads"}}).element("h2", "Loads that can be held");
  page.verbatim(inline_chart("held", *chart));
  page.close();
}

}  // namespace

std::string report_page(const ResultReader& reader) {
  auto list = answer_list(reader);
  const auto scenes = chosen_scenes(reader, {.maximum = max_pictures, .entries = pictured(list)});
  attach(scenes, list.answers);
  const auto* const leading = list.answers.empty() ? nullptr : &list.answers[list.order.front()];
  const auto command = reader.text(reader.all(), "command");
  Markup page;
  begin_page(page, scenes.picture.title + " · kusabi " + command);
  page.open("header").element("h1", scenes.picture.title);
  const auto verdict = result_verdict(reader);
  add_verdict(page, verdict, first_sentence(reader, verdict, leading, list.names));
  page.close().open("main");
  if (leading != nullptr) add_leading(page, reader, list);
  if (const auto* const found = std::get_if<answer::CriticalBracket>(&verdict.answer))
    add_bracket(page, *found);
  if (command == "limit") add_limit(page, reader, scenes);
  if (command == "sweep") add_sweep(page, reader);
  if (is_charted_hold(reader)) add_held_loads(page, reader, verdict);
  if (list.answers.size() > 1) add_gallery(page, reader, list);
  add_problem_section(page, reader, scenes, leading == nullptr);
  page.open("section", {{"id", "origin"}}).element("h2", "Details of the run");
  page.open("details").element("summary", "Options, counts and fingerprints");
  add_origin(page, reader);
  page.close().close().close();
  page.open("script").verbatim(page_script).verbatim(turning_script).close();
  page.close().close();
  return page.text();
}

}  // namespace kusabi::run
