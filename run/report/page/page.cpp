// Sections of a page, from the verdict to the origin of the result.
#include "run/report/page/page.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "pictures/html/markup.hpp"
#include "pictures/svg/inline_picture.hpp"
#include "run/report/answers.hpp"
#include "run/report/facts.hpp"
#include "run/report/gallery.hpp"
#include "run/report/hold_section.hpp"
#include "run/report/limit_section.hpp"
#include "run/report/page/page_parts.hpp"
#include "run/report/page/page_script.hpp"
#include "run/report/page/turning_script.hpp"
#include "run/report/problem_facts.hpp"
#include "run/report/sweep_section.hpp"
#include "run/results/hold_chart.hpp"
#include "run/results/result_scenes.hpp"

namespace kusabi::run {
namespace {

using pictures::Markup;

// The answer of the run, and all that qualifies it, in its words.
void add_verdict(Markup& page, const ResultReader& reader) {
  const auto& verdict = reader.at(reader.all(), "verdict");
  page.element("p", reader.sentence(), {{"id", "verdict"}});
  for (const auto& each : reader.names(verdict, "details"))
    page.element("p", each, {{"class", "detail"}});
  add_list(page, "reservations", reader.names(verdict, "reservations"));
  std::vector<std::string> warnings;
  for (const auto& each : reader.names(reader.all(), "warnings"))
    warnings.push_back("Warning: " + each);
  add_list(page, "warnings", warnings);
}

// Facts, and the undeformed structure.
void add_problem_section(Markup& page, const ResultReader& reader, const ResultScenes& scenes) {
  page.open("section", {{"id", "problem"}}).element("h2", "Problem");
  page.verbatim(inline_svg(
      {"structure", "The undeformed structure",
       fmt::format("{}, {}", answer::counted(scenes.structure.positions.cols(), "node"),
                   answer::counted(scenes.structure.candidates.size(), "contact candidate")),
       true},
      scenes.structure));
  add_problem(page, reader);
  page.close();
}

// Both bounds of a friction coefficient with their standing, if there is one.
void add_bracket(Markup& page, const ResultReader& reader) {
  const auto& result = reader.at(reader.all(), "result");
  const auto* const critical = ResultReader::find(result, "critical_friction");
  const auto* const holding = ResultReader::find(result, "holding_friction");
  if (critical == nullptr && holding == nullptr) return;
  const auto& bracket = critical != nullptr ? *critical : *holding;
  page.open("section", {{"id", "bracket"}});
  page.element("h2", fmt::format("{} {}", critical ? "Critical" : "Holding",
                                 answer::friction_name(has_own_friction(reader))));
  begin_facts(page, "Bracket");
  add_bound_fact(page, reader, critical ? "cannot stick at" : "cannot be held at", bracket,
                 "lower");
  add_bound_fact(page, reader, critical ? "sticks at" : "can be held at", bracket, "upper");
  if (!reader.bound(bracket, "lower") && !reader.bound(bracket, "upper"))
    add_fact(page, fmt::format("undecided whether it can {}", critical ? "stick" : "be held"),
             fmt::format("from 0 to {}", reader.number(result, "maximum")));
  end_table(page);
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
  add_verdict(page, reader);
  page.close().open("main");
  if (leading != nullptr) add_leading(page, reader, list);
  if (command == "critical" || command == "hold") add_bracket(page, reader);
  if (command == "limit") add_limit(page, reader, scenes);
  if (command == "sweep") add_sweep(page, reader);
  if (command == "hold") {
    add_load_cases(page, reader);
    add_held_loads(page, reader, reader.sentence());
    add_exclusions(page, reader);
  }
  if (list.answers.size() > 1) add_gallery(page, reader, list);
  add_problem_section(page, reader, scenes);
  page.open("section", {{"id", "origin"}}).element("h2", "Details of the run");
  page.open("details").element("summary", "Options, counts and fingerprints");
  add_origin(page, reader);
  page.close().close().close();
  page.open("script").verbatim(page_script).verbatim(turning_script).close();
  page.close().close();
  return page.text();
}

}  // namespace kusabi::run
