// Sweep of friction: staircase of counts over a range of coefficients.
#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "nodes/wedged/exact_list.hpp"
#include "nodes/wedged/sweep/sweep_search.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/evidence/certificate_file.hpp"
#include "run/output/name_ranges.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/values.hpp"
#include "run/sweep/swept.hpp"
#include "run/wedged/contact_problem.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/fingerprint.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

std::optional<std::string> lists_not_tested() {
  return answer::no_certificate("the lists were not tested");
}

// One certificate for each list, COEFFICIENT.cert.
class ListCertificates final : public wedged::ListRecords {
 public:
  ListCertificates(Session& session, const problems::WedgedProblem& problem,
                   const SweepOptions& options)
      : session_(session), problem_(problem), options_(options) {}

  void expect(std::size_t lists) override { expected_ = lists; }

  wedged::EvidenceRecorder begin(double coefficient) override {
    support::Fingerprint tree;
    tree.add(problem_.provenance.fingerprint);
    tree.add(coefficient);
    file_.emplace(session_, fmt::format("{}/{}.cert", options_.certificates, coefficient),
                  options_.input.file, tree.value(), false);
    return [this](const auto& evidence) { file_->add(evidence); };
  }

  void end(const wedged::PatternFindings& list, std::span<const double> friction) override {
    file_->close();
    if (session_.is_first() && list.whole()) {
      file_->put_in_place(
          certificate_header(problem_, friction, list_theorems(problem_), list.bounds));
      ++written_;
    }
    file_.reset();
  }

  /// Sentence about those that were not written, on rank 0; nothing: all were.
  [[nodiscard]] std::optional<std::string> missing() const {
    if (!expected_) return lists_not_tested();
    if (written_ == *expected_) return {};
    return answer::no_certificate_of(*expected_ - written_,
                                     answer::counted(*expected_, "coefficient"),
                                     "the exact test did not come to their end");
  }

 private:
  Session& session_;
  const problems::WedgedProblem& problem_;
  const SweepOptions& options_;
  std::optional<CertificateFile> file_;
  std::optional<std::size_t> expected_;
  std::size_t written_ = 0;
};

class FrictionSweep final : public Swept {
 public:
  explicit FrictionSweep(const SweepOptions& options)
      : options_(options), parameters_{.maximum = options.maximum(), .width = options.width} {}

  void prepare(CommandRun& run) override {
    contact_ = contact_problem(run, options_.input);
    if (!options_.mu.empty())
      warn_of_facets(run, options_.input, contact_.facets, options_.mu.front());
    friction_at(contact_.problem, parameters_.maximum, options_.input.file);
    keep_state(run, options_.checkpoint, contact_.problem);
  }
  [[nodiscard]] std::string announcement(const std::string& ranks) const override {
    return fmt::format("{}; up to {}; {}", problem_line(contact_.problem),
                       friction_text(contact_.problem, parameters_.maximum), ranks);
  }
  void search(CommandRun& run) override {
    engine::Analysis analysis(run.session().transport(), run.analysis_options(options_.limits));
    found_ = wedged::sweep_friction(analysis, contact_.problem, parameters_);
    const bool searched =
        run.session().from_first_rank([&] { return found_.status == engine::Status::solved; });
    if (options_.mu.empty() && run.session().is_first())
      warn_of_facets(run, options_.input, contact_.facets, smallest_found());
    if (!searched) return;
    const bool certified = !options_.certificates.empty();
    const auto proving =
        options_.prove || certified ? wedged::Proving::always : wedged::Proving::automatic;
    if (certified) certificates_.emplace(run.session(), contact_.problem, options_);
    exact_ = wedged::tested_counts(analysis, {contact_.structure, contact_.problem, proving},
                                   options_.mu, found_, certified ? &*certificates_ : nullptr);
  }
  [[nodiscard]] ordered_json json(CommandRun& run) const override;
  void write_csv(std::ostream& out) const override;
  [[nodiscard]] std::string table() const override {
    return points_text() + cones_text() + ranks_text();
  }
  [[nodiscard]] answer::Verdict verdict() const override;

 private:
  /// The smallest coefficient with a pattern, or the limit of the search: at small coefficients the
  /// normals of facets are not reliable.
  [[nodiscard]] double smallest_found() const;
  /// Counts at the requested points; none if the tree was not finished.
  [[nodiscard]] std::vector<wedged::ConeCount> counts() const;
  [[nodiscard]] std::string points_text() const;
  [[nodiscard]] std::string cones_text() const;
  [[nodiscard]] std::string ranks_text() const;
  [[nodiscard]] std::string names(const support::IndexSet& candidates) const {
    return with_ranges(candidate_names(contact_.problem, candidates));
  }

  const SweepOptions& options_;
  ContactProblem contact_;
  wedged::SweepParameters parameters_;
  wedged::SweepFindings found_;
  wedged::ExactTest exact_;  // of its counts
  std::optional<ListCertificates> certificates_;
};

std::vector<wedged::ConeCount> FrictionSweep::counts() const {
  std::vector<wedged::ConeCount> list;
  if (!found_.enumerated) return list;
  for (const double point : options_.mu) list.push_back(found_.count_at(point));
  return list;
}

double FrictionSweep::smallest_found() const {
  double smallest = parameters_.maximum;
  for (const auto& cone : found_.cones) smallest = std::min(smallest, cone.begins.upper);
  return smallest;
}

ordered_json bracket_json(const std::optional<wedged::FrictionBracket>& bracket) {
  if (!bracket) return {};
  return {{"lower", bracket->lower}, {"upper", bracket->upper}};
}

void add_counts(ordered_json& json, const support::ExactCount& known, std::size_t open) {
  if (open == 0)
    answer::add_count(json, "count", known);
  else
    json["count"] = nullptr;
  answer::add_count(json, "known", known);
  json["open"] = open;
}

ordered_json point_json(const wedged::ConeCount& count) {
  ordered_json point{{"mu", count.friction}};
  add_counts(point, count.known, count.unresolved);
  return point;
}

ordered_json FrictionSweep::json(CommandRun& run) const {
  auto points = ordered_json::array();
  for (const auto& count : counts()) points.push_back(point_json(count));
  auto steps = ordered_json::array();
  const auto ranges = found_.enumerated ? found_.staircase() : std::vector<wedged::CountRange>();
  for (const auto& [from, to, known, open] : ranges) {
    ordered_json step{{"from", from}, {"to", to}};
    add_counts(step, known, open);
    steps.push_back(std::move(step));
  }
  auto patterns = ordered_json::array();
  for (const auto& cone : found_.cones) {
    auto json = pattern_json(contact_.problem, cone.block, cone.pattern);
    json["state"] = cone.solid() ? "feasible" : "flat";
    json["lower"] = cone.begins.lower;
    json["upper"] = cone.begins.upper;
    json["absorbed"] = bracket_json(cone.absorbed);
    patterns.push_back(std::move(json));
  }
  auto open = ordered_json::array();
  for (const auto& leaf : found_.unresolved) {
    auto json = pattern_json(contact_.problem, leaf.block, leaf.pattern);
    json["lower"] = leaf.lower;
    open.push_back(std::move(json));
  }
  return run.result_json(
      problem_json(contact_.structure, contact_.problem, options_.input.file),
      {{"points", std::move(points)},
       {"at_mu_max",
        found_.enumerated ? point_json(found_.count_at(found_.maximum)) : ordered_json()},
       {"staircase", std::move(steps)},
       {"patterns", std::move(patterns)},
       {"open", std::move(open)},
       {"exact", exact_json(exact_)}},
      {{"tree", rank_reports(found_.tree_ranks, counts_json<wedged::SignPatternTally>)},
       {"histories", rank_reports(found_.history_ranks, counts_json<wedged::SweepTree::Tally>)}});
}

void FrictionSweep::write_csv(std::ostream& out) const {
  out << "row,mu,count,known,open\n";
  const auto row = [&](const char* what, double mu, const support::ExactCount& known,
                       std::size_t open) {
    fmt::print(out, "{},{},{},{},{}\n", what, mu, open == 0 ? known.digits() : "", known.digits(),
               open);
  };
  for (const auto& count : counts()) row("point", count.friction, count.known, count.unresolved);
  if (!found_.enumerated) return;
  for (const auto& [from, to, known, open] : found_.staircase()) {
    row("from", from, known, open);
    row("to", to, known, open);
  }
}

std::string FrictionSweep::points_text() const {
  if (options_.mu.empty() || !found_.enumerated) return {};
  std::string text = fmt::format("\n{:>12}  {}\n", "friction", "sign patterns");
  for (const auto& count : counts()) {
    fmt::format_to(std::back_inserter(text), "{:>12.10g}  {}\n", count.friction,
                   count.exact() ? count.known.text()
                                 : fmt::format("undecided: {} known, {} open", count.known.text(),
                                               count.unresolved));
  }
  return text;
}

std::string FrictionSweep::cones_text() const {
  if (found_.cones.empty() && found_.unresolved.empty()) return {};
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "\n{:>5}  {:>14}  {:>14}  {}\n", "", "absent at", "present at",
                 "in contact (U)");
  std::size_t number = 0;
  for (const auto& cone : found_.cones) {
    const auto begins = support::in_table(cone.begins.lower, cone.begins.upper);
    fmt::format_to(out, "{:>5}  {:>14}  {:>14}  {}", ++number, begins.lower, begins.upper,
                   names(cone.pattern.contact));
    if (!cone.solid()) fmt::format_to(out, "  inactive: {}", names(cone.pattern.inactive));
    if (cone.absorbed)
      fmt::format_to(out, "  part of a larger one from {} on",
                     support::in_table(cone.absorbed->lower, cone.absorbed->upper).upper);
    text += '\n';
  }
  for (const auto& leaf : found_.unresolved) {
    fmt::format_to(out, "{:>5}  {:>14}  {:>14}  {}\n", "open",
                   support::rounded_down(leaf.lower, support::digits_of_table), "?",
                   names(leaf.pattern.contact));
  }
  return text + begins_explained;
}

std::string FrictionSweep::ranks_text() const {
  RankTable tree({"branched", "pruned", "found", "iterations"});
  for (const auto& [statistics, tally] : found_.tree_ranks) {
    tree.add(statistics,
             {tally.branched, tally.infeasible, tally.found + tally.flat, tally.iterations});
  }
  auto text = "\nThe tree at the largest coefficient:\n" + tree.text();
  if (found_.history_ranks.empty()) return text;
  RankTable histories({"leaves", "programs"});
  for (const auto& [statistics, tally] : found_.history_ranks) {
    histories.add(statistics, {tally.leaves, tally.programs});
  }
  return text + "\nSearch for the critical coefficients, one leaf at a time:\n" + histories.text();
}

answer::Verdict FrictionSweep::verdict() const {
  answer::FrictionSteps steps{.maximum = parameters_.maximum,
                              .factor = !problems::uniform_friction(contact_.problem),
                              .open_patterns = found_.unresolved.size()};
  steps.remainder = remainder_of(exact_);
  const auto list = counts();
  steps.undecided_points = static_cast<std::uint64_t>(
      std::ranges::count_if(list, [](const auto& each) { return !each.exact(); }));
  if (found_.enumerated) {
    double infeasible = parameters_.maximum;
    for (const auto& cone : found_.cones) infeasible = std::min(infeasible, cone.begins.lower);
    for (const auto& leaf : found_.unresolved) infeasible = std::min(infeasible, leaf.lower);
    const auto last = found_.count_at(found_.maximum);
    steps.count = last.known;
    steps.open_at_most = last.unresolved;
    // The exact test compares decided counts only.
    const bool decided = found_.unresolved.empty() && steps.undecided_points == 0;
    steps.infeasible = support::Bound{infeasible, support::proved_if(exact_.proves() && decided)};
    steps.displacement_ratio = exact_.displacement_ratio;
  }
  answer::Verdict verdict{.ended = found_.status, .answer = steps};
  if (options_.certificates.empty()) return verdict;
  const auto missing = certificates_ ? certificates_->missing() : lists_not_tested();
  if (missing) verdict.missing.push_back(*missing);
  return verdict;
}

}  // namespace

std::unique_ptr<Swept> swept_friction(const SweepOptions& options) {
  return std::make_unique<FrictionSweep>(options);
}

}  // namespace kusabi::run
