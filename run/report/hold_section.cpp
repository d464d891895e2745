// A row for each interval, and for each friction coefficient without any.
#include "run/report/hold_section.hpp"

#include "answer/words.hpp"
#include "pictures/svg/chart.hpp"
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

// As in the table of the command.
const char* standing_of_interval(const ResultReader& reader, const ResultJson& interval) {
  const auto& below = reader.at(interval, "below");
  const auto& above = reader.at(interval, "above");
  const auto beyond = [&](const ResultJson& bracket, const char* held, const char* out) {
    return ResultReader::find(bracket, held) == nullptr
               ? support::Standing::proved
               : standing_in(standing_of(reader, &bracket, out));
  };
  return answer::interval_standing_word(
      standing_in(reader.text(interval, "standing")),
      both(beyond(below, "upper", "lower"), beyond(above, "lower", "upper")));
}

std::string standing_of_none(const ResultReader& reader, const ResultJson& point) {
  if (ResultReader::find(point, "outside") == nullptr) return answer::none_standing_words({});
  return answer::none_standing_words(standing_in(reader.text(point, "outside")));
}

void add_intervals(Markup& page, const ResultReader& reader, const ResultJson& points) {
  if (points.empty()) {
    page.element("p", "No coefficient was answered before the early end.");
    return;
  }
  begin_table(page, "Factors of the reference load that can be held",
              {"friction coefficient", "from", "to", "standing", "in contact at an end"});
  for (const auto& point : points) {
    const auto& mu = reader.at(point, "friction");
    const auto begin_row = [&] {
      page.open("tr").open("td");
      add_number(page, &mu, many_digits);
      page.close();
    };
    const auto& intervals = reader.list(point, "intervals");
    for (const auto& each : intervals) {
      begin_row();
      const auto [low, high] = held_ends(reader, each);
      const auto [from, to] = held_range(reader, each);
      const auto shown = shown_ends(from, to, many_digits);
      add_end(page, low, shown.low);
      add_end(page, high, shown.high);
      page.element("td", standing_of_interval(reader, each));
      const auto* const pattern = ResultReader::find(each, "pattern");
      page.element("td", pattern == nullptr ? "–" : joined(reader.names(*pattern, "contact")));
      page.close();
    }
    if (!intervals.empty()) continue;
    begin_row();
    page.element("td", "–").element("td", "–").element("td", standing_of_none(reader, point));
    page.element("td", "–").close();
  }
  end_table(page);
}

}  // namespace

void add_held_loads(Markup& page, const ResultReader& reader, const std::string& sentence) {
  const auto chart = hold_chart(reader, sentence);
  if (!chart) return;
  page.open("section", {{"id", "loads"}}).element("h2", "Loads that can be held");
  page.verbatim(inline_chart("held", *chart));
  const auto& result = reader.at(reader.all(), "result");
  if (ResultReader::find(result, "points") != nullptr)
    add_intervals(page, reader, reader.list(result, "points"));
  page.close();
}

}  // namespace kusabi::run
