// A row for each interval, and for each friction coefficient without any.
#include "run/report/hold_section.hpp"

#include "pictures/svg/chart.hpp"
#include "run/report/facts.hpp"
#include "run/results/hold_chart.hpp"
#include "run/results/result_scenes.hpp"

namespace kusabi::run {
namespace {

using pictures::Markup;

// @param key "low" or "high"
void add_end(Markup& page, const ResultJson* end, const char* key) {
  page.open("td");
  if (end == nullptr) {
    page.words("no end");
  } else {
    add_number(page, end, many_digits, rounding_of(key));
  }
  page.close();
}

void add_intervals(Markup& page, const ResultReader& reader, const ResultJson& points) {
  begin_table(page, "Factors of the reference load that can be held",
              {"friction coefficient", "from", "to", "in contact at an end"});
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
      add_end(page, low, "low");
      add_end(page, high, "high");
      const auto* const pattern = ResultReader::find(each, "pattern");
      page.element("td", pattern == nullptr ? "–" : joined(reader.names(*pattern, "contact")));
      page.close();
    }
    if (!intervals.empty()) continue;
    begin_row();
    page.element("td", "none is known").element("td", "–").element("td", "–").close();
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
