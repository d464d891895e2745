// From the file to the bracket, on all ranks.
#include "run/critical.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "nodes/bisection.hpp"
#include "nodes/critical_tree.hpp"
#include "nodes/sign_pattern.hpp"
#include "problems/fingerprint.hpp"
#include "problems/structure_file.hpp"
#include "run/certificate_file.hpp"
#include "run/critical_report.hpp"
#include "run/exit_code.hpp"
#include "run/problem_summary.hpp"
#include "run/rank_table.hpp"
#include "run/result_file.hpp"
#include "run/shown_search.hpp"
#include "run/standard_output.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

/// How far the global search looks unless told: obstacles are not rougher.
constexpr double usual_most = 1000;

void announce(const CriticalOptions& options, const problems::WedgedProblem& problem, int ranks) {
  fmt::print(stderr, "kusabi {} · critical · {}\n{}; up to a friction coefficient of {}{}; {}\n",
             KUSABI_VERSION, options.file, problem_line(problem), options.most.value_or(usual_most),
             uniform_friction(problem) ? "" : " times that of each candidate",
             ranks == 1 ? "1 rank" : fmt::format("{} ranks", ranks));
}

std::int64_t multiples(double most, double width) {
  return static_cast<std::int64_t>(std::llround(most / width));
}

CriticalEntry entry_of(const nodes::SignPattern& pattern, const nodes::CriticalCell& cell,
                       double width, std::vector<double> reaction,
                       std::vector<double> displacement) {
  return {pattern, width * static_cast<double>(cell.dead), width * static_cast<double>(cell.alive),
          std::move(reaction), std::move(displacement)};
}

CriticalFindings global(Session& session, const CriticalOptions& options,
                        const problems::WedgedProblem& problem) {
  const double most = options.most.value_or(usual_most);
  nodes::CriticalTree tree(problem, options.width, multiples(most, options.width));
  engine::Options search_options;
  search_options.goal = engine::Goal::best;
  search_options.order = engine::Order::best_first;
  const auto outcome = shown_search(session, tree, search_options, options.limits, options.quiet);
  CriticalFindings findings;
  if (!session.speaks()) return findings;

  findings.status = status_name(outcome.status);
  RankTable table({"branched", "pruned", "leaves", "programs"});
  nodes::CriticalTree::Tally total;
  for (const auto& [statistics, tally] : outcome.ranks) {
    total += tally;
    table.add(statistics, {tally.branched, tally.dead, tally.leaves, tally.programs});
  }
  findings.statistics = {{"ranks", rank_reports(outcome.ranks, [](const auto& tally) {
                            return ordered_json{{"branched", tally.branched},
                                                {"dead", tally.dead},
                                                {"leaves", tally.leaves},
                                                {"programs", tally.programs}};
                          })}};
  findings.ranks = table.text();
  for (const auto& found : outcome.solutions) {
    const auto& best = found.solution;
    findings.patterns.push_back(
        entry_of(best.pattern, best.cell, options.width, best.reaction, best.displacement));
  }
  const bool whole = outcome.status == engine::Status::solved;
  findings.conclude(whole ? most : std::min(most, std::max(0.0, outcome.bound)));
  // A doubtful leaf counts if it undercuts the answer; those that do are opened on any schedule.
  if (total.doubt < findings.upper.value_or(most)) {
    findings.doubtful = total.doubtful;
    findings.lower = std::min(findings.lower, total.doubt);
  }
  return findings;
}

// All patterns that live at the largest coefficient, told to all ranks.
std::vector<nodes::SignPattern> living_patterns(Session& session, const CriticalOptions& options,
                                                const problems::WedgedProblem& problem,
                                                std::string& status) {
  std::vector<double> friction = problem.friction;
  for (double& mu : friction) mu *= *options.most;
  nodes::SignPatternTree tree(problem, friction);
  const auto outcome = shown_search(session, tree, {}, options.limits, options.quiet);
  const auto packed = session.on_first_rank([&] {
    std::string line = status_name(outcome.status);
    for (const auto& found : outcome.solutions) {
      const auto& [contact, separated] = found.solution.pattern;
      if (found.solution.state == nodes::LeafState::alive)
        line += fmt::format(" {} {}", contact, separated);
    }
    return line;
  });
  std::istringstream words(packed);
  words >> status;
  std::vector<nodes::SignPattern> patterns;
  for (nodes::SignPattern next; words >> next.contact >> next.separated;) patterns.push_back(next);
  return patterns;
}

CriticalFindings pattern_by_pattern(Session& session, const CriticalOptions& options,
                                    const problems::WedgedProblem& problem) {
  CriticalFindings findings;
  const auto patterns = living_patterns(session, options, problem, findings.status);
  if (findings.status != "solved") return findings;  // a part of them would say nothing
  const auto count = static_cast<std::int64_t>(patterns.size());
  const auto sections = count == 0 ? 1 : session.ranks() / count;
  nodes::PatternBisection tree(
      problem, options.width, patterns, multiples(*options.most, options.width),
      options.way == CriticalWay::newton ? nodes::CriticalMethod::newton
                                         : nodes::CriticalMethod::bisection,
      sections);
  const auto outcome = shown_search(session, tree, {}, options.limits, options.quiet);
  if (!session.speaks()) return findings;

  findings.status = status_name(outcome.status);
  RankTable table({"programs"});
  for (const auto& [statistics, tally] : outcome.ranks) table.add(statistics, {tally.programs});
  findings.statistics = {{"ranks", rank_reports(outcome.ranks, [](const auto& tally) {
                            return ordered_json{{"programs", tally.programs}};
                          })}};
  findings.ranks = table.text();
  for (const auto& found : outcome.solutions) {
    const auto& [number, cell] = found.solution;
    findings.patterns.push_back(entry_of(patterns[number], cell, options.width, {}, {}));
  }
  findings.conclude(*options.most);
  if (findings.status != "solved") findings.lower = 0;
  return findings;
}

// The evidence of one end: all sign patterns decided at this coefficient.
void certify(Session& session, const CriticalOptions& options,
             const problems::WedgedProblem& problem, double factor, const std::string& file) {
  std::vector<double> friction = problem.friction;
  for (double& mu : friction) mu *= factor;
  nodes::SignPatternTree tree(problem, friction,
                              {.tolerances = nodes::CriticalFriction::tolerances});
  problems::Fingerprint fingerprint;
  fingerprint.add(problem.fingerprint);
  fingerprint.add(factor);
  CertificateFile certificate(session, file, options.file, fingerprint.value(), false);
  tree.report_to([&](const auto& evidence) { certificate.add(evidence); });
  const auto outcome = shown_search(session, tree, {}, options.limits, options.quiet);
  certificate.close();
  if (!session.speaks()) return;
  if (outcome.status == engine::Status::solved) {
    certificate.put_in_place(certificate_header(problem, friction));
    if (!options.quiet) tell_written({file});
  } else {
    certificate.drop();
    fmt::print(stderr, "no certificate {}: stopped early\n", file);
  }
}

void certify_ends(Session& session, const CriticalOptions& options,
                  const problems::WedgedProblem& problem, const CriticalFindings& findings) {
  const auto ends = session.on_first_rank([&] {
    return findings.upper ? fmt::format("{:a} {:a}", findings.lower, *findings.upper)
                          : fmt::format("{:a}", findings.lower);
  });
  char* rest = nullptr;
  const double lower = std::strtod(ends.c_str(), &rest);
  const double upper = std::strtod(rest, nullptr);
  if (lower > 0) certify(session, options, problem, lower, options.certificate + ".lower");
  if (upper > 0) certify(session, options, problem, upper, options.certificate + ".upper");
}

void check(const CriticalOptions& options) {
  if (options.way != CriticalWay::global && !options.most) {
    throw WrongInput(
        "--mu-max is missing; expected the friction coefficient at which the patterns are looked "
        "for, or --method global");
  }
  const double most = options.most.value_or(usual_most);
  constexpr double most_multiples = 1e15;
  if (options.width >= most || most > most_multiples * options.width) {
    throw WrongInput(fmt::format("--width {}: expected a number below --mu-max {} and above {}",
                                 options.width, most, most / most_multiples));
  }
}

}  // namespace

int critical(Session& session, const CriticalOptions& options) {
  std::optional<ResultFile> result_file;
  const std::string text = session.on_first_rank([&] {
    check(options);
    auto content = problems::file_text(options.file);
    result_file.emplace(options.output, options.file);
    return content;
  });
  const auto problem = problems::wedged_problem(problems::read_structure(text, options.file));
  if (session.speaks() && !options.quiet) announce(options, problem, session.ranks());
  const auto findings = options.way == CriticalWay::global
                            ? global(session, options, problem)
                            : pattern_by_pattern(session, options, problem);
  if (session.speaks()) {
    if (!options.quiet) fmt::print("{}", critical_table(options, problem, findings));
    flush_standard_output();
    result_file->write(critical_json(options, problem, findings));
    if (!options.quiet) tell_written({options.output});
    if (findings.status != "solved") {
      fmt::print(stderr, "stopped early ({}): nothing lives below {:.10g}; more is not proved\n",
                 findings.status, findings.lower);
    }
  }
  const auto status = session.on_first_rank([&] { return findings.status; });
  if (status != "solved") return stopped_early;
  if (!options.certificate.empty()) certify_ends(session, options, problem, findings);
  return solved;
}

}  // namespace kusabi::run
