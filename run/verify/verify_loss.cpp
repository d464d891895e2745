// Each state of a statement is a piece of work that the ranks share.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <boost/serialization/string.hpp>
#include <fmt/format.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "engine/analysis/analysis.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "run/verify/proof_words.hpp"
#include "run/verify/verify.hpp"
#include "support/input_error.hpp"
#include "support/one_line.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/loss_certificate.hpp"
#include "verify/limit/loss_claim.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::run {
namespace {

using verify::LossStatement;

// @pre the members of the statement are those of the structure
std::vector<std::string> names_of(const LossStatement& statement,
                                  const std::vector<std::size_t>& members,
                                  const std::optional<problems::CheckedStructure>& structure) {
  const auto truss = structure ? evidence::verified_structure(*structure) : statement.truss;
  std::vector<std::string> names;
  for (const auto member : members) {
    const auto& bar = truss.bars[member];
    names.push_back(truss.names[bar.first] + '-' + truss.names[bar.second]);
  }
  return names;
}

// The truss of a statement, with its strengths.
verify::Structure truss_of(const LossStatement& statement, const problems::Structure& of_case) {
  return evidence::verified_structure(statement.residual ? problems::after_buckling(of_case)
                                                         : of_case);
}

// A statement without a load case is that of `limit --case`: it gets the name of the first case of
// the file with its truss and loads. @throws support::InputError if limit analysis applies to none
void name_case(const problems::CheckedStructure& structure, LossStatement& statement) {
  if (!statement.load_case.empty()) return;
  std::optional<support::InputError> fault;
  bool any = false;
  for (const auto& name : problems::load_cases(structure)) {
    const auto of_case = problems::in_chosen_case(structure, name);
    if (!limit_fingerprint(of_case, fault)) continue;
    any = true;
    if (statement.residual && !problems::has_struts(structure)) return;
    auto truss = truss_of(statement, of_case);
    if (verify::LossClaim(statement, std::move(truss)).difference()) continue;
    statement.load_case = support::on_one_line(name);
    return;
  }
  if (fault && !any) throw support::InputError(*fault);
}

// Checks the states of a statement on all ranks. @return refusals
std::vector<std::string> check_states(CommandRun& run, const verify::LossClaim& claim,
                                      std::size_t states) {
  if (states == 0) return {};
  engine::Analysis analysis(run.session().transport());
  const auto found = analysis.share<std::string>(
      states, [&](std::uint64_t number) { return claim.refusal_of_state(number).value_or(""); });
  std::vector<std::string> refusals;
  for (std::size_t number = 0; number < found.size(); ++number) {
    if (!found[number].empty())
      refusals.push_back(fmt::format("state {}: {}", number + 1, found[number]));
  }
  return refusals;
}

/// Result for one statement.
struct CheckedLoss {
  std::vector<std::string> refusals{};
  double upper = 0;          ///< of the load factor; without refusals
  HalfWidths half_widths{};  ///< without refusals
  bool as_given = false;     ///< the file has uncertain loads, the statement has none
};

CheckedLoss check_statement(CommandRun& run, const VerifyOptions& options,
                            const LossStatement& statement,
                            const std::optional<problems::CheckedStructure>& structure) {
  std::optional<verify::Structure> truss;
  CheckedLoss checked;
  if (structure) {
    auto loaded = in_case_of_certificate(*structure, statement.load_case);
    if (!loaded) return {.refusals = {no_such_case(options, statement.load_case)}};
    const auto of_case = problems::checked(*std::move(loaded));
    problems::limit_problem(of_case);
    if (statement.residual && !problems::has_struts(*structure)) return {.refusals = {no_struts}};
    truss = truss_of(statement, of_case);
    checked.as_given = statement.truss.uncertain->empty() && truss->uncertain.has_value() &&
                       !truss->uncertain->empty();
  }
  const verify::LossClaim claim(statement, std::move(truss));
  if (const auto& why = claim.difference()) return {.refusals = {*why}};
  checked.half_widths = claim.half_widths();
  checked.refusals = claim.check_loss(checked.upper);
  if (statement.lower) {
    for (auto& why : check_states(run, claim, statement.states.size()))
      checked.refusals.push_back(std::move(why));
  }
  return checked;
}

// The subject in which two statements differ, so that no sentence is about both; empty: none.
std::string difference(const LossStatement& one, const LossStatement& other) {
  if (one.maximum != other.maximum) return "numbers of lost members";
  if (one.sudden != other.sudden) return "dynamic factors";
  return one.kept == other.kept ? "" : "kept members";
}

// Merges a proved statement into that about all load cases.
void add(const LossStatement& statement, const CheckedLoss& checked,
         const std::optional<problems::CheckedStructure>& structure,
         answer::CertificateCheck::Loss& all) {
  const double upper = checked.upper;
  all.uncertain = all.uncertain || !statement.truss.uncertain->empty();
  all.as_given = all.as_given || checked.as_given;
  auto& [lower, least] = all.factor;
  if (!statement.lower)
    lower.reset();
  else if (lower)
    lower->value = std::min(lower->value, *statement.lower);
  if (upper > least->value || all.fatal) return;
  least->value = upper;
  all.fatal = statement.fatal;
  all.lost = names_of(statement, statement.lost, structure);
}

std::string summary_of(const VerifyOptions& options, const std::vector<LossStatement>& statements,
                       const std::vector<HalfWidths>& half_widths,
                       const std::optional<problems::CheckedStructure>& structure) {
  std::string summary(truss_of_certificate);
  if (structure) {
    summary = fmt::format(
        "problem: {}, from {}\ncoordinates, yield forces and loads are those of the truss\n",
        (*structure)->name, options.problem);
  }
  if (const double sudden = statements.front().sudden; sudden != 1)
    summary += fmt::format("yield forces divided by {}\n", sudden);
  std::vector<std::string> cases;
  const bool one_number = half_width_of_all(half_widths).has_value();
  for (std::size_t k = 0; k < statements.size(); ++k) {
    if (statements[k].residual) continue;  // of the same case and loads as the statement before it
    cases.push_back(statements[k].load_case);
    summary += covered_cases_text({cases.back()});
    if (!one_number) summary += half_widths_text(half_widths[k]);
  }
  if (structure) summary += cases_left_text(cases, **structure);
  std::size_t states = 0;
  for (const auto& statement : statements) states += statement.states.size();
  if (states == 0) return summary;
  return summary + fmt::format("{} {} all losses\n",
                               answer::counted(states, "carrying stress state"),
                               states == 1 ? "covers" : "cover");
}

}  // namespace

VerifyFindings verify_loss(CommandRun& run, const VerifyOptions& options,
                           const std::optional<problems::CheckedStructure>& structure,
                           const std::string& text) {
  auto statements = read_certificate_text(
      [&] { return verify::read_loss_certificate(text, options.certificate); });
  for (auto& statement : statements) {
    if (structure) name_case(*structure, statement);
  }
  const auto cases =
      static_cast<std::uint64_t>(std::ranges::count(statements, false, &LossStatement::residual));
  const auto after_buckling = statements.size() - cases;
  const auto& first = statements.front();
  VerifyFindings findings;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const answer::CertificateCheck::Loss none{.maximum = first.maximum,
                                            .cases = cases,
                                            .load_case = cases == 1 ? first.load_case : "",
                                            .factor = support::Bracket::proved(unknown, unknown),
                                            .sudden = first.sudden};
  std::array all{none, none};  // at strength, and at residual strength
  std::vector<HalfWidths> half_widths;
  for (const auto& statement : statements) {
    const auto checked = check_statement(run, options, statement, structure);
    auto refusals = checked.refusals;
    if (statement.residual && after_buckling != cases)
      refusals.emplace_back("some load cases have no claim at residual strength");
    const auto is_same = [&](const LossStatement& other) {
      return other.load_case == statement.load_case && other.residual == statement.residual;
    };
    if (std::ranges::count_if(statements, is_same) > 1)
      refusals.push_back(
          fmt::format("load case {} has two claims", support::in_quotes(statement.load_case)));
    if (const auto why = difference(first, statement); !why.empty())
      refusals.push_back(fmt::format("its load cases have different {}", why));
    for (const auto& why : refusals)
      findings.refusals += fmt::format("{}: refused: {}\n", options.certificate, why);
    findings.check.refusals += refusals.size();
    if (refusals.empty()) add(statement, checked, structure, all[statement.residual ? 1 : 0]);
    half_widths.push_back(checked.half_widths);
  }
  if (findings.check.refusals > 0) return findings;
  for (auto& each : all) {
    each.kept = names_of(first, first.kept, structure);
    each.loads.half_width = half_width_of_all(half_widths);
  }
  findings.summary = summary_of(options, statements, half_widths, structure);
  if (after_buckling > 0) {
    findings.summary +=
        fmt::format("all struts at their strength, an upper value; {}\nall struts at {}, {}\n",
                    answer::loss_claim(all[0]), residual_strength(structure.has_value()),
                    answer::loss_claim(all[1]));
  }
  // The factor at strength bounds that of struts with a residual strength from outside only.
  all[0].struts = after_buckling > 0 || (structure && problems::has_struts(*structure));
  if (all[0].struts) all[0].factor.lower = after_buckling > 0 ? all[1].factor.lower : std::nullopt;
  findings.check.claim = std::move(all[0]);
  return findings;
}

}  // namespace kusabi::run
