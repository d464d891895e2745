// Sweep of loads: worst-case limit load factors over a range of uncertainty.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "engine/collectives.hpp"
#include "nodes/limit/limit_sweep.hpp"
#include "problems/limit/half_widths.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "run/output/csv.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/pictures/limit_values.hpp"
#include "run/pictures/structure_json.hpp"
#include "run/session/kept_state.hpp"
#include "run/session/progress_line.hpp"
#include "run/sweep/swept.hpp"
#include "support/rounded_bounds.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

const char* state_of(const limit::LimitWorstCase& worst,
                     const limit::GuaranteedInterval& interval) {
  if (!worst.proved() || !is_proved(interval.standing())) return "open";
  return interval.at_none ? "not-carried" : "solved";
}

// Load factors below the worst case that are carried under every admissible load.
std::string lower_end_text(const limit::GuaranteedInterval& interval) {
  if (interval.is_empty())
    return fmt::format("; no factor is common to all loads{}",
                       answer::unless_proved(interval.standing()));
  if (!interval.has_factors()) return "; the least factor for all loads is undecided";
  const auto [low, high] = support::inside(interval.minimum.at_most(), interval.largest.at_least(),
                                           support::digits_of_table);
  return fmt::format("; carried under all loads from {}{} to {}", low,
                     answer::unless_proved(interval.minimum.upper->standing), high);
}

class LoadSweep final : public Swept {
 public:
  explicit LoadSweep(const SweepOptions& options) : options_(options) {}

  void prepare(CommandRun& run) override {
    const auto structure = options_.input.structure(run);
    refuse_struts(structure);
    if (structure->imposed_forces.size() > 0) {
      warn_all(run.session(),
               {"kusabi sweep --alpha ignores temperature and displaced supports: a limit load "
                "does not depend on them"});
    }
    truss_ = problems::in_chosen_case(structure, options_.load_case);
    problem_ = problems::limit_problem(truss_);
    fix_groups(*structure);
    const auto& uncertain = problem_.uncertain;
    if (uncertain.empty()) {
      throw WrongInput(
          "--alpha: no load on a free displacement is uncertain; expected [[uncertainty]] in the "
          "problem file");
    }
    if (std::ranges::all_of(uncertain, &problems::UncertainColumn::in_file)) {
      throw WrongInput(
          "--alpha: the file gives every uncertain load its own half-width; expected uncertain "
          "loads without alpha");
    }
    engine::require_equal_on_all_ranks(run.session().transport(), problem_.fingerprint);
    run.keep_state(options_.checkpoint, {{"the problem", hexadecimal(problem_.fingerprint)}});
  }
  [[nodiscard]] std::string announcement(const std::string& ranks) const override {
    return fmt::format("{}: {}, {}, {}, alpha up to {}{}; {}", problem_.name,
                       problem_.dimension == 2 ? "in the plane" : "in space",
                       answer::counted(problem_.member_count(), "member"),
                       answer::counted(problem_.uncertain_count(), "uncertain load"),
                       options_.alpha.back(),
                       problems::alpha_is_force(problem_) ? ' ' + problem_.units.force : "", ranks);
  }
  void search(CommandRun& run) override {
    engine::Analysis analysis(run.session().transport(), run.analysis_options(options_.limits));
    found_ = limit::sweep_limit_loads(analysis, truss_, problem_, options_.alpha,
                                      !options_.certificates.empty());
  }
  [[nodiscard]] ordered_json json(CommandRun& run) const override;
  void write_csv(std::ostream& out) const override;
  void write_certificates(OutputFolder& folder) const override;
  [[nodiscard]] std::string table() const override;
  [[nodiscard]] answer::Verdict verdict() const override;

 private:
  /// lambda_min over multiples of the largest alpha; null if unknown.
  [[nodiscard]] const limit::LoadCurve* curve() const {
    const auto& curve = found_.last.worst_curve;
    return curve && !curve->pieces.empty() ? &*curve : nullptr;
  }
  void fix_groups(const problems::Structure& whole);
  void refuse_struts(const problems::CheckedStructure& structure) const;

  const SweepOptions& options_;
  problems::CheckedStructure truss_;
  problems::LimitProblem problem_;
  limit::LimitSweep found_;
};

// The factors of struts at their strength are upper values only.
void LoadSweep::refuse_struts(const problems::CheckedStructure& structure) const {
  if (!problems::has_struts(structure)) return;
  throw WrongInput(
      fmt::format("--alpha: {} has members with `residual`, whose residual strength the sweep does "
                  "not analyse; expected a file without them, or kusabi limit --alpha",
                  options_.input.file));
}

void LoadSweep::fix_groups(const problems::Structure& whole) {
  problems::LimitProblem* const one = &problem_;
  try {
    problems::fix_half_widths(problem_, problems::of_cases(options_.group_alpha, {&one, 1}, whole));
  } catch (const problems::HalfWidthError& error) {
    throw WrongInput(fmt::format("--group-alpha: {}", error.what()));
  }
}

ordered_json LoadSweep::json(CommandRun& run) const {
  auto points = ordered_json::array();
  for (const auto& [alpha, worst, interval] : found_.points) {
    ordered_json point{{"alpha", alpha}};
    point.update(interval_json(interval));
    point["state"] = state_of(worst, interval);
    points.push_back(std::move(point));
  }
  ordered_json result{{"points", std::move(points)}};
  if (curve())
    add_curve(result, "curve", problem_, *curve(), options_.alpha.back());
  else
    result["curve"] = ordered_json::array();
  return run.result_json(limit_problem_json(problem_, truss_, options_.input.file),
                         std::move(result), {{"ranks", run.session().ranks()}});
}

// Cells of a bound: its value, which is finite, and its standing; empty if it is open.
void add_cells(CsvWriter& csv, const std::optional<support::Bound>& bound) {
  if (bound)
    csv.number(bound->value).word(answer::standing_word(bound->standing));
  else
    csv.nothing().nothing();
}

// Bounds of a factor of the curve. @param error absent: it is computed
support::Bracket around(double factor, const std::optional<double>& error) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  if (!error) return {support::Bound{factor}, support::Bound{factor}};
  if (*error == 0) return support::Bracket::proved(factor, factor);
  return support::Bracket::proved(std::nextafter(factor - *error, -endless),
                                  std::nextafter(factor + *error, endless));
}

void LoadSweep::write_csv(std::ostream& out) const {
  CsvWriter csv(out);
  for (const char* const column :
       {"row", "alpha", "lower", "lower_standing", "upper", "upper_standing", "carried_from",
        "carried_from_standing", "state"})
    csv.word(column);
  csv.end_row();
  for (const auto& [alpha, worst, interval] : found_.points) {
    csv.word("point").number(alpha);
    for (const auto& bound : {worst.ends.lower, worst.ends.upper,
                              interval.has_factors() ? interval.minimum.upper : std::nullopt})
      add_cells(csv, bound);
    csv.word(state_of(worst, interval)).end_row();
  }
  if (!curve()) return;
  const auto row = [&](double beta, double factor, const std::optional<double>& error) {
    csv.word("breakpoint").number(beta * options_.alpha.back());
    const auto ends = around(factor, error);
    for (const auto& bound : {ends.lower, ends.upper}) add_cells(csv, bound);
    csv.nothing().nothing().nothing().end_row();
  };
  for (const auto& piece : curve()->pieces) row(piece.from.at, piece.from.factor, piece.error);
  const auto& last = curve()->pieces.back();
  row(last.to, last.factor_at_end, last.error);
}

void LoadSweep::write_certificates(OutputFolder& folder) const {
  for (std::size_t point = 0; point < found_.theorems.size(); ++point) {
    auto theorems = found_.theorems[point];
    if (theorems.empty()) continue;
    for (auto& each : theorems) each.load_case = options_.load_case;
    folder.write(fmt::format("{}.cert", options_.alpha[point]),
                 [&](std::ostream& out) { out << truss_certificate_text(theorems); });
  }
}

std::string LoadSweep::table() const {
  std::string text;
  const auto out = std::back_inserter(text);
  if (!found_.points.empty()) text += "\n       alpha  worst-case load factor\n";
  for (const auto& [alpha, worst, interval] : found_.points) {
    fmt::format_to(out, "{:>12.8g}  ", alpha);
    if (interval.at_none) {
      fmt::format_to(out, "some admissible load is carried at no factor, {}\n",
                     answer::standing_word(*interval.at_none));
    } else {
      const auto& ends = worst.ends;
      const bool apart = !worst.proved() && ends.has_proved_ends();
      fmt::format_to(out, "{}{}{}\n", factor_text(ends),
                     apart ? "; open: the two bounds differ" : "", lower_end_text(interval));
    }
  }
  if (curve())
    text += '\n' +
            curve_text(problem_, *curve(), "alpha", "some admissible load", options_.alpha.back());
  return text;
}

answer::Verdict LoadSweep::verdict() const {
  answer::LoadSteps steps{.points = found_.points.size(), .points_asked = options_.alpha.size()};
  if (const auto& nominal = found_.last.nominal) {
    steps.nominal =
        found_.last.nominal_factors.largest.lower.value_or(support::Bound{nominal->factor});
  } else if (found_.last.status == limit::LoadStatus::not_carried) {
    steps.nominal_at_none = support::Standing::proved;
  }
  if (problems::alpha_is_force(problem_)) steps.force = problem_.units.force;
  if (!found_.points.empty()) {
    const auto& [alpha, worst, interval] = found_.points.back();
    steps.half_width = alpha;
    if (interval.at_none) {
      steps.worst_at_none = interval.at_none;
    } else {
      steps.worst = worst.ends;
      steps.minimum = interval.minimum;
    }
  }
  steps.open = !found_.whole(options_.alpha.size());
  answer::Verdict verdict{.ended = found_.status, .answer = steps};
  const auto without =
      std::ranges::count(found_.theorems, true, &std::vector<verify::TrussTheorem>::empty);
  if (without > 0)
    verdict.missing.push_back(answer::no_certificate_of(
        static_cast<std::size_t>(without),
        answer::counted(found_.theorems.size(), "computed half-width"), answer::not_all_is_proved));
  return verdict;
}

}  // namespace

std::unique_ptr<Swept> swept_loads(const SweepOptions& options) {
  return std::make_unique<LoadSweep>(options);
}

}  // namespace kusabi::run
