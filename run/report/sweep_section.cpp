// Friction: a staircase and its patterns. Loads: a piecewise linear curve.
#include "run/report/sweep_section.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "answer/words.hpp"
#include "pictures/svg/chart.hpp"
#include "run/report/facts.hpp"
#include "run/report/load_curve.hpp"
#include "run/results/alpha_unit.hpp"
#include "run/results/sweep_result.hpp"

namespace kusabi::run {
namespace {

using pictures::Markup;

class SweepSection {
 public:
  SweepSection(Markup& page, const ResultReader& reader)
      : page_(page), reader_(reader), result_(reader.at(reader.all(), "result")) {}

  void add() {
    const bool loads = sweeps_loads(reader_);
    page_.open("section", {{"id", "sweep"}});
    page_.element("h2", loads ? "Over the uncertainty of loads" : "Over the friction coefficient");
    if (const auto chart = sweep_chart(reader_, reader_.sentence()))
      page_.verbatim(inline_chart("curve", *chart));
    if (loads) {
      nominal();
      load_points();
      const auto unit = unit_of_alpha(reader_);
      add_load_curve(page_, reader_, "curve", unit ? "α, " + *unit : "α", "some admissible load");
    } else {
      friction_points();
      steps();
      patterns();
    }
    page_.close();
  }

 private:
  void number(const ResultJson& object, const char* key) {
    page_.open("td");
    add_number(page_, ResultReader::find(object, key), many_digits, rounding_of(key));
    page_.close();
  }
  /// The bound and its standing.
  void bound(const ResultJson& bracket, const char* key) {
    page_.open("td");
    add_bound(page_, reader_, &bracket, key);
    page_.close();
    words(standing_of(reader_, &bracket, key));
  }
  /// Lower and upper bound; nothing if there is none.
  void bracket(const ResultJson* ends) {
    page_.open("td");
    if (ends != nullptr) {
      add_number(page_, &reader_.at(*ends, "lower"), many_digits, Rounding::down);
      page_.words(" … ");
      add_number(page_, &reader_.at(*ends, "upper"), many_digits, Rounding::up);
    }
    page_.close();
  }
  void words(const std::string& text) { page_.element("td", text); }
  void names(const ResultJson& object, const char* key) {
    words(joined(reader_.names(object, key)));
  }
  // The count, or its known part.
  void counts(const ResultJson& counted) {
    for (const char* const key : {"count", "known", "open"}) {
      page_.open("td");
      add_count(page_, ResultReader::find(counted, key));
      page_.close();
    }
  }

  void friction_points() {
    const auto& points = reader_.list(result_, "points");
    if (points.empty() && reader_.list(result_, "staircase").empty())
      page_.element("p", "No count of sign patterns is known.");
    if (points.empty()) return;
    begin_table(page_, "Sign patterns at the given points",
                {answer::friction_name(has_own_friction(reader_)), "count", "known", "undecided"});
    for (const auto& point : points) {
      page_.open("tr");
      number(point, "mu");
      counts(point);
      page_.close();
    }
    end_table(page_);
  }

  void steps() {
    const auto& steps = reader_.list(result_, "staircase");
    if (steps.empty()) return;
    begin_table(page_, "Intervals with a constant number of sign patterns",
                {"from", "to", "count", "known", "undecided"});
    for (const auto& step : steps) {
      page_.open("tr");
      number(step, "from");
      number(step, "to");
      counts(step);
      page_.close();
    }
    end_table(page_);
  }

  void patterns() {
    const auto& patterns = reader_.list(result_, "patterns");
    const auto& open = reader_.list(result_, "open");
    if (patterns.empty() && open.empty()) return;
    begin_table(page_, "Friction coefficients at which patterns begin to stick",
                {"number", "cannot stick at μ", "sticks at μ", "in contact", "separated", "state",
                 "part of a larger one"});
    std::size_t count = 0;
    for (const auto& pattern : patterns) {
      page_.open("tr").element("th", std::to_string(++count), {{"scope", "row"}});
      number(pattern, "lower");
      number(pattern, "upper");
      names(pattern, "contact");
      names(pattern, "separated");
      const auto state = reader_.text(pattern, "state");
      words(state == "feasible" ? "solid" : state);
      bracket(ResultReader::find(pattern, "absorbed"));
      page_.close();
    }
    for (const auto& leaf : open) {
      page_.open("tr").element("th", "–", {{"scope", "row"}});
      number(leaf, "lower");
      words("?");
      names(leaf, "contact");
      names(leaf, "separated");
      words("open");
      words("");
      page_.close();
    }
    end_table(page_);
  }

  void load_points() {
    const auto& points = reader_.list(result_, "points");
    if (points.empty()) {
      page_.element("p", "No point was computed before the early end.");
      return;
    }
    const auto unit = unit_of_alpha(reader_);
    begin_table(
        page_, "Worst-case load factor at the given points",
        {unit ? "α, " + *unit : "α", "at least", "standing", "at most", "standing", "state"});
    for (const auto& point : points) {
      page_.open("tr");
      number(point, "alpha");
      for (const char* const key : {"lower", "upper"}) bound(reader_.at(point, "maximum"), key);
      const auto state = reader_.text(point, "state");
      words(state == "not-carried" ? "some admissible load is carried at no factor" : state);
      page_.close();
    }
    end_table(page_);
  }

  // The factor without uncertainty, and that there is none.
  void nominal() {
    const auto* const at_none = ResultReader::find(result_, "nominal_at_none");
    const auto* const bound = ResultReader::find(result_, "nominal");
    begin_facts(page_, "Without uncertainty");
    if (at_none != nullptr)
      add_fact(page_, "nominal dead load", "carried at no factor, " + at_none->get<std::string>());
    else if (bound == nullptr)
      add_fact(page_, "nominal load factor", "not found");
    else
      add_bound_fact(page_, reader_, "nominal load factor, at least", {{"lower", *bound}}, "lower");
    end_table(page_);
  }

  Markup& page_;
  const ResultReader& reader_;
  const ResultJson& result_;
};

}  // namespace

void add_sweep(Markup& page, const ResultReader& reader) {
  SweepSection(page, reader).add();
}

}  // namespace kusabi::run
