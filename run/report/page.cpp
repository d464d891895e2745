// Sections of a page, from the verdict to the origin of the result.
#include "run/report/page.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "pictures/html/markup.hpp"
#include "pictures/svg/inline_picture.hpp"
#include "run/report/answers.hpp"
#include "run/report/facts.hpp"
#include "run/report/gallery.hpp"
#include "run/report/limit_section.hpp"
#include "run/report/page_script.hpp"
#include "run/report/page_style.hpp"
#include "run/report/sweep_section.hpp"
#include "run/results/result_scenes.hpp"
#include "run/results/result_verdict.hpp"
#include "run/verdict/words.hpp"

namespace kusabi::run {
namespace {

using pictures::Markup;

// Content security policy: the page loads nothing, whatever the file contains.
constexpr const char* nothing_from_elsewhere =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; base-uri 'none'; "
    "form-action 'none'";

void add_head(Markup& page, const std::string& title) {
  page.open("head").single("meta", {{"charset", "utf-8"}});
  page.single("meta",
              {{"http-equiv", "Content-Security-Policy"}, {"content", nothing_from_elsewhere}});
  page.single("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  page.single("meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  page.element("title", title);
  page.open("style").verbatim(page_style).verbatim(pictures::inline_style()).close();
  page.close();
}

void add_list(Markup& page, const char* id, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  page.open("ul", {{"id", id}});
  for (const auto& each : sentences) page.element("li", each);
  page.close();
}

void add_verdict(Markup& page, const Verdict& verdict) {
  page.element("p", headline(verdict), {{"id", "verdict"}});
  for (const auto& each : verdict.details) page.element("p", each);
  std::vector<std::string> sentences;
  for (const auto& each : reservations(verdict)) sentences.push_back(each.sentence);
  add_list(page, "reservations", sentences);
  sentences.clear();
  for (const auto& each : verdict.warnings) sentences.push_back("Warning: " + each);
  add_list(page, "warnings", sentences);
}

// Facts on one side, structure and legend on the other.
void add_problem_section(Markup& page, const ResultReader& reader, const ResultScenes& scenes) {
  page.open("section", {{"id", "problem"}}).element("h2", "Problem");
  page.verbatim(
      inline_svg({"structure", "The undeformed structure",
                  fmt::format("{} nodes, {} contact candidates", scenes.structure.positions.cols(),
                              scenes.structure.candidates.size()),
                  true},
                 scenes.structure));
  add_problem(page, reader);
  if (!scenes.scenes.empty()) {
    page.element("h3", "Legend of the pictures");
    page.verbatim(inline_legend(
        {"legend", "Legend", "Legend of the pictures; pointing at a dot shows its name."},
        scenes.scenes));
  }
  page.close();
}

// Both bounds with their standing.
void add_bracket(Markup& page, const CriticalBracket& found) {
  page.open("section", {{"id", "bracket"}}).element("h2", "Critical friction coefficient");
  auto facts = ResultJson::object();
  const auto take = [&](const std::optional<Bound>& bound, const std::string& name) {
    if (!bound) return;
    facts[name] = bound->value;
    facts[name + ": standing"] =
        bound->standing == Standing::proved ? "proved" : "computed, not proved";
  };
  take(found.bracket.lower, "cannot stick at");
  take(found.bracket.upper, "sticks at");
  add_facts(page, "Bracket", facts);
  page.close();
}

}  // namespace

std::string report_page(const ResultReader& reader) {
  const auto scenes = chosen_scenes(reader, {.most = most_pictures});
  const auto list = answers(reader, scenes);
  const auto command = reader.text(reader.all(), "command");
  Markup page;
  page.verbatim("<!DOCTYPE html>\n").open("html", {{"lang", "en"}});
  add_head(page, scenes.picture.title + " · kusabi " + command);
  page.open("body").open("header").element("h1", scenes.picture.title);
  const auto verdict = result_verdict(reader);
  add_verdict(page, verdict);
  page.close().open("main");
  if (const auto* const found = std::get_if<CriticalBracket>(&verdict.answer))
    add_bracket(page, *found);
  if (command == "limit") add_limit(page, reader, scenes);
  if (command == "sweep") add_sweep(page, reader);
  add_problem_section(page, reader, scenes);
  if (!list.empty()) add_gallery(page, reader, scenes.things, list);
  page.open("section", {{"id", "origin"}}).element("h2", "Details of the run");
  add_origin(page, reader);
  page.close().close();
  page.open("script").verbatim(page_script).close();
  page.close().close();
  return page.text();
}

}  // namespace kusabi::run
