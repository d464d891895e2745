// `kusabi rays`: options, stages and results; both methods, on all ranks.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "engine/options.hpp"
#include "engine/signals.hpp"
#include "nodes/wedged/exact_list.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/rays/ray_list_tree.hpp"
#include "nodes/wedged/rays/ray_search.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/command/command_run.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/csv.hpp"
#include "run/output/json_writer.hpp"
#include "run/output/name_ranges.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/terminal_page.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/pictures/vtu_series.hpp"
#include "run/rays/ray_lines.hpp"
#include "run/session/time_limit.hpp"
#include "run/wedged/configuration_files.hpp"
#include "run/wedged/contact_problem.hpp"
#include "run/wedged/problem_summary.hpp"
#include "solvers/rays/maximal_cones.hpp"
#include "solvers/rays/reaction_cone.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

/// Maximum number of rays in the graph.
constexpr std::size_t max_drawn_rays = 200;

struct RaysOptions {
  ProblemInput input;
  double friction = 0;  ///< friction coefficient mu
  wedged::RayMethod method = wedged::RayMethod::automatic;
  bool lines = false;     ///< the result file in lines, written during the search
  bool whole = false;     ///< all displacements and support reactions in the result file
  bool prove = false;     ///< comparison of the cones with a proved list of patterns
  engine::Limits limits;  ///< limits of the search; wedged::RayMethod::tree only
  CheckpointChoice checkpoint;
};

/// Table, JSON, CSV and graph. There may be millions of rays: they are kept as zero sets of 24 bytes,
/// and the numbers of each are computed when it is written.
class RaysReport {
 public:
  /// All must outlive it.
  RaysReport(const RaysOptions& options, const WholeStates& states, const rays::ReactionCone& cone,
             wedged::RayFindings& found, const wedged::ExactTest& exact, const Page& page)
      : options_(options),
        problem_(states.problem()),
        cone_(cone),
        found_(found),
        exact_(exact),
        page_(page),
        whole_(states) {}

  /// Computes the numbers of all rays, and writes them to those of `table`, `csv` and `json` that
  /// are not null. `found` includes the numerical health of the numbers afterwards.
  /// @param head first members of the result file
  void write(nlohmann::ordered_json head, std::ostream* table, std::ostream* csv, JsonWriter* json);

  /// The head of a result in lines: all but the rays, with cones that do not name their rays.
  /// @param head its first members
  [[nodiscard]] std::string head_line(nlohmann::ordered_json head);

  /// Last lines of the table: cones, counts, numerical health, and the answer.
  [[nodiscard]] std::string summary() const;

  /// Graph of cones and their rays in the language of Graphviz; with too many rays only their
  /// number.
  void draw(std::ostream& out) const;

  [[nodiscard]] bool can_be_drawn() const { return found_.rays.size() <= max_drawn_rays; }

 private:
  [[nodiscard]] rays::Supports supports(std::size_t number) const {
    return {found_.rays[number], cone_.all()};
  }
  [[nodiscard]] std::string states(std::size_t number) const;
  [[nodiscard]] std::string cell_of_count(const rays::Cone& cone) const;
  [[nodiscard]] nlohmann::ordered_json tree_member() const;
  [[nodiscard]] nlohmann::ordered_json last_members();
  [[nodiscard]] nlohmann::ordered_json end_members() const;
  void end_rays_and_all(JsonWriter& json);  // from the end of the list of rays
  [[nodiscard]] nlohmann::ordered_json ray_json(std::size_t number, const rays::Ray& ray) const;
  [[nodiscard]] nlohmann::ordered_json motion_json(std::size_t number);
  [[nodiscard]] nlohmann::ordered_json cone_json(const rays::Cone& cone, bool with_rays) const;
  // Numbers, from 1 on, of the rays or motions that belong to a cone.
  [[nodiscard]] std::vector<std::size_t> numbers_in(const rays::Cone& cone,
                                                    std::span<const rays::ZeroSet> sets) const;
  [[nodiscard]] std::string ray_lines(std::size_t number, const rays::Ray& ray) const;
  void begin(CsvWriter& csv) const;  // the header
  void add(CsvWriter& csv, std::size_t number, const rays::Ray& ray) const;

  const RaysOptions& options_;
  const problems::WedgedProblem& problem_;
  const rays::ReactionCone& cone_;
  wedged::RayFindings& found_;
  const wedged::ExactTest& exact_;
  Page page_;
  WholeStateJson whole_;
};

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
  if (json != nullptr) {
    json->begin_result(std::move(head), tree_member());
    json->key("rays");
    json->begin_list();
  }
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
  fmt::format_to(out, "\n{}{}{} at {}, by {}\n", answer::counted(found_.count(), "extremal ray"),
                 problem_.modes.bodies.empty()
                     ? ""
                     : fmt::format(" and {} without reactions",
                                   answer::counted(found_.motions.size(), "extremal motion")),
                 whole ? " in " + answer::counted(found_.cones.size(), "maximal cone")
                       : std::string(found_.count() == 1 ? " is known" : " are known"),
                 friction_text(problem_, options_.friction),
                 found_.method == wedged::RayMethod::tree ? "the tree of sign patterns"
                                                          : "double description");
  if (exact_.cones) text += answer::cones_line(*exact_.cones);
  if (found_.count() == 0) return text;
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
  for (const auto& each : found_.cones) members["cones"].push_back(cone_json(each, false));
  members.update(end_members());
  return members;
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
  for (const auto& each : found_.cones) json.value(cone_json(each, true));
  json.end_list();
  json.members(end_members());
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

std::vector<std::size_t> RaysReport::numbers_in(const rays::Cone& cone,
                                                std::span<const rays::ZeroSet> sets) const {
  std::vector<std::size_t> numbers;
  for (std::size_t at = 0; at < sets.size(); ++at)
    if (belongs({sets[at], cone_.all()}, cone)) numbers.push_back(at + 1);
  return numbers;
}

// @param with_rays with the numbers of its rays
ordered_json RaysReport::cone_json(const rays::Cone& each, bool with_rays) const {
  ordered_json json{
      {"contact", candidate_names(problem_, cone_.all() & ~each.separated)},
      {"separated", candidate_names(problem_, each.separated)},
      {"idle", candidate_names(problem_, cone_.all() & ~(each.separated | each.reaction))}};
  if (with_rays) json["rays"] = numbers_in(each, found_.rays);
  if (!problem_.modes.bodies.empty()) json["motions"] = numbers_in(each, found_.motions);
  return json;
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

using wedged::RayMethod;

// Columns of one ray, candidate by candidate.
std::vector<pictures::ContactState> contact_states_of(const rays::Supports& supports, int count) {
  std::vector<pictures::ContactState> states;
  for (int i = 0; i < count; ++i) {
    const bool separates = (supports.separated() & rays::bit(i)) != 0;
    const bool presses = (supports.reaction() & rays::bit(i)) != 0;
    states.push_back(separates ? pictures::ContactState::separated
                     : presses ? pictures::ContactState::contact
                               : pictures::ContactState::inactive);
  }
  return states;
}

class Rays final : public Subcommand {
 public:
  void describe(OptionTable& table) override;
  void check() const override;
  void read(CommandRun& run) override { options_.input.read(run); }
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] answer::Verdict verdict() const override;
  [[nodiscard]] double seconds_to_write(std::uint64_t solutions) const override;
  [[nodiscard]] bool limit_includes_writing() const override { return options_.lines; }
  std::vector<std::string> remarks(CommandRun& run) override;

 private:
  void check_problem() const;
  void open_lines(CommandRun& run);
  [[nodiscard]] std::uint64_t tree_fingerprint() const;
  void end_lines(engine::Analysis& analysis);
  void draw_all(OutputFolder& folder, const WholeStates& states) const;

  const OptionTable* table_ = nullptr;
  RaysOptions options_;
  std::string vtu_;
  ContactProblem contact_;
  std::vector<double> friction_;
  std::optional<rays::ReactionCone> cone_;
  std::optional<RayLines> lines_;
  wedged::RayFindings found_;  // on rank 0
  wedged::ExactTest exact_;    // of its cones

  [[nodiscard]] bool whole() const { return found_.status == engine::Status::solved; }
  // True if the exact test of the cones, which comes after the search, leaves nothing open either.
  [[nodiscard]] bool answered() const { return whole() && exact_.unable.empty(); }
};

void Rays::describe(OptionTable& table) {
  table_ = &table;
  table.problem(options_.input.file);
  table.friction(options_.friction);
  table.choice("--method", options_.method,
               {{"auto", RayMethod::automatic},
                {"double-description", RayMethod::double_description},
                {"tree", RayMethod::tree}},
               "Algorithm 4.2 with all rays on every rank (double-description), the rays "
               "of each sign pattern in turn (tree), or the method that is faster in a trial, "
               "with the rays divided among the ranks (auto). The rays are the same");
  table.output();
  table.lines(options_.lines,
              "format of the result file: one object (json), or a line per ray (jsonl), for more "
              "than about 100,000 rays. All ranks write the lines during the search, and memory "
              "does not grow with their number, except with --method double-description");
  table.pictures(vtu_, "ray", "rays.pvd");
  table.csv_of("rays");
  table.further_output(
      "--dot", "graph of the maximal cones and their rays for Graphviz, of at most 200 rays");
  table.whole_states(options_.whole, "rays", "none");
  table.search_limits(options_.limits);
  table.resume(options_.checkpoint, ". A resumed run repeats short steps, which are not stored");
  table.prove(options_.prove,
              "compare the cones with a list of patterns whose nodes are tested in exact "
              "arithmetic, as kusabi verify does");
  table.quiet_and_serial();
}

void Rays::check() const {
  if (options_.lines) table_->check_lines({"--csv", "--vtu", "--dot", "--whole"});
  if (options_.method == RayMethod::double_description && wedged::limited(options_.limits)) {
    throw WrongInput(
        "--method double-description gives no partial results; expected no limit, or another "
        "method");
  }
}

void Rays::prepare(CommandRun& run) {
  contact_ = contact_problem(run, options_.input, options_.friction);
  check_problem();
  friction_ = friction_at(contact_.problem, options_.friction, options_.input.file);
  keep_state(run, options_.checkpoint, contact_.problem);
  cone_ = wedged::reaction_cone(contact_.problem, friction_);
  if (options_.lines) open_lines(run);
}

void Rays::open_lines(CommandRun& run) {
  lines_.emplace(run.session(), *cone_,
                 PartsOwner{.option = "--output",
                            .name = *table_->find("--output")->given,
                            .content = "the rays",
                            .tree = tree_fingerprint(),
                            .checkpoint = options_.checkpoint.state},
                 run.has_begun_to_search(), run.has_searched());
}

// Parts of lines belong to a problem, its friction and the method.
std::uint64_t Rays::tree_fingerprint() const {
  support::Fingerprint fingerprint;
  fingerprint.add(std::string_view("rays"));
  fingerprint.add(contact_.problem.provenance.fingerprint);
  fingerprint.add(options_.friction);
  fingerprint.add(static_cast<std::uint64_t>(options_.method));
  return fingerprint.value();
}

void Rays::check_problem() const {
  if (contact_.problem.dimension != 2) {
    throw WrongInput(
        fmt::format("{}: dimension is 3; expected 2, since circular friction cones have no finite "
                    "list of extremal rays; kusabi patterns has no such limit",
                    options_.input.file));
  }
  const auto candidates = std::ssize(contact_.problem.contact_names);
  if (candidates > rays::max_candidates) {
    throw WrongInput(fmt::format(
        "{}: {} contact candidates; expected at most {}; kusabi patterns has no such limit",
        options_.input.file, candidates, rays::max_candidates));
  }
}

std::string Rays::announcement(const std::string& ranks) const {
  const bool by_pattern = options_.method == RayMethod::tree;
  const auto longest = options_.lines ? wedged::longest_recorded_list : wedged::longest_list;
  const auto megabytes =
      std::max<std::uint64_t>(wedged::memory_of_lists(cone_->candidates(), longest) >> 20U, 1);
  return fmt::format("{}; {}; {} on {}{}", problem_line(contact_.problem),
                     friction_text(contact_.problem, options_.friction),
                     by_pattern ? "the tree of sign patterns" : "double description", ranks,
                     options_.method == RayMethod::automatic
                         ? fmt::format(", lists of rays in {} MB each", megabytes)
                         : "");
}

void Rays::search(CommandRun& run) {
  engine::Analysis analysis(run.session().transport(), run.analysis_options(options_.limits));
  wedged::RayRecorder recorder;
  if (lines_) recorder = [this](const auto& zero, const auto& ray) { lines_->add(zero, ray); };
  found_ =
      wedged::find_rays(analysis, contact_.problem, friction_, *cone_, options_.method, recorder);
  if (lines_) end_lines(analysis);
  const bool searched = run.session().from_first_rank([&] { return whole(); });
  if (!searched) return;
  const auto proving = options_.prove ? wedged::Proving::always : wedged::Proving::automatic;
  exact_ = wedged::tested_cones(analysis, {contact_.structure, contact_.problem, proving},
                                friction_, found_.cones);
}

void Rays::end_lines(engine::Analysis& analysis) {
  auto cones = lines_->close(found_);
  if (!analysis.is_first()) return;
  wedged::find_cones(found_, std::move(cones), cone_->all(), analysis.budget());
  // The search ended for the time to write, which is part of the limit.
  const bool limited = options_.limits.seconds != engine::Limits{}.seconds;
  if (limited && found_.status == engine::Status::interrupted && !engine::end_asked_by_signal())
    found_.status = engine::Status::time_limit;
}

void Rays::draw_all(OutputFolder& folder, const WholeStates& states) const {
  const ConfigurationGrids grids(states);
  const auto count = std::min(found_.rays.size(), longest_series);
  VtuSeries series(folder);
  auto health = found_.health;  // complete after the rays are written
  for (std::size_t i = 0; i < count; ++i) {
    const auto ray = cone_->ray(found_.rays[i], health);
    series.add(numbered_vtu("ray", i + 1, count),
               grids.grid({fmt::format("ray {} at {}", i + 1,
                                       friction_text(contact_.problem, options_.friction)),
                           options_.friction},
                          numbers(ray.reaction), numbers(ray.displacement),
                          contact_states_of({found_.rays[i], cone_->all()}, cone_->candidates())));
  }
  series.finish("rays.pvd", problem_line(contact_.problem));
}

std::vector<Step> Rays::results(CommandRun& run) {
  const auto states = std::make_shared<const WholeStates>(contact_.structure, contact_.problem);
  const auto report =
      std::make_shared<RaysReport>(options_, *states, *cone_, found_, exact_, CommandRun::page());
  const auto head =
      run.head(problem_json(contact_.structure, contact_.problem, options_.input.file));
  if (lines_) {
    return {run.result_lines(
                [this, report, states, head](std::ostream& out) {
                  return lines_->write(out, report->head_line(head));
                },
                [this] { lines_->end(!options_.checkpoint.state.empty() && !answered()); }),
            run.answer([report, states] { return report->summary(); })};
  }
  // Table, CSV and JSON are written in one pass over the rays, whose numbers are computed once.
  const auto table = std::make_shared<std::ostringstream>();
  const auto write = [&run, report, table, states, head](JsonWriter* json) {
    report->write(head, run.quiet() ? nullptr : table.get(),
                  run.wants("--csv") ? &run.stream("--csv") : nullptr, json);
  };
  return {run.wants("--output") ? run.result([write](JsonWriter& json) { write(&json); })
                                : [write] { write(nullptr); },
          run.file("--csv", {}),
          run.folder("--vtu", [this, states](auto& folder) { draw_all(folder, *states); }),
          run.file("--dot", [report](std::ostream& out) { report->draw(out); }),
          run.answer([table] { return table->str(); })};
}

answer::Verdict Rays::verdict() const {
  // Without a cone there is no ray.
  const bool none = exact_.cones == 0U && found_.count() == 0;
  const answer::Sticking sticking{
      .thing = "extremal ray",
      .friction = options_.friction,
      .factor = !uniform_friction(contact_.problem),
      .count = found_.count(),
      .standing = support::proved_if(none),
      .grounds = none ? answer::Grounds::exact_arithmetic : answer::Grounds::solver_bounds,
      .ambiguous = !found_.health.sound(),
      .proved_cones = exact_.cones,
      .remainder = remainder_of(exact_),
      .displacement_ratio = exact_.displacement_ratio};
  answer::Verdict verdict{.ended = found_.status, .answer = sticking};
  if (answer::is_known_to_stick(sticking)) verdict.details.push_back(answer::next_step(false));
  return verdict;
}

double Rays::seconds_to_write(std::uint64_t solutions) const {
  if (options_.lines) return seconds_per_written_line * static_cast<double>(solutions);
  return Subcommand::seconds_to_write(solutions);
}

std::vector<std::string> Rays::remarks(CommandRun& run) {
  if (!found_.health.sound()) {
    return {fmt::format(
        "kusabi: {} undecided; expected a structure with less cancellation, fewer candidates, or "
        "another friction coefficient",
        answer::counted(found_.health.undecided, "number"))};
  }
  std::vector<std::string> remarks;
  const auto drawn = series_remark(found_.rays.size(), "rays");
  if (run.wants("--vtu") && !drawn.empty()) remarks.push_back(drawn);
  if (run.wants("--dot") && found_.rays.size() > max_drawn_rays) {
    remarks.push_back(
        fmt::format("--dot: {} rays exceed the limit of a graph ({}); the file of --output has the "
                    "rays of each cone, that of --csv a row per ray",
                    found_.rays.size(), max_drawn_rays));
  }
  return remarks;
}

}  // namespace

constexpr Registration rays_subcommand{
    {.name = "rays",
     .chapter = "Wedged configurations",
     .purpose = "all extremal rays and maximal cones, in the plane",
     .description = "All extremal rays of the wedged configurations of a plane structure, and all "
                    "maximal cones, each with its rays.",
     .example = "examples/plane-truss.toml --mu 0.8",
     .progress = ProgressLines::solutions},
    make<Rays>};

}  // namespace kusabi::run
