// `kusabi hold`: options, stages and results, on all ranks.
#include "run/hold/hold.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "nodes/wedged/hold/exact_hold.hpp"
#include "nodes/wedged/hold/hold_record.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "problems/wedged/problem_block.hpp"
#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"
#include "run/evidence/certificate_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/results/hold_chart.hpp"
#include "run/session/session.hpp"
#include "run/wedged/contact_problem.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/fingerprint.hpp"
#include "support/one_line.hpp"

namespace kusabi::run {
namespace {

/// NAME.lower and NAME.upper of a holding friction coefficient, NAME of load factors at one
/// coefficient (docs/certificates.md).
struct HoldCertificates {
  std::string name;               ///< empty: none is written
  std::string input;              ///< problem file
  std::string load_case;          ///< empty: all loads of the file act
  std::optional<double> total{};  ///< sum of the normal reactions in all states
  bool quiet = false;             ///< file names are not printed
};

constexpr std::array grip_words{"above", "below"};

std::string sets(const wedged::LoadedPattern& pattern) {
  return support::hexadecimal(pattern.contact) + ' ' + support::hexadecimal(pattern.separated);
}

class HoldCertificate final : public wedged::HoldRecord {
 public:
  HoldCertificate(Session& session, const HoldCertificates& certificates, const std::string& name,
                  const wedged::LoadedProblem& loaded, double mu, std::uint64_t fingerprint)
      : session_(session),
        certificates_(certificates),
        name_(name),
        loaded_(loaded),
        friction_(wedged::friction_with_loads(loaded.problem, mu, 0)),
        file_(session, name, certificates.input, fingerprint, false) {}

  bool tree(std::uint32_t block, const wedged::TreeEvidence& tree) override {
    auto line = fmt::format("none {} {}", block + 1, tree.shares.size());
    for (const auto& share : tree.shares)
      append_numbers(line, std::array{share.dead, share.reference});
    if (!tree.weights.empty()) {
      line += " weights";
      append_numbers(line, tree.weights);
    }
    if (const auto& grip = tree.grip; grip && grip->kind != wedged::GripRestriction::Kind::equal) {
      line +=
          fmt::format(" {} {:a}", grip_words.at(static_cast<std::size_t>(grip->kind)), grip->total);
    }
    if (tree.except_dead) line += " except dead";
    for (auto bound : tree.bounds) {
      bound.theorem = static_cast<std::uint32_t>(theorems_.size());
      bounds_.push_back(std::move(bound));
    }
    theorems_.push_back(line + '\n');
    for (const auto& node : tree.nodes.value()) {
      line = fmt::format("{} {} {}", node.by_cuts ? "cut" : "infeasible", theorems_.size(),
                         sets(node.pattern));
      append_numbers(line, node.numbers);
      file_.add(std::string_view(line += '\n'));
    }
    return true;
  }

  void state(std::uint32_t block, const std::optional<wedged::LoadShare>& share,
             const wedged::LoadedPattern& pattern, std::span<const double> numbers) override {
    if (!session_.is_first()) return;
    auto line = fmt::format("{} {}", share ? "held" : "wedged", block + 1);
    if (share) append_numbers(line, std::array{share->dead, share->reference});
    line += ' ' + sets(pattern);
    append_numbers(line, numbers);
    file_.add(std::string_view(line += '\n'));
  }

  void finish() override {
    file_.close();
    if (!session_.is_first()) return;
    file_.put_in_place(
        certificate_header(loaded_.problem, friction_, theorems_, bounds_, load_lines()));
    if (!certificates_.quiet) print_written({name_});
  }

 private:
  [[nodiscard]] std::string load_lines() const {
    std::string text = "loads 2\ncase";
    if (!certificates_.load_case.empty())
      text += ' ' + support::on_one_line(certificates_.load_case);
    const auto forces = wedged::equivalent_forces(loaded_);
    const auto add = [&](const char* name, const auto& numbers) {
      text += fmt::format("\n{}", name);
      append_numbers(text, std::span(numbers.data(), static_cast<std::size_t>(numbers.size())));
    };
    add("clearance", loaded_.clearance);
    add("dead", forces.dead);
    add("reference", forces.reference);
    text += "\ntotal";
    if (certificates_.total) append_numbers(text, std::array{*certificates_.total});
    return text + '\n';
  }

  Session& session_;
  HoldCertificates certificates_;
  std::string name_;
  const wedged::LoadedProblem& loaded_;
  std::vector<double> friction_;
  CertificateFile file_;
  std::vector<std::string> theorems_;
  std::vector<wedged::ProvedBound> bounds_;
};

// Empty if there is no name. Session and problem must outlive it.
wedged::HoldRecorder hold_recorder(Session& session, HoldCertificates certificates,
                                   const wedged::LoadedProblem& loaded) {
  if (certificates.name.empty()) return {};
  return [&session, &loaded, certificates = std::move(certificates)](
             wedged::HoldClaim end, double mu) -> std::unique_ptr<wedged::HoldRecord> {
    support::Fingerprint fingerprint;
    fingerprint.add(loaded.problem.provenance.fingerprint);
    fingerprint.add(mu);
    const char* const which = end == wedged::HoldClaim::lower   ? ".lower"
                              : end == wedged::HoldClaim::upper ? ".upper"
                                                                : "";
    return std::make_unique<HoldCertificate>(session, certificates, certificates.name + which,
                                             loaded, mu, fingerprint.value());
  };
}

class Hold final : public Subcommand {
 public:
  void describe(OptionTable& table) override;
  void read(CommandRun& run) override { options_.input.read(run); }
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] answer::Verdict verdict() const override;

 private:
  /// The structure under the loads of one load case.
  struct LoadCase {
    std::string name;  ///< empty: all loads of the file act
    problems::CheckedStructure structure;
    wedged::LoadedProblem problem{};
    std::unique_ptr<wedged::ExactHold> exact{};
  };

  void check() const override;
  [[nodiscard]] nlohmann::ordered_json json(const CommandRun& run) const;
  void refuse_without_loads(const LoadCase& loads) const;
  void refuse_total(const wedged::LoadedProblem& loaded) const;
  wedged::LoadedProblem loads_of_cases(const problems::CheckedStructure& structure,
                                       const support::LongWork& work);
  void prepare_loads(CommandRun& run, LoadCase& loads);
  HoldFindings search_under(engine::Analysis& analysis, CommandRun& run, const LoadCase& loads);
  void search_at(engine::Analysis& analysis, const LoadCase& loads,
                 const wedged::HoldParameters& parameters, double mu, HoldFindings& findings);
  [[nodiscard]] const LoadCase& shown() const { return loads_.at(shown_); }
  [[nodiscard]] const wedged::LoadedProblem& problem() const { return shown().problem; }

  HoldOptions options_;
  std::vector<problems::FacetWarning> facets_;
  std::deque<LoadCase> loads_;  // of each load case, which are answered one after the other
  std::size_t shown_ = 0;       // the one whose state and motion are shown
  HoldFindings findings_;
};

void Hold::describe(OptionTable& table) {
  table.problem(options_.input.file);
  table.points(
      "--mu", options_.points, at_least(0),
      "friction coefficient, or several: START:END:STEP, or a list with commas. Default: the "
      "smallest one for the dead load is computed");
  table.load_case(options_.load_case, ". Default: what all load cases of the file hold");
  table.number("--mu-max", &options_.parameters.maximum, above(0),
               "upper limit of the search for the smallest coefficient");
  table
      .number("--total", &options_.parameters.total, above(0),
              "consider only states whose normal reactions add up to this force, such as a "
              "clamping force")
      .needs("--mu");
  table
      .flag("--grip", options_.grip,
            "also compute the least and the largest sum of the normal reactions over all states "
            "under the dead load")
      .needs("--mu");
  table
      .flag("--diagram", options_.diagram,
            "the pairs of factors of the reference loads of two load cases, as convex pieces with "
            "their sign patterns")
      .needs("--mu");
  table.choice(
      "--cuts", options_.parameters.tightening, cuts_words(),
      "cuts from bounds of the reaction and the gap of each candidate under the loads, added "
      "to every node: for large trees (auto), never (none), or always (always). The trees "
      "of diagrams have none, nor have, with --certificate, those of --grip");
  table.output();
  table.csv_of("intervals, or of the vertices of the pieces");
  table.further_output("--svg", "SVG file of the pieces, or of the intervals");
  table
      .file("--certificate", options_.certificate, Role::evidence,
            "certificate for kusabi verify; without --mu one for each bound, NAME.lower and "
            "NAME.upper")
      .ends_in({".lower", ".upper"});
  table.search_limits(options_.limits);
  table.resume(options_.checkpoint,
               ". With --certificate the trees of the answer are then searched again");
  table.save_on(options_.checkpoint);
  table.quiet_and_serial();
}

// Files without the requested load are refused.
void Hold::refuse_without_loads(const LoadCase& loads) const {
  const bool dead = loads.problem.has_dead_part();
  const bool given = !options_.points.empty();
  if (dead || (given && loads.problem.has_reference)) return;
  throw WrongInput(fmt::format(
      "{}: there is no {}{}; expected [[loads]] of kind \"dead\"{}, or a clearance of [[contact]]",
      options_.input.file, given ? "load" : "dead load",
      loads_.size() > 1 ? " in load case " + support::in_quotes(loads.name) : "",
      given ? " or \"reference\"" : ", or --mu for the factors of the reference load"));
}

// Wedged parts would add any sum to that of the others.
void Hold::refuse_total(const wedged::LoadedProblem& loaded) const {
  if (!options_.parameters.total) return;
  if (options_.grip) throw WrongInput("--grip: the sum is given by --total; expected one of them");
  const auto parts = problems::blocks_of(loaded.problem).size();
  if (parts != 1) {
    throw WrongInput(fmt::format(
        "--total: the candidates are in {} decoupled parts; expected a file with one", parts));
  }
}

// The two cases of a diagram, and the loads of both.
wedged::LoadedProblem Hold::loads_of_cases(const problems::CheckedStructure& structure,
                                           const support::LongWork& work) {
  const auto& file = options_.input.file;
  options_.cases = problems::load_cases(structure);
  if (options_.cases.size() != 2) {
    throw WrongInput(
        fmt::format("{}: --diagram: the file has {}; expected two, each with a reference "
                    "load",
                    file, answer::counted(options_.cases.size(), "load case")));
  }
  for (const auto& load : structure->loads) {
    const bool dead = load.kind == problems::Load::Kind::dead;
    if (dead == load.load_case.empty()) continue;
    throw WrongInput(fmt::format(
        "{}: --diagram: {}", file,
        dead ? "a dead load belongs to one load case; expected dead loads common to all cases"
             : "a reference load belongs to no load case; expected one of the two"));
  }
  auto loaded = wedged::loaded_problem(structure, {options_.cases[0], options_.cases[1]}, work);
  if (!loaded.has_reference || !loaded.has_second) {
    throw WrongInput(
        fmt::format("{}: --diagram: a load case has no reference load; expected one in "
                    "each",
                    file));
  }
  for (const wedged::LoadShare each : {wedged::LoadShare{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    if (wedged::work_on_other_modes(loaded, each) <= wedged::negligible_work) continue;
    throw WrongInput(
        fmt::format("{}: --diagram: a load moves a body in a direction that no candidate resists; "
                    "expected supports or candidates that do",
                    file));
  }
  return loaded;
}

void Hold::check() const {
  const auto tightening = options_.parameters.tightening;
  const bool others = options_.grip || options_.parameters.total || !options_.load_case.empty() ||
                      !options_.certificate.empty() || tightening != wedged::Tightening::automatic;
  if (options_.diagram && others) {
    throw WrongInput(
        "--diagram: cannot be combined with --case, --total, --grip, --cuts or --certificate; "
        "expected --diagram alone");
  }
  if (options_.points.size() > 1 && (options_.diagram || !options_.certificate.empty())) {
    throw WrongInput(
        "--mu: --diagram and --certificate are for one friction coefficient; expected one");
  }
}

void Hold::prepare(CommandRun& run) {
  if (options_.points.empty() && (run.wants("--csv") || run.wants("--svg")))
    throw WrongInput("--csv, --svg: without --mu there are no load factors; expected --mu");
  auto [structure, facets] = options_.input.structure_and_facets(run);
  facets_ = std::move(facets);
  if (!options_.points.empty())
    warn_of_facets(run, options_.input, facets_, options_.points.front());
  structure = problems::in_chosen_case(structure, options_.load_case);
  problems::check_certain(structure);
  warn_all(run.session(), ignored_uncertainty(structure, run.name()));
  const auto cases =
      options_.diagram ? std::vector<std::string>() : problems::load_cases(structure);
  if (cases.empty()) loads_.push_back({options_.load_case, structure});
  for (const auto& name : cases)
    loads_.push_back({name, problems::checked(problems::in_load_case(structure, name))});
  if (loads_.size() > 1 && (options_.grip || !options_.certificate.empty())) {
    throw WrongInput(fmt::format(
        "{}: the file has load cases, and --grip and --certificate are for one of them; "
        "expected --case with one of {}",
        options_.input.file, problems::choice_of_load_cases(structure)));
  }
  for (auto& each : loads_) prepare_loads(run, each);
  run.keep_state(options_.checkpoint,
                 {{"the problem", hexadecimal(problem().problem.provenance.fingerprint)},
                  {"the loads", hexadecimal(fingerprint_of_loads(structure))}});
}

void Hold::prepare_loads(CommandRun& run, LoadCase& loads) {
  const auto& structure = loads.structure;
  auto& loaded = loads.problem;
  loaded = run.within_limits([&](const auto& work) {
    return options_.diagram ? loads_of_cases(structure, work)
                            : wedged::loaded_problem(structure, work);
  });
  auto trials = options_.points;  // or the first coefficient of the search
  if (trials.empty()) trials.push_back(std::min(1.0, options_.parameters.maximum));
  for (const double mu : trials) friction_at(loaded.problem, mu, options_.input.file);
  refuse_without_loads(loads);
  refuse_total(loaded);
  make_equal_on_all_ranks(run.session(), loaded.problem);
  if (options_.diagram) return;
  loads.exact = run.within_limits([&](const auto& work) {
    return std::make_unique<wedged::ExactHold>(run.session().transport(), loaded, structure,
                                               options_.parameters.total,
                                               !options_.certificate.empty(), work);
  });
}

std::string Hold::announcement(const std::string& ranks) const {
  const auto& points = options_.points;
  const auto text = [&](double mu) { return friction_text(problem().problem, mu); };
  const auto at = points.empty()       ? fmt::format("up to {}", text(options_.parameters.maximum))
                  : points.size() == 1 ? fmt::format("at {}", text(points.front()))
                                       : fmt::format("at {} coefficients, up to {}", points.size(),
                                                     text(points.back()));
  return fmt::format("{}; {}{}; {}", problem_line(problem().problem),
                     loads_.size() > 1 ? answer::counted(loads_.size(), "load case") + ", " : "",
                     at, ranks);
}

void Hold::search(CommandRun& run) {
  engine::Analysis analysis(run.session().transport(), run.analysis_options(options_.limits));
  if (options_.diagram) {
    findings_.diagram = wedged::diagram_of(analysis, problem(), options_.points.front(),
                                           options_.parameters.precision);
    return;
  }
  std::vector<HoldFindings> found;
  std::vector<std::string> names;
  for (const auto& each : loads_) names.push_back(each.name);
  for (const auto& each : loads_) {
    found.push_back(search_under(analysis, run, each));
    if (found.back().status() != engine::Status::solved) break;
  }
  findings_ =
      loads_.size() == 1 ? std::move(found.front()) : held_in_all(std::move(found), names, shown_);
  if (const auto& friction = findings_.friction; friction && friction->bracket.upper)
    warn_of_facets(run, options_.input, facets_, friction->bracket.upper->value);
}

HoldFindings Hold::search_under(engine::Analysis& analysis, CommandRun& run,
                                const LoadCase& loads) {
  HoldFindings findings{.load_case = loads.name, .of_reference = loads.problem.has_reference};
  auto& exact = *loads.exact;
  auto parameters = options_.parameters;
  const auto files = hold_recorder(
      run.session(),
      {options_.certificate, options_.input.file, loads.name, parameters.total, run.quiet()},
      loads.problem);
  exact.note_statics(parameters);
  if (options_.certificate.empty()) parameters.nodes_of_evidence = wedged::max_nodes_of_evidence;
  findings.enclosed = exact.can_prove();
  if (findings.enclosed) {
    parameters.recorder = [&exact, files](wedged::HoldClaim claim, double mu) {
      return exact.record(claim, mu, files ? files(claim, mu) : nullptr);
    };
  }
  if (options_.points.empty()) {
    findings.friction = wedged::holding_friction(analysis, loads.problem, parameters);
    exact.set_standings(*findings.friction);
  }
  for (const double mu : options_.points) {
    search_at(analysis, loads, parameters, mu, findings);
    if (findings.status() != engine::Status::solved) return findings;
  }
  for (const auto& load : excluded_loads(options_, loads.problem, findings)) {
    if (auto motion = wedged::excluding_motion(loads.structure, loads.problem, load,
                                               analysis.budget().stop()))
      findings.exclusions.push_back(*std::move(motion));
  }
  return findings;
}

void Hold::search_at(engine::Analysis& analysis, const LoadCase& loads,
                     const wedged::HoldParameters& parameters, double mu, HoldFindings& findings) {
  const auto record =
      parameters.recorder ? parameters.recorder(wedged::HoldClaim::factors, mu) : nullptr;
  // A configuration that is wedged at some coefficient is so at every larger one.
  const bool wedged = !findings.points.empty() && findings.points.back().factors.any_by_wedging;
  HeldPoint point{.mu = mu, .load_case = loads.name};
  if (wedged) {
    point.factors = findings.points.back().factors;
    point.factors.costs.clear();
  } else {
    point.factors = wedged::held_factors(analysis, loads.problem, mu, parameters, record.get());
  }
  if (options_.grip && point.factors.status == engine::Status::solved)
    point.grip = wedged::grip_range(analysis, loads.problem, mu, parameters, record.get());
  findings.ended = point.status();
  if (record) {
    record->finish();
    findings.certified = loads.exact->proves_factors();
  }
  if (!wedged) loads.exact->set_standings(point.factors);
  if (point.grip) loads.exact->set_standings(*point.grip);
  if (options_.points.size() > 1 && findings.ended != engine::Status::solved)
    findings.costs_left = point.costs();
  else
    findings.points.push_back(std::move(point));
}

std::vector<Step> Hold::results(CommandRun& run) {
  return {
      run.result([this, &run] { return json(run); }),
      run.file("--csv", [this](auto& out) { write_held_csv(out, options_, problem(), findings_); }),
      run.file("--svg",
               [this, &run](auto& out) {
                 const ResultReader result(json(run), "the result");
                 write_chart(out, hold_chart(result, answer::headline(verdict())).value());
               }),
      run.answer([this] { return hold_table(options_, problem(), findings_); })};
}

nlohmann::ordered_json Hold::json(const CommandRun& run) const {
  return run.result_json(problem_json(shown().structure, problem().problem, options_.input.file),
                         hold_json(options_, *shown().structure, problem(), findings_),
                         costs_json(findings_));
}

answer::Verdict Hold::verdict() const {
  return hold_verdict(options_, problem(), findings_);
}

}  // namespace

constexpr Registration hold_subcommand{
    {.name = "hold",
     .chapter = "Loads held by friction",
     .purpose = "loads that contact with friction can hold",
     .description =
         "The smallest friction coefficient at which the structure can hold its dead load; with "
         "--mu, the factors of the reference load that it can hold in addition. Each bound is "
         "marked as proved or computed.",
     .example = "examples/ladder.toml"},
    make<Hold>};

}  // namespace kusabi::run
