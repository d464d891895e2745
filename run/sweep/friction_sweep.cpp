// From the range of friction to the staircase of counts.
#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "nodes/wedged/exact_list.hpp"
#include "nodes/wedged/sweep_search.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/output/name_ranges.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/values.hpp"
#include "run/sweep/swept.hpp"
#include "run/wedged/agreement.hpp"
#include "run/wedged/exact_words.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

const char* times(const problems::WedgedProblem& problem) {
  return problems::uniform_friction(problem) ? "" : " times that of each candidate";
}

class FrictionSweep final : public Swept {
 public:
  FrictionSweep(const SweepOptions& options, problems::Structure structure,
                std::vector<double> points, double most)
      : options_(options),
        structure_(std::move(structure)),
        points_(std::move(points)),
        question_{.most = most, .width = options.width} {}

  void prepare(CommandRun& run) override {
    problem_ = problems::wedged_problem(structure_);
    friction_at(problem_, question_.most, options_.file);
    agree(run.session(), problem_);
    run.keep_state(options_.checkpoint, {{"the problem", hexadecimal(problem_.fingerprint)}});
  }
  [[nodiscard]] std::string announcement(const std::string& ranks) const override {
    return fmt::format("{}; up to a friction coefficient of {}{}; {}", problem_line(problem_),
                       question_.most, times(problem_), ranks);
  }
  void search(CommandRun& run) override {
    engine::Campaign campaign(run.session().transport(), run.supervision(options_.limits));
    found_ = wedged::sweep_friction(campaign, problem_, question_);
    const bool searched =
        run.session().from_first_rank([&] { return found_.status == engine::Status::solved; });
    if (!searched) return;
    const auto proving = options_.prove ? wedged::Proving::always : wedged::Proving::automatic;
    exact_ = wedged::tested_counts(campaign, {structure_, problem_, proving}, points_, found_);
  }
  [[nodiscard]] ordered_json json() const override;
  void write_csv(std::ostream& out) const override;
  [[nodiscard]] std::string table(const std::string& sentence) const override;
  [[nodiscard]] Verdict verdict() const override;
  [[nodiscard]] engine::Status status() const override { return found_.status; }

 private:
  /// At the points that were asked for; none if the tree was not done.
  [[nodiscard]] std::vector<wedged::ConeCount> counts() const;
  [[nodiscard]] std::string points_text() const;
  [[nodiscard]] std::string cones_text() const;
  [[nodiscard]] std::string ranks_text() const;
  [[nodiscard]] std::string names(const support::IndexSet& candidates) const {
    return with_ranges(candidate_names(problem_, candidates));
  }

  const SweepOptions& options_;
  problems::Structure structure_;
  problems::WedgedProblem problem_;
  std::vector<double> points_;
  wedged::SweepQuestion question_;
  wedged::SweepFindings found_;
  wedged::ExactTest exact_;  // of its counts
};

std::vector<wedged::ConeCount> FrictionSweep::counts() const {
  std::vector<wedged::ConeCount> list;
  if (!found_.enumerated) return list;
  for (const double point : points_) list.push_back(found_.count_at(point));
  return list;
}

ordered_json bracket_json(const std::optional<wedged::FrictionBracket>& bracket) {
  if (!bracket) return {};
  return {{"lower", bracket->lower}, {"upper", bracket->upper}};
}

ordered_json counted_json(std::uint64_t known, std::size_t open) {
  return {{"count", open == 0 ? ordered_json(known) : ordered_json()},
          {"known", known},
          {"open", open}};
}

ordered_json point_json(const wedged::ConeCount& count) {
  ordered_json point{{"mu", count.friction}};
  point.update(counted_json(count.known, count.open));
  return point;
}

ordered_json FrictionSweep::json() const {
  auto points = ordered_json::array();
  for (const auto& count : counts()) points.push_back(point_json(count));
  auto steps = ordered_json::array();
  const auto treads = found_.enumerated ? found_.staircase() : std::vector<wedged::Tread>();
  for (const auto& [from, to, known, open] : treads) {
    ordered_json step{{"from", from}, {"to", to}};
    step.update(counted_json(known, open));
    steps.push_back(std::move(step));
  }
  auto patterns = ordered_json::array();
  for (const auto& cone : found_.cones) {
    auto json = pattern_json(problem_, cone.block, cone.pattern);
    json["state"] = cone.solid() ? "alive" : "flat";
    json["lower"] = cone.begins.lower;
    json["upper"] = cone.begins.upper;
    json["absorbed"] = bracket_json(cone.absorbed);
    patterns.push_back(std::move(json));
  }
  auto open = ordered_json::array();
  for (const auto& leaf : found_.open) {
    auto json = pattern_json(problem_, leaf.block, leaf.pattern);
    json["lower"] = leaf.lower;
    open.push_back(std::move(json));
  }
  ordered_json chosen{{"mu", points_}, {"mu_max", question_.most}, {"width", question_.width}};
  return {
      {"command", "sweep"},
      {"version", KUSABI_VERSION},
      {"problem", problem_json(structure_, problem_, options_.file)},
      {"options", std::move(chosen)},
      {"status", status_name(found_.status)},
      {"result",
       {{"points", std::move(points)},
        {"at_mu_max",
         found_.enumerated ? point_json(found_.count_at(found_.most)) : ordered_json()},
        {"staircase", std::move(steps)},
        {"patterns", std::move(patterns)},
        {"open", std::move(open)},
        {"exact", exact_json(exact_)}}},
      {"statistics",
       {{"tree", rank_reports(found_.tree_ranks, counts_json<wedged::SignPatternTally>)},
        {"histories", rank_reports(found_.history_ranks, counts_json<wedged::SweepTree::Tally>)}}}};
}

void FrictionSweep::write_csv(std::ostream& out) const {
  out << "row,mu,count,known,open\n";
  const auto row = [&](const char* what, double mu, std::uint64_t known, std::size_t open) {
    fmt::print(out, "{},{},{},{},{}\n", what, mu, open == 0 ? fmt::format("{}", known) : "", known,
               open);
  };
  for (const auto& count : counts()) row("point", count.friction, count.known, count.open);
  if (!found_.enumerated) return;
  for (const auto& [from, to, known, open] : found_.staircase()) {
    row("from", from, known, open);
    row("to", to, known, open);
  }
}

std::string FrictionSweep::points_text() const {
  if (points_.empty() || !found_.enumerated) return {};
  std::string text = fmt::format("\n{:>12}  {}\n", "friction", "sign patterns");
  for (const auto& count : counts()) {
    fmt::format_to(std::back_inserter(text), "{:>12.10g}  {}\n", count.friction,
                   count.exact()
                       ? fmt::format("{}", count.known)
                       : fmt::format("undecided: {} known, {} open", count.known, count.open));
  }
  return text;
}

std::string FrictionSweep::cones_text() const {
  if (found_.cones.empty() && found_.open.empty()) return {};
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "\n{:>5}  {:>14}  {:>14}  {}\n", "", "dead at", "alive at", "in contact (U)");
  std::size_t number = 0;
  for (const auto& cone : found_.cones) {
    fmt::format_to(out, "{:>5}  {:>14.11g}  {:>14.11g}  {}", ++number, cone.begins.lower,
                   cone.begins.upper, names(cone.pattern.contact));
    if (!cone.solid()) fmt::format_to(out, "  at rest: {}", names(cone.pattern.at_rest));
    if (cone.absorbed)
      fmt::format_to(out, "  part of a larger one from {:.11g} on", cone.absorbed->upper);
    text += '\n';
  }
  for (const auto& leaf : found_.open) {
    fmt::format_to(out, "{:>5}  {:>14.11g}  {:>14}  {}\n", "open", leaf.lower, "?",
                   names(leaf.pattern.contact));
  }
  return text;
}

std::string FrictionSweep::ranks_text() const {
  RankTable tree({"branched", "pruned", "found", "iterations"});
  for (const auto& [statistics, tally] : found_.tree_ranks) {
    tree.add(statistics, {tally.branched, tally.dead, tally.found + tally.flat, tally.iterations});
  }
  auto text = "\nThe tree at the largest coefficient:\n" + tree.text();
  if (found_.history_ranks.empty()) return text;
  RankTable histories({"leaves", "programs"});
  for (const auto& [statistics, tally] : found_.history_ranks) {
    histories.add(statistics, {tally.leaves, tally.programs});
  }
  return text + "\nDown from there, leaf by leaf:\n" + histories.text();
}

std::string FrictionSweep::table(const std::string& sentence) const {
  return points_text() + cones_text() + (sentence.empty() ? "" : '\n' + sentence + '\n') +
         ranks_text();
}

Verdict FrictionSweep::verdict() const {
  const auto list = counts();
  const bool undecided = std::ranges::any_of(list, [](const auto& each) { return !each.exact(); });
  const bool sure = !undecided && !exact_.leaves_doubt();
  Verdict verdict{.remarks = {}, .code = found_.answered() && sure ? solved : stopped_early};
  if (exact_.leaves_doubt()) verdict.remarks.push_back(exact_doubt(exact_));
  if (found_.status != engine::Status::solved) {
    verdict.remarks.push_back(fmt::format(
        "stopped early ({}): {}", status_name(found_.status),
        found_.enumerated
            ? fmt::format("of {} of the patterns it is not known where they begin",
                          found_.open.size())
            : "the patterns at the largest coefficient were not all found, so no count is known"));
  } else if (!found_.open.empty()) {
    verdict.remarks.push_back(
        fmt::format("open: of {} it could not be told what they are above a certain coefficient",
                    counted(found_.open.size(), "pattern")));
  }
  if (undecided && found_.answered()) {
    verdict.remarks.emplace_back(
        "open: a point lies within the bracket in which a pattern begins; a smaller --width, or "
        "another point, decides");
  }
  return verdict;
}

}  // namespace

std::unique_ptr<Swept> swept_friction(const SweepOptions& options, problems::Structure structure,
                                      std::vector<double> points, double most) {
  return std::make_unique<FrictionSweep>(options, std::move(structure), std::move(points), most);
}

}  // namespace kusabi::run
