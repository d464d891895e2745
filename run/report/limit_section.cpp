// Nominal and worst case side by side, if both exist.
#include "run/report/limit_section.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "answer/words.hpp"
#include "pictures/svg/inline_picture.hpp"
#include "run/report/facts.hpp"
#include "run/report/load_curve.hpp"
#include "run/results/alpha_unit.hpp"
#include "run/results/sweep_result.hpp"

namespace kusabi::run {
namespace {

using pictures::Markup;

class LimitSection {
 public:
  LimitSection(Markup& page, const ResultReader& reader, const ResultScenes& scenes)
      : page_(page),
        reader_(reader),
        result_(reader.at(reader.all(), "result")),
        problem_(reader.at(reader.all(), "problem")),
        scenes_(scenes) {}

  void add() {
    page_.open("section", {{"id", "factors"}}).element("h2", "Load factors");
    // The worst case, which is the answer if it is known, comes last in the file.
    for (auto scene = scenes_.scenes.rbegin(); scene != scenes_.scenes.rend(); ++scene)
      collapse(*scene);
    if (ResultReader::find(result_, "collapse_mode") == nullptr) critical_load(result_);
    single_losses();
    combinations();
    load_cases();
    factors();
    curves();
    utilisation();
    page_.close();
  }

 private:
  // "Collapse after the worst loss known, load case b, λ = 0.5".
  [[nodiscard]] std::string heading(const pictures::Scene& scene, bool loss) const {
    const auto* const load_case = ResultReader::find(result_, "case");
    const bool found =
        loss ? reader_.text(reader_.at(result_, "member_loss"), "standing") == proved_
             : scene.name != worst_case_ || reader_.text(reader_.all(), "status") == "solved";
    return fmt::format(
        "Collapse {} the {}{}{}, {}", loss ? "after" : "under", scene.name, found ? "" : " known",
        load_case == nullptr ? "" : ", load case " + load_case->get<std::string>(), scene.note);
  }

  // A large picture with its legend, and the members that yield beside it.
  void collapse(const pictures::Scene& scene) {
    const bool worst = scene.name == worst_case_;
    const bool loss = scene.name == "worst loss";
    const std::string id = loss ? "collapse-loss" : worst ? "collapse-worst" : "collapse-nominal";
    const auto& units = reader_.at(problem_, "units");
    page_.element("h3", heading(scene, loss));
    page_.open("div", {{"class", "beside"}}).open("figure");
    page_.verbatim(inline_svg(
        {id, "Collapse mode, " + scene.name, "The structure at collapse, " + scene.note, true},
        scene));
    page_.verbatim(inline_legend(
        {id + "-legend", "Legend", "Legend of the picture."},
        legend(scene, {reader_.text(units, "length"), reader_.text(units, "force")})));
    page_.close().open("div");
    if (loss) {
      const auto& found = reader_.at(result_, "member_loss");
      page_.element("p", "Lost: " + joined(reader_.names(result_, "lost")));
      mode(found, "collapse_mode");
      if (ResultReader::find(found, "critical_load") != nullptr) critical_load(found);
    } else {
      mode(result_, worst ? "collapse_mode" : "nominal_mode");
    }
    if (worst) critical_load(result_);
    page_.close().close();
  }

  // Rows of both bounds of a factor.
  void bounds(const ResultJson& bracket, const std::string& name) {
    add_bound_fact(page_, reader_, name + ", at least", bracket, "lower");
    add_bound_fact(page_, reader_, name + ", at most", bracket, "upper");
  }

  // Standing of a statement that follows from two bounds.
  [[nodiscard]] std::string of_both(const ResultJson& one, const ResultJson& other) const {
    return answer::standing_word(
        support::both(support::proved_if(reader_.text(one, "standing") == proved_),
                      support::proved_if(reader_.text(other, "standing") == proved_)));
  }

  // Rows on the factors that are carried: from which one on, or that there is none.
  // @param interval its `minimum` and `maximum` @return true if one is known to be carried
  bool carried(const ResultJson& interval, const std::string& loads) {
    const auto& from = reader_.at(interval, "minimum");
    const auto& to = reader_.at(interval, "maximum");
    const auto [low, low_out] =
        std::pair(reader_.bound(from, "upper"), reader_.bound(from, "lower"));
    const auto [high, high_out] = std::pair(reader_.bound(to, "lower"), reader_.bound(to, "upper"));
    if (low_out && high_out && *low_out > *high_out) {
      add_fact(page_, "factors at which " + loads + " is carried",
               "none, " + of_both(reader_.at(from, "lower"), reader_.at(to, "upper")));
      return false;
    }
    if (low && high && *low <= *high) {
      add_bound_fact(page_, reader_, loads + " is carried at factors from", from, "upper");
      return true;
    }
    const auto factors = "factors at which " + loads + " is carried";
    add_fact(page_, factors, "undecided whether there are any");
    add_bound_fact(page_, reader_, factors + ", at least", from, "lower");
    add_bound_fact(page_, reader_, factors + ", at most", to, "upper");
    return false;
  }

  void factors() {
    const auto* const load_case = ResultReader::find(result_, "case");
    const bool losses = ResultReader::find(result_, "lost_at_most") != nullptr;
    const bool worst = !losses && ResultReader::find(result_, "uncertain") != nullptr;
    const bool nominal = ResultReader::find(result_, "nominal") != nullptr;
    const bool struts = ResultReader::find(result_, "struts") != nullptr;
    const std::string upper = struts ? ", if all struts kept their full strength" : "";
    begin_facts(page_, "Factors of the reference load");
    if (load_case != nullptr) add_fact(page_, "load case", reader_.text(result_, "case"));
    if (nominal)
      nominal_factors(worst, struts, upper);
    else if (ResultReader::find(result_, "carried_at_none") != nullptr)
      add_fact(page_, "nominal dead load is carried",
               "at no factor, " + reader_.text(result_, "carried_at_none"));
    else
      add_fact(page_, "nominal load factor", "not found");
    if (losses) loss_factors();
    if (ResultReader::find(result_, "alpha") != nullptr) {
      const auto unit = unit_of_alpha(reader_);
      number_fact(unit ? "α, half-width of each uncertain load, " + *unit
                       : "α, half-width of the factor of each uncertain load",
                  reader_.at(result_, "alpha"));
    }
    if (worst && nominal) worst_case(struts, upper);
    critical_interval(struts);
    end_table(page_);
  }

  // Factors that remain after the loss of members, in all load cases.
  void loss_factors() {
    const auto& loss = result_;
    const auto lost = joined(reader_.names(loss, "lost"));
    add_fact(page_, "worst loss known", lost);
    if (ResultReader::find(loss, "fatal") != nullptr) {
      add_fact(page_,
               reader_.at(loss, "uncertain") == true ? "some admissible load is then carried"
                                                     : "the dead load is then carried",
               "at no factor, " + reader_.text(loss, "fatal"));
      return;
    }
    const auto& factor = reader_.at(loss, "factor");
    bounds(factor, "load factor after the worst loss");
    if (!reader_.bound(factor, "lower"))
      add_fact(page_, "load factor after the worst loss, at least", "not known");
    if (!reader_.bound(factor, "upper"))
      add_fact(page_, "load factor after the worst loss, at most", "not known");
    if (ResultReader::find(loss, "target") == nullptr) return;
    const auto* const reached = ResultReader::find(loss, "reached");
    add_fact(page_,
             fmt::format("load factor after each loss at least {}", reader_.number(loss, "target")),
             reached == nullptr ? "open"
             : *reached == true ? "yes"
                                : "no");
  }

  // The curves of --curve and --curve-load.
  void curves() {
    struct Curve {
      const char* key;
      const char* name;
      const char* load;  // loads of the factors
    };
    for (const auto& [key, name, load] :
         {Curve{"curve", "beta times the critical load", "this load"},
          Curve{"worst_curve", "Worst case for beta times alpha", "some admissible load"},
          Curve{"load_curve", "beta times the load of --curve-load", "this load"}}) {
      if (ResultReader::find(result_, key) == nullptr) continue;
      page_.element("h3", name);
      const auto chart = load_curve_chart(reader_, key, name);
      if (!chart) {
        page_.element("p", "No piece of the curve was found.");
        continue;
      }
      page_.verbatim(inline_chart(key, *chart));
      add_load_curve(page_, reader_, key, "β", load);
    }
  }

  void nominal_factors(bool worst, bool struts, const std::string& upper) {
    const auto* const own = ResultReader::find(result_, "nominal_bounds");
    const auto& bounds_of = own != nullptr ? *own : result_;  // the same, if they are the answer
    const bool combinations = worst && ResultReader::find(result_, "critical_factors") != nullptr;
    const std::string name =
        (combinations ? "with all factors of actions in the middle of their ranges: load factor"
                      : "nominal load factor") +
        upper;
    const auto& largest = reader_.at(bounds_of, "maximum");
    bounds(largest, name);
    if (!reader_.bound(largest, "lower") && !reader_.bound(largest, "upper"))
      number_fact(name + ", " + answer::standing_word(support::Standing::computed),
                  reader_.at(result_, "nominal"));
    if (!combinations)
      carried(bounds_of, std::string("nominal load") +
                             (struts ? ", if all struts kept their full strength," : ""));
  }

  void number_fact(const std::string& name, const ResultJson& number) {
    page_.open("tr").element("th", name, {{"scope", "row"}}).open("td");
    add_number(page_, &number, many_digits);
    page_.close().close();
  }

  // With struts, the factors at residual strength are carried.
  void worst_case(bool struts, const std::string& upper) {
    const bool all = ResultReader::find(result_, "cases") != nullptr;
    const std::string loads =
        all ? "every admissible load in every load case" : "every admissible load";
    if (ResultReader::find(result_, "carried_at_none") != nullptr) {
      add_fact(page_,
               all ? "some admissible load in some load case is carried"
                   : "some admissible load is carried",
               "at no factor, " + reader_.text(result_, "carried_at_none"));
      return;
    }
    const auto& largest = reader_.at(result_, "maximum");
    if (!struts) bounds(largest, "worst case");
    if (struts) {
      add_bound_fact(page_, reader_, "worst case" + upper + ", at most", largest, "upper");
      add_fact(page_, "strength of struts for the carried factors", "residual strength");
    }
    if (carried(result_, loads))
      add_bound_fact(page_, reader_, loads + " is carried at factors up to", largest, "lower");
  }

  // The least and the largest factor of the critical load, which are computed.
  void critical_interval(bool struts) {
    if (ResultReader::find(result_, "critical_interval") == nullptr) return;
    const auto& interval = reader_.list(result_, "critical_interval", 2);
    const std::string name = fmt::format("critical load{} is carried at factors ({})",
                                         struts ? ", if all struts kept their full strength," : "",
                                         answer::standing_word(support::Standing::computed));
    page_.open("tr").element("th", name, {{"scope", "row"}}).open("td");
    add_number(page_, &interval.front(), many_digits, Rounding::up);
    page_.words(" … ");
    add_number(page_, &interval.back(), many_digits, Rounding::down);
    page_.close().close();
  }

  // The load factor after the loss of each member, the smallest first.
  void single_losses() {
    const auto* const loss = ResultReader::find(result_, "member_loss");
    if (loss == nullptr || ResultReader::find(*loss, "single") == nullptr) return;
    std::vector<const ResultJson*> singles;
    for (const auto& each : reader_.list(*loss, "single")) singles.push_back(&each);
    if (singles.empty()) return;
    const auto value = [&](const ResultJson* single) {
      if (ResultReader::find(*single, "factor") != nullptr)
        return reader_.number(*single, "factor");
      return reader_.text(*single, "state") == "not-carried" ? -HUGE_VAL : HUGE_VAL;
    };
    std::ranges::stable_sort(singles, {}, value);
    const auto* const load_case = ResultReader::find(result_, "case");
    const auto in_case =
        load_case == nullptr ? std::string() : " in load case " + load_case->get<std::string>();
    page_.open("details").element("summary", "Load factor after the loss of one member" + in_case);
    const auto* const uncertain_loads = ResultReader::find(result_, "uncertain");
    const bool uncertain = uncertain_loads != nullptr && *uncertain_loads == true;
    begin_table(
        page_,
        (uncertain ? "Upper bounds of the load factor after the loss of one member, computed"
                   : "Load factor after the loss of one member, computed") +
            in_case,
        {"member", "load factor"});
    for (const auto* const single : singles) {
      page_.open("tr").element("th", reader_.text(*single, "member"), {{"scope", "row"}});
      page_.open("td");
      const auto* const factor = ResultReader::find(*single, "factor");
      if (factor != nullptr) {
        add_number(page_, factor, few_digits, uncertain ? Rounding::up : Rounding::nearest);
      } else {
        page_.words(reader_.text(*single, "state") != "not-carried" ? "open"
                    : uncertain ? "some admissible load is carried at no factor"
                                : "the dead load is carried at no factor");
      }
      page_.close().close();
    }
    end_table(page_);
    page_.close();
  }

  // The factors of the actions in the critical load of each combination.
  void combinations() {
    if (ResultReader::find(result_, "critical_factors") == nullptr) return;
    std::vector<std::string> actions;
    for (const auto& each : reader_.list(result_, "critical_factors"))
      actions.push_back(reader_.text(each, "action"));
    std::vector<const ResultJson*> cases;
    if (ResultReader::find(result_, "cases") != nullptr) {
      for (const auto& each : reader_.list(result_, "cases")) cases.push_back(&each);
    } else {
      cases.push_back(&result_);
    }
    // Actions that exclude each other are in different cases.
    for (const auto* const each : cases) {
      if (ResultReader::find(*each, "critical_factors") == nullptr) continue;
      for (const auto& factor : reader_.list(*each, "critical_factors")) {
        const auto name = reader_.text(factor, "action");
        if (std::ranges::find(actions, name) == actions.end()) actions.push_back(name);
      }
    }
    std::vector<std::string> columns{"combination", "largest load factor, at least", "at most"};
    columns.insert(columns.end(), actions.begin(), actions.end());
    begin_table(page_, "Combinations of actions: the worst case of each", columns);
    for (const auto* const each : cases) combination(*each, actions);
    end_table(page_);
  }

  // The load cases, unless they are combinations of actions.
  void load_cases() {
    if (ResultReader::find(result_, "cases") == nullptr ||
        ResultReader::find(result_, "critical_factors") != nullptr)
      return;
    const bool losses = ResultReader::find(result_, "lost_at_most") != nullptr;
    const std::string factor = losses ? "load factor after the worst loss" : "largest load factor";
    begin_table(
        page_, "Load cases",
        {"load case",
         std::string("nominal load factor, ") + answer::standing_word(support::Standing::computed),
         factor + ", at least", "standing", "at most", "standing", "state"});
    for (const auto& each : reader_.list(result_, "cases")) {
      page_.open("tr").element("th", reader_.text(each, "name"), {{"scope", "row"}}).open("td");
      add_number(page_, ResultReader::find(each, "nominal"));
      page_.close();
      const auto* const ends = ResultReader::find(each, losses ? "factor" : "maximum");
      for (const char* const key : {"lower", "upper"}) {
        page_.open("td");
        add_bound(page_, reader_, ends, key);
        page_.close().element("td", standing_of(reader_, ends, key));
      }
      const auto state = reader_.text(each, "state");
      page_.element("td", ResultReader::find(each, "fatal") != nullptr
                              ? "no factor remains after some loss, " + reader_.text(each, "fatal")
                          : state == "not-carried" ? "some load is carried at no factor"
                                                   : state);
      page_.close();
    }
    end_table(page_);
  }

  void combination(const ResultJson& row, const std::vector<std::string>& actions) {
    const auto* const name = ResultReader::find(row, "name");
    const auto* const asked = ResultReader::find(reader_.at(reader_.all(), "options"), "case");
    page_.open("tr").element("th",
                             name != nullptr    ? name->get<std::string>()
                             : asked != nullptr ? asked->get<std::string>()
                                                : "all actions",
                             {{"scope", "row"}});
    const auto* const worst = ResultReader::find(row, "maximum");
    for (const char* const key : {"lower", "upper"}) {
      page_.open("td");
      add_bound(page_, reader_, worst, key, few_digits);
      page_.close();
    }
    for (const auto& action : actions) {
      page_.open("td");
      bool reference = false;
      const ResultJson* factor = nullptr;
      if (ResultReader::find(row, "critical_factors") != nullptr) {
        for (const auto& each : reader_.list(row, "critical_factors")) {
          if (reader_.text(each, "action") != action) continue;
          factor = ResultReader::find(each, "factor");
          reference = reader_.at(each, "reference") == true;
        }
      }
      if (reference) page_.words("λ · ");
      add_number(page_, factor);
      page_.close();
    }
    page_.close();
  }

  // @param object with the mode under `key`
  void mode(const ResultJson& object, const char* key) {
    const auto& yielding = reader_.list(reader_.at(object, key), "yielding");
    if (yielding.empty()) return;
    begin_table(page_, "Yielding members", {"member", "in", "rate of elongation"});
    for (const auto& each : yielding) {
      page_.open("tr").element("th", joined(reader_.names(each, "member")), {{"scope", "row"}});
      page_.element("td", reader_.text(each, "in")).open("td");
      add_number(page_, &reader_.at(each, "elongation"));
      page_.close().close();
    }
    end_table(page_);
  }

  // @param of the result, or its member_loss
  void critical_load(const ResultJson& of) {
    if (ResultReader::find(of, "critical_load") == nullptr) return;
    const auto force = reader_.text(reader_.at(problem_, "units"), "force");
    const auto d = static_cast<int>(reader_.number(problem_, "d"));
    std::vector<std::string> columns{"node", "x", "y", "z"};
    columns.resize(static_cast<std::size_t>(d) + 1);
    begin_table(page_, "The critical dead load, " + force, columns);
    for (const auto& load : reader_.list(of, "critical_load")) {
      page_.open("tr").element("th", reader_.text(load, "node"), {{"scope", "row"}});
      for (const auto& component : reader_.list(load, "force", columns.size() - 1)) {
        page_.open("td");
        add_number(page_, &component);
        page_.close();
      }
      page_.close();
    }
    end_table(page_);
    uncertain_loads(of);
  }

  // The named loads in the critical dead load, with the nodes at which they act.
  void uncertain_loads(const ResultJson& of) {
    if (ResultReader::find(of, "critical_parameters") == nullptr ||
        ResultReader::find(of, "critical_factors") != nullptr)
      return;
    const auto& values = reader_.list(of, "critical_parameters");
    const auto& loads = reader_.list(problem_, "uncertain_loads", values.size());
    // The name of a single component is its place, which is in the table of the load.
    const auto is_named = [&](const ResultJson& load) {
      const auto& components = reader_.list(load, "components");
      if (components.size() != 1) return true;
      const auto place = fmt::format("{} at {}", reader_.text(components.front(), "axis"),
                                     reader_.text(components.front(), "node"));
      return reader_.text(load, "name") != place;
    };
    if (std::ranges::none_of(loads, is_named)) return;
    begin_table(page_, "Uncertain loads in the critical dead load", {"load", "times", "at"});
    for (std::size_t j = 0; j < values.size(); ++j) {
      if (!is_named(loads[j])) continue;
      std::vector<std::string> nodes;
      for (const auto& component : reader_.list(loads[j], "components")) {
        const auto node = reader_.text(component, "node");
        if (std::ranges::find(nodes, node) == nodes.end()) nodes.push_back(node);
      }
      page_.open("tr").element("th", reader_.text(values[j], "name"), {{"scope", "row"}});
      page_.open("td");
      add_number(page_, ResultReader::find(values[j], "value"));
      page_.close().element("td", joined(nodes)).close();
    }
    end_table(page_);
  }

  void utilisation() {
    const auto& structure = reader_.at(problem_, "structure");
    if (ResultReader::find(structure, "members") == nullptr) return;
    const auto& members = reader_.list(structure, "members");
    const auto names = reader_.names(structure, "node_names");
    std::vector<std::string> columns{"member"};
    std::vector<const ResultJson*> used;
    for (const char* const key : {"nominal_utilisation", "utilisation"}) {
      if (ResultReader::find(result_, key) == nullptr) continue;
      used.push_back(&reader_.list(result_, key, members.size()));
      columns.emplace_back(key == std::string_view("utilisation") ? "worst case" : "nominal load");
    }
    if (used.empty()) return;
    page_.open("details").element("summary", "Utilisation of the members");
    begin_table(page_, "Utilisation (1: the member yields)", columns);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const auto a = static_cast<std::size_t>(reader_.index(members[i][0], names.size()));
      const auto b = static_cast<std::size_t>(reader_.index(members[i][1], names.size()));
      page_.open("tr").element("th", joined({names[a], names[b]}), {{"scope", "row"}});
      for (const auto* const list : used) {
        page_.open("td");
        add_number(page_, &(*list)[i]);
        page_.close();
      }
      page_.close();
    }
    end_table(page_);
    page_.close();
  }

  static constexpr std::string_view worst_case_ = "worst case";
  const std::string proved_ = answer::standing_word(support::Standing::proved);
  Markup& page_;
  const ResultReader& reader_;
  const ResultJson& result_;
  const ResultJson& problem_;
  const ResultScenes& scenes_;
};

}  // namespace

void add_limit(Markup& page, const ResultReader& reader, const ResultScenes& scenes) {
  LimitSection(page, reader, scenes).add();
}

}  // namespace kusabi::run
