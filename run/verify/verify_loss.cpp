// Each state of a statement is a piece of work that the ranks share.
#include "run/verify/verify_loss.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <boost/serialization/string.hpp>
#include <fmt/format.h>

#include "engine/analysis/analysis.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/verdict/words.hpp"
#include "run/verify/limit_statements.hpp"
#include "run/verify/proof_words.hpp"
#include "support/input_error.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/loss_certificate.hpp"
#include "verify/limit/loss_claim.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::run {
namespace {

using verify::LossStatement;

std::vector<LossStatement> losses_in(const std::string& text, const std::string& file) {
  try {
    return verify::read_loss_certificate(text, file);
  } catch (const verify::CertificateError& error) {
    throw WrongInput(error.what());
  }
}

// The structure in the load case of the statement; nothing: there is no such case.
std::optional<problems::CheckedStructure> in_case_of(const LossStatement& statement,
                                                     const problems::CheckedStructure& structure) {
  const auto names = problems::load_cases(structure);
  if (names.empty() && statement.load_case.empty()) return structure;
  for (const auto& name : names) {
    if (verify::on_one_line(name) == statement.load_case)
      return problems::in_chosen_case(structure, name);
  }
  return {};
}

std::vector<std::string> names_of(const LossStatement& statement,
                                  const std::optional<problems::CheckedStructure>& structure) {
  std::vector<std::string> names;
  for (const auto member : statement.lost) {
    const auto& bar = statement.truss.bars[member];
    const auto name = [&](std::size_t node) {
      return structure ? (*structure)->node_names[node] : statement.truss.names[node];
    };
    names.push_back(name(bar.first) + '-' + name(bar.second));
  }
  return names;
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
  std::vector<std::string> refusals;
  double upper = 0;  ///< of the load factor; without refusals
};

CheckedLoss check_statement(CommandRun& run, const VerifyOptions& options,
                            const LossStatement& statement,
                            const std::optional<problems::CheckedStructure>& structure,
                            const Eigen::VectorXd& residual) {
  std::optional<verify::Structure> truss;
  if (structure) {
    const auto of_case = in_case_of(statement, *structure);
    if (!of_case)
      return {.refusals = {fmt::format("{}: no load case {}", options.problem,
                                       support::in_quotes(statement.load_case))}};
    problems::limit_problem(*of_case);
    truss = evidence::verified_structure(*of_case);
    if (statement.residual) {
      if (auto why = set_residual(*truss, residual)) return {.refusals = {*std::move(why)}};
    }
  }
  const verify::LossClaim claim(statement, std::move(truss));
  if (const auto& why = claim.difference()) return {.refusals = {*why}};
  CheckedLoss checked;
  checked.refusals = claim.check_loss(checked.upper);
  if (statement.lower) {
    for (auto& why : check_states(run, claim, statement.states.size()))
      checked.refusals.push_back(std::move(why));
  }
  return checked;
}

// Merges a proved statement into that about all load cases.
void add(const LossStatement& statement, double upper,
         const std::optional<problems::CheckedStructure>& structure, CertificateCheck::Loss& all) {
  all.uncertain = all.uncertain || !statement.truss.uncertain->empty();
  all.kept = std::max<std::uint64_t>(all.kept, statement.kept.size());
  if (!statement.lower || !all.lower)
    all.lower.reset();
  else
    all.lower = std::min(*all.lower, *statement.lower);
  if (upper > all.upper || all.fatal) return;
  all.upper = upper;
  all.fatal = statement.fatal;
  all.lost = names_of(statement, structure);
}

std::string summary_of(const VerifyOptions& options, const std::vector<LossStatement>& statements,
                       const std::optional<problems::CheckedStructure>& structure) {
  std::string summary(truss_of_certificate);
  if (structure) {
    summary = fmt::format(
        "problem: {}, from {}\ncoordinates, yield forces and loads are those of the truss\n",
        (*structure)->name, options.problem);
  }
  if (const double sudden = statements.front().sudden; sudden != 1)
    summary += fmt::format("yield forces divided by {}\n", sudden);
  std::size_t states = 0;
  for (const auto& statement : statements) states += statement.states.size();
  return summary + fmt::format("{} cover all losses\n", counted(states, "carrying stress state"));
}

}  // namespace

VerifyFindings verify_loss(CommandRun& run, const VerifyOptions& options,
                           const std::optional<problems::CheckedStructure>& structure,
                           const Eigen::VectorXd& residual, const std::string& text) {
  const auto statements = losses_in(text, options.certificate);
  const auto cases =
      static_cast<std::uint64_t>(std::ranges::count(statements, false, &LossStatement::residual));
  const auto after_buckling = statements.size() - cases;
  VerifyFindings findings;
  const CertificateCheck::Loss none{.maximum = statements.front().maximum,
                                    .cases = cases,
                                    .lower = std::numeric_limits<double>::infinity(),
                                    .upper = std::numeric_limits<double>::infinity()};
  std::array all{none, none};  // at strength, and at residual strength
  for (const auto& statement : statements) {
    auto [refusals, upper] = check_statement(run, options, statement, structure, residual);
    if (statement.residual && after_buckling != cases)
      refusals.emplace_back("some load cases have no claim at residual strength");
    if (statement.maximum != none.maximum)
      refusals.emplace_back("its load cases have different numbers of lost members");
    for (const auto& why : refusals)
      findings.refusals += fmt::format("{}: refused: {}\n", options.certificate, why);
    findings.check.refusals += refusals.size();
    if (refusals.empty()) add(statement, upper, structure, all[statement.residual ? 1 : 0]);
  }
  if (findings.check.refusals > 0) return findings;
  findings.summary = summary_of(options, statements, structure);
  if (after_buckling > 0)
    findings.summary += fmt::format("all struts at {}, {}\n",
                                    residual_strength(structure.has_value()), loss_claim(all[1]));
  findings.check.claim = std::move(all[0]);
  return findings;
}

}  // namespace kusabi::run
