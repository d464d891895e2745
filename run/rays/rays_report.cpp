// One pass over the rays that writes table, JSON and CSV together.
#include "run/rays/rays_report.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "run/output/csv.hpp"
#include "run/output/name_ranges.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/values.hpp"
#include "run/rays/ray_json.hpp"
#include "run/wedged/configuration_csv.hpp"
#include "run/wedged/exact_json.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

/// Maximum number of rays or cones in the table; --output and --csv contain all.
constexpr std::size_t longest_table = 60;

ordered_json cost_json(const rays::Cost& cost) {
  return {{"peak_rays", cost.peak_rays}, {"pairs", cost.pairs}, {"adjacent", cost.adjacent}};
}

ordered_json tree_json(const wedged::RayTreeReport& report) {
  auto tree = counts_json(report.patterns);
  tree["opened"] = report.opened;
  tree["open"] = report.open;
  tree["fingerprint"] = hexadecimal(report.fingerprint);
  return tree;
}

// Method and costs of the run.
ordered_json statistics_json(const wedged::RayFindings& found) {
  ordered_json statistics{
      {"method", found.method == wedged::RayMethod::tree ? "tree" : "double-description"}};
  if (found.tree) {
    statistics["ranks"] = rank_reports(found.tree->ranks, [](const auto& tally) {
      auto own = counts_json(tally.patterns);
      own.update(cost_json(tally.cost));
      return own;
    });
  } else {
    statistics.update(cost_json(found.cost));
    statistics["seconds"] = found.seconds;
  }
  return statistics;
}

}  // namespace

std::string RaysReport::states(std::size_t number) const {
  std::string letters;
  for (int i = 0; i < cone_.candidates(); ++i) letters += state_of(supports(number), i).letter;
  return letters;
}

void RaysReport::write(ordered_json head, std::ostream* table, std::ostream* csv,
                       JsonWriter* json) {
  if (table != nullptr && !found_.rays.empty()) {
    *table << fmt::format("\n{:>7}  {}\n", "", fmt::join(problem_.contact_names, "  "));
    *table << "        x sticks   + slides, r_t = mu r_n   - slides, r_t = -mu r_n   o separates   "
              ". neither\n";
  }
  std::optional<CsvWriter> rows;
  if (csv != nullptr) begin(rows.emplace(*csv));
  if (json != nullptr) begin(*json, std::move(head));
  for (std::size_t at = 0; at < found_.rays.size(); ++at) {
    const rays::Ray ray = cone_.ray(found_.rays[at], found_.health);
    if (table != nullptr && at < longest_table) *table << ray_lines(at, ray);
    if (rows) add(*rows, at, ray);
    if (json != nullptr) json->value(ray_json(at, ray));
  }
  if (json != nullptr) end_rays_and_all(*json);
  if (table != nullptr) *table << summary();
}

std::string RaysReport::head_line(ordered_json head) {
  head["result"].update(tree_member());
  head["result"].update(last_members());
  head["lines"] = "rays";
  head["statistics"] = statistics_json(found_);
  return json_line(head);
}

std::string RaysReport::ray_lines(std::size_t number, const rays::Ray& ray) const {
  constexpr std::size_t cell = 11;
  auto letters = states(number);
  const std::size_t before = 7 + 2 + letters.size() + 2 + 3;
  const std::size_t room = page_.width > before + cell ? (page_.width - before) / cell : 1;
  std::string text;
  auto name = std::to_string(number + 1);
  for (int first = 0; first < cone_.candidates();) {
    const auto end = static_cast<int>(std::min<std::size_t>(
        static_cast<std::size_t>(cone_.candidates()), static_cast<std::size_t>(first) + room));
    std::string normal;
    std::string tangential;
    for (int i = first; i < end; ++i) {
      const bool none = (supports(number).reaction() & rays::bit(i)) == 0;
      normal += none ? fmt::format("{:>11}", "") : fmt::format(" {:>10.4g}", ray.reaction(2 * i));
      tangential +=
          none ? fmt::format("{:>11}", "") : fmt::format(" {:>10.4g}", ray.reaction(2 * i + 1));
    }
    text += fmt::format("{:>7}  {}  r_n{}\n{:>7}  {:{}}  r_t{}\n", name, letters, normal, "", "",
                        letters.size(), tangential);
    name.clear();
    letters.assign(letters.size(), ' ');
    first = end;
  }
  return text;
}

// The number of a cone's rays, as a cell of the table; nothing if the rays are in lines.
std::string RaysReport::cell_of_count(const rays::Cone& cone) const {
  if (options_.lines) return {};
  const auto count =
      std::count_if(found_.rays.begin(), found_.rays.end(), [&](const rays::ZeroSet& zero) {
        return belongs({zero, cone_.all()}, cone);
      });
  return fmt::format("  {:>6}", count);
}

std::string RaysReport::summary() const {
  std::string text;
  auto out = std::back_inserter(text);
  if (found_.rays.size() > longest_table && !options_.lines) {
    fmt::format_to(out, "        and {} more (--output, --csv)\n",
                   found_.rays.size() - longest_table);
  }
  if (!found_.cones.empty()) {
    fmt::format_to(out, "\n{:>7}{}  in contact (U) | separated (R)\n", "cone",
                   options_.lines ? "" : "    rays");
  }
  for (std::size_t number = 0; number < std::min(found_.cones.size(), longest_table); ++number) {
    const rays::Cone& each = found_.cones[number];
    fmt::format_to(out, "{:>7}{}  {} | {}\n", number + 1, cell_of_count(each),
                   with_ranges(candidate_names(problem_, cone_.all() & ~each.separated)),
                   with_ranges(candidate_names(problem_, each.separated)));
  }
  if (found_.cones.size() > longest_table) {
    fmt::format_to(out, "        and {} more (--output)\n", found_.cones.size() - longest_table);
  }
  // The cones follow from all rays.
  const bool whole = found_.status == engine::Status::solved;
  fmt::format_to(out, "\n{}{}{} at friction coefficient {}, by {}\n",
                 answer::counted(found_.count(), "extremal ray"),
                 problem_.modes.bodies.empty()
                     ? ""
                     : fmt::format(" and {} without reactions",
                                   answer::counted(found_.motions.size(), "extremal motion")),
                 whole ? " in " + answer::counted(found_.cones.size(), "maximal cone") +
                             (exact_.cones ? fmt::format(" ({})", answer::standing_word(
                                                                      support::Standing::proved))
                                           : "")
                       : std::string(found_.count() == 1 ? " is known" : " are known"),
                 friction_text(problem_, options_.friction),
                 found_.method == wedged::RayMethod::tree ? "the tree of sign patterns"
                                                          : "double description");
  fmt::format_to(out,
                 "relative displacements up to {:.1e} are regarded as zero; the smallest other is "
                 "{:.1e} (tolerance {})\n",
                 found_.health.largest_zero, found_.health.smallest_nonzero, rays::zero_tolerance);
  return text;
}

ordered_json RaysReport::tree_member() const {
  auto member = ordered_json::object();
  if (found_.tree) member["tree"] = tree_json(*found_.tree);
  return member;
}

// Members of the result after its rays and cones. The numerical health includes the numbers of the
// rays, which are computed while they are written.
ordered_json RaysReport::end_members() const {
  const auto& health = found_.health;
  return {{"health",
           {{"tolerance", rays::zero_tolerance},
            {"largest_zero", health.largest_zero},
            {"smallest_nonzero", health.smallest_nonzero},
            {"undecided", health.undecided}}},
          {"exact", exact_json(exact_)}};
}

// The motions, and the cones without their rays: members of the result in lines.
ordered_json RaysReport::last_members() {
  ordered_json members;
  if (!problem_.modes.bodies.empty()) {
    members["motions"] = ordered_json::array();
    for (std::size_t at = 0; at < found_.motions.size(); ++at)
      members["motions"].push_back(motion_json(at));
  }
  members["cones"] = ordered_json::array();
  for (const auto& each : found_.cones) members["cones"].push_back(lean_cone(each));
  members.update(end_members());
  return members;
}

void RaysReport::begin(JsonWriter& json, ordered_json head) const {
  auto first = std::move(head["result"]);
  head.erase("result");
  first.update(tree_member());
  json.begin_object();
  for (const auto& [key, value] : head.items()) json.member(key, value);
  json.key("result");
  json.begin_object();
  for (const auto& [key, value] : first.items()) json.member(key, value);
  json.key("rays");
  json.begin_list();
}

// Motions and cones are written one by one, since cones name all their rays.
void RaysReport::end_rays_and_all(JsonWriter& json) {
  json.end_list();
  if (!problem_.modes.bodies.empty()) {
    json.key("motions");
    json.begin_list();
    for (std::size_t at = 0; at < found_.motions.size(); ++at) json.value(motion_json(at));
    json.end_list();
  }
  json.key("cones");
  json.begin_list();
  for (const auto& each : found_.cones) json.value(cone_json(each));
  json.end_list();
  const auto end = end_members();
  for (const auto& [key, value] : end.items()) json.member(key, value);
  json.end_object();
  json.member("statistics", statistics_json(found_));
  json.end_object();
}

ordered_json RaysReport::ray_json(std::size_t number, const rays::Ray& ray) const {
  ordered_json json{{"number", number + 1}};
  json.update(lean_ray(supports(number), ray));
  json["displacement"] = candidate_rows(numbers(ray.displacement), 2);
  if (options_.whole) whole_.add_to(json, numbers(ray.reaction), numbers(ray.displacement));
  return json;
}

ordered_json RaysReport::motion_json(std::size_t number) {
  const auto& zero = found_.motions[number];
  const rays::Supports supports(zero, cone_.all());
  const auto displacement = numbers(cone_.ray(zero, found_.health).displacement);
  return {{"number", number + 1},
          {"separated", candidate_names(problem_, supports.separated())},
          {"displacement", candidate_rows(displacement, 2)}};
}

ordered_json RaysReport::cone_json(const rays::Cone& each) const {
  std::vector<std::size_t> numbers;
  for (std::size_t number = 0; number < found_.rays.size(); ++number) {
    if (belongs(supports(number), each)) numbers.push_back(number + 1);
  }
  auto json = cone_candidates(each);
  json["rays"] = numbers;
  add_motions(json, each);
  return json;
}

// A cone without the numbers of its rays.
ordered_json RaysReport::lean_cone(const rays::Cone& each) const {
  auto json = cone_candidates(each);
  add_motions(json, each);
  return json;
}

ordered_json RaysReport::cone_candidates(const rays::Cone& each) const {
  return {{"contact", candidate_names(problem_, cone_.all() & ~each.separated)},
          {"separated", candidate_names(problem_, each.separated)},
          {"idle", candidate_names(problem_, cone_.all() & ~(each.separated | each.reaction))}};
}

void RaysReport::add_motions(ordered_json& json, const rays::Cone& each) const {
  if (problem_.modes.bodies.empty()) return;
  std::vector<std::size_t> motions;
  for (std::size_t number = 0; number < found_.motions.size(); ++number) {
    if (belongs({found_.motions[number], cone_.all()}, each)) motions.push_back(number + 1);
  }
  json["motions"] = motions;
}

void RaysReport::begin(CsvWriter& csv) const {
  csv.word("ray").word("state");
  add_configuration_columns(csv, problem_);
  csv.end_row();
}

void RaysReport::add(CsvWriter& csv, std::size_t number, const rays::Ray& ray) const {
  // One letter for each candidate, also where a spreadsheet takes them for a formula: readers count
  // them.
  csv.count(number + 1).word(fmt::format("\"{}\"", states(number)));
  add_configuration(csv, problem_, numbers(ray.reaction), numbers(ray.displacement));
  csv.end_row();
}

void RaysReport::draw(std::ostream& out) const {
  if (!can_be_drawn()) {
    out << fmt::format("graph rays {{\n  label=\"{} rays exceed the limit of a graph\";\n}}\n",
                       found_.rays.size());
    return;
  }
  out << "graph rays {\n  rankdir=LR;\n";
  for (std::size_t i = 0; i < found_.rays.size(); ++i)
    out << fmt::format("  {} [label=\"{}\\n{}\"];\n", i + 1, i + 1, states(i));
  for (std::size_t cone = 0; cone < found_.cones.size(); ++cone) {
    out << fmt::format("  cone{} [shape=box, label=\"cone {}\"];\n", cone + 1, cone + 1);
    for (std::size_t i = 0; i < found_.rays.size(); ++i) {
      if (belongs(supports(i), found_.cones[cone]))
        out << fmt::format("  cone{} -- {};\n", cone + 1, i + 1);
    }
  }
  out << "}\n";
}

}  // namespace kusabi::run
