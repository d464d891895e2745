// A row for each interval, and for each friction coefficient without any; for each grip range; for
// each piece of a diagram.
#include "run/report/hold_section.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "answer/words.hpp"
#include "pictures/svg/chart.hpp"
#include "pictures/svg/inline_picture.hpp"
#include "run/output/rounded_within.hpp"
#include "run/report/facts.hpp"
#include "run/results/hold_chart.hpp"
#include "run/results/result_scenes.hpp"

namespace kusabi::run {
namespace {

using pictures::Markup;

void add_end(Markup& page, const ResultJson* end, const std::string& shown) {
  page.open("td");
  if (end == nullptr) {
    page.words(shown);
  } else {
    page.element("data", shown, {{"value", end->dump()}});
  }
  page.close();
}

// That of a word of the file.
support::Standing standing_in(const std::string& word) {
  return support::proved_if(word == answer::standing_word(support::Standing::proved));
}

answer::HoldingGrip grip_in(const ResultReader& reader, const ResultJson& grip) {
  const auto standing = [&](const char* key) { return standing_in(reader.text(grip, key)); };
  const auto bracket = [&](const char* key) {
    const auto& own = reader.at(grip, key);
    const auto bound = [&](const char* end) -> std::optional<support::Bound> {
      const auto value = reader.bound(own, end);
      if (!value) return {};
      return support::Bound{*value, standing_in(standing_of(reader, &own, end))};
    };
    return support::Bracket{bound("lower"), bound("upper")};
  };
  return {.held = reader.at(grip, "held") == true,
          .standing = standing("standing"),
          .minimum = bracket("minimum"),
          .maximum = bracket("maximum"),
          .unbounded = reader.at(grip, "unbounded") == true,
          .unbounded_standing = standing("unbounded_standing")};
}

std::string standing_of_none(const ResultReader& reader, const ResultJson& point) {
  if (ResultReader::find(point, "outside") == nullptr) return answer::none_standing_words({});
  return answer::none_standing_words(standing_in(reader.text(point, "outside")));
}

// The ends of an interval, which are held.
void add_ends(Markup& page, const ResultReader& reader, const ResultJson& interval) {
  const auto [low, high] = held_ends(reader, interval);
  const auto [from, to] = held_range(reader, interval);
  const auto shown = shown_ends(from, to, many_digits);
  add_end(page, low, shown.low);
  add_end(page, high, shown.high);
}

// Rows of a table begin with the friction coefficient.
void begin_row(Markup& page, const ResultReader& reader, const ResultJson& point) {
  page.open("tr").open("td");
  add_number(page, &reader.at(point, "friction"), many_digits);
  page.close();
}

void add_intervals(Markup& page, const ResultReader& reader, const ResultJson& points) {
  if (points.empty()) {
    page.element("p", "No coefficient was answered before the early end.");
    return;
  }
  const bool reference = reader.at(points.front(), "of_reference") == true;
  begin_table(page,
              reference ? "Factors of the reference load that can be held"
                        : "Friction coefficients at which the dead load can be held",
              {answer::friction_name(has_own_friction(reader)), "from", "to", "standing",
               "in contact at an end"});
  for (const auto& point : points) {
    const auto& intervals = reader.list(point, "intervals");
    for (const auto& each : intervals) {
      begin_row(page, reader, point);
      add_ends(page, reader, each);
      page.element("td", reader.text(each, "standing"));
      const auto* const pattern = ResultReader::find(each, "pattern");
      page.element("td", pattern == nullptr ? "–" : joined(reader.names(*pattern, "contact")));
      page.close();
    }
    if (!intervals.empty()) continue;
    begin_row(page, reader, point);
    page.element("td", "–").element("td", "–").element("td", standing_of_none(reader, point));
    page.element("td", "–").close();
  }
  end_table(page);
}

// Nothing if they were not requested.
void add_grips(Markup& page, const ResultReader& reader, const ResultJson& points) {
  const auto grip_of = [](const ResultJson& point) { return ResultReader::find(point, "grip"); };
  if (std::ranges::none_of(points, grip_of)) return;
  begin_table(page, "Sum of the normal reactions under the dead load alone",
              {answer::friction_name(has_own_friction(reader)), "at least", "standing", "at most",
               "standing"});
  for (const auto& point : points) {
    const auto* const grip = grip_of(point);
    if (grip == nullptr) continue;
    begin_row(page, reader, point);
    const auto [least, most] = answer::grip_standing_words(grip_in(reader, *grip));
    const auto add = [&](const char* bracket, const char* end, const std::string& standing) {
      page.open("td");
      add_bound(page, reader, &reader.at(*grip, bracket), end);
      page.close().element("td", standing);
    };
    add("minimum", "lower", least);
    add("maximum", "upper", most);
    page.close();
  }
  end_table(page);
}

// Pairs of factors as text: "(1, 2) (3, 4)".
std::string pairs_text(const ResultReader& reader, const ResultJson& piece, const char* key) {
  std::string text;
  for (const auto& each : reader.list(piece, key)) {
    const auto pair = reader.vector(each, 2);
    text += fmt::format("{}({:.6g}, {:.6g})", text.empty() ? "" : " ", pair.x(), pair.y());
  }
  return text.empty() ? "–" : text;
}

void add_pieces(Markup& page, const ResultReader& reader, const ResultJson& pieces) {
  begin_table(page, "Pieces: all pairs of factors between the vertices and along the directions",
              {"piece", "vertices", "directions", "in contact", "remark"});
  std::size_t number = 0;
  for (const auto& piece : pieces) {
    const auto* const fine = ResultReader::find(piece, "fine");
    page.open("tr").element("td", std::to_string(++number));
    page.element("td", pairs_text(reader, piece, "vertices"));
    page.element("td", pairs_text(reader, piece, "rays"));
    page.element("td", joined(reader.names(reader.at(piece, "pattern"), "contact")));
    page.element("td", reader.at(piece, "everything") == true ? "all pairs"
                       : fine != nullptr && *fine == false    ? "may be larger"
                                                              : "–");
    page.close();
  }
  end_table(page);
}

// Bodies that move, and contacts that slide and open.
void add_motion(Markup& page, const ResultReader& reader, const ResultJson& motion) {
  begin_facts(page, "Motion");
  if (const double factor = reader.number(motion, "factor"); std::isnormal(factor))
    add_fact(page, "factor of the reference load", fmt::format("{:.10g}", factor));
  for (const auto& body : reader.list(motion, "bodies"))
    add_fact(page, "the body of node " + reader.text(body, "node"), reader.text(body, "motion"));
  const auto names = [&](const char* key, const char* label) {
    const auto list = reader.names(motion, key);
    if (!list.empty()) add_fact(page, label, joined(list));
  };
  names("sliding", "contact slides at");
  names("opening", "contact opens at");
  end_table(page);
}

}  // namespace

void add_load_cases(Markup& page, const ResultReader& reader) {
  const auto& result = reader.at(reader.all(), "result");
  const bool pairs = ResultReader::find(result, "pieces") != nullptr;
  if (pairs || ResultReader::find(result, "cases") == nullptr) return;
  const auto& cases = reader.list(result, "cases");
  const bool friction = ResultReader::find(result, "holding_friction") != nullptr;
  const auto* const of_reference = ResultReader::find(result, "of_reference");
  const bool reference = of_reference != nullptr && *of_reference == true;
  page.open("section", {{"id", "load-cases"}}).element("h2", "Load cases");
  if (friction) {
    begin_table(page,
                "Friction that each load case needs: " +
                    std::string(answer::friction_name(has_own_friction(reader))),
                {"load case", "cannot be held at", "standing", "can be held at", "standing"});
  } else if (reference) {
    begin_table(page, "Factors of the reference load that each load case holds",
                {"load case", "from", "to", "standing"});
  } else {
    begin_table(page, "Load cases in which the dead load can be held",
                {"load case", "held", "standing"});
  }
  for (const auto& each : cases) {
    const auto begin = [&] { page.open("tr").element("td", reader.text(each, "case")); };
    if (friction) {
      begin();
      const auto& bracket = reader.at(each, "holding_friction");
      for (const char* const end : {"lower", "upper"}) {
        page.open("td");
        add_bound(page, reader, &bracket, end);
        page.close().element("td", standing_of(reader, &bracket, end));
      }
      page.close();
      continue;
    }
    if (!reference) {
      const auto& held = reader.list(each, "intervals");
      begin();
      page.element("td", held.empty() ? "no" : "yes");
      page.element("td", held.empty() ? standing_of_none(reader, each)
                                      : reader.text(held.front(), "standing"));
      page.close();
      continue;
    }
    for (const auto& interval : reader.list(each, "intervals")) {
      begin();
      add_ends(page, reader, interval);
      page.element("td", reader.text(interval, "standing")).close();
    }
    if (!reader.list(each, "intervals").empty()) continue;
    begin();
    page.element("td", "–")
        .element("td", "–")
        .element("td", standing_of_none(reader, each))
        .close();
  }
  end_table(page);
  page.close();
}

void add_exclusions(Markup& page, const ResultReader& reader) {
  const auto scenes = exclusion_scenes(reader);
  if (scenes.empty()) return;
  const auto& motions =
      reader.list(reader.at(reader.all(), "result"), "excluding_motions", scenes.size());
  const auto& units = reader.at(reader.at(reader.all(), "problem"), "units");
  page.open("section", {{"id", "why-not"}}).element("h2", "Why other loads cannot be held");
  page.element(
      "p",
      "On each of these motions the load does positive work, and reactions within their friction "
      "cones can only add to it, whatever the stiffness. It shows that the load cannot be held; it "
      "is not the motion that follows.");
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const auto id = fmt::format("why-not-{}", k + 1);
    page.open("div", {{"class", "beside"}}).open("figure");
    page.verbatim(
        inline_svg({id, scenes[k].name, "The structure on this motion", true}, scenes[k]));
    page.verbatim(inline_legend(
        {id + "-legend", "Legend", "Legend of the picture."},
        legend(scenes[k], {reader.text(units, "length"), reader.text(units, "force")})));
    page.close().open("div");
    add_motion(page, reader, motions[k]);
    page.close().close();
  }
  page.close();
}

void add_held_loads(Markup& page, const ResultReader& reader, const std::string& sentence) {
  const auto& result = reader.at(reader.all(), "result");
  if (ResultReader::find(result, "holding_friction") != nullptr) return;
  page.open("section", {{"id", "loads"}}).element("h2", "Loads that can be held");
  if (is_charted_hold(reader))
    page.verbatim(inline_chart("held", hold_chart(reader, sentence).value()));
  if (ResultReader::find(result, "pieces") != nullptr) {
    add_pieces(page, reader, reader.list(result, "pieces"));
  } else {
    const auto points = ResultReader::find(result, "points") != nullptr
                            ? reader.list(result, "points")
                            : ResultJson::array({result});
    add_intervals(page, reader, points);
    add_grips(page, reader, points);
  }
  page.close();
}

}  // namespace kusabi::run
