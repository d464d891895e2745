// Each state of a statement is a piece of work that the ranks share.
#include "run/verify/verify_loss.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
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

}  // namespace

VerifyFindings verify_loss(CommandRun& run, const VerifyOptions& options,
                           const std::optional<problems::CheckedStructure>& structure,
                           const std::string& text) {
  const auto statements = losses_in(text, options.certificate);
  VerifyFindings findings;
  const auto refuse = [&](const std::string& why) {
    ++findings.check.refusals;
    findings.refusals += fmt::format("{}: refused: {}\n", options.certificate, why);
  };
  CertificateCheck::Loss all{.most = statements.front().most,
                             .cases = statements.size(),
                             .lower = std::numeric_limits<double>::infinity(),
                             .upper = std::numeric_limits<double>::infinity()};
  std::size_t states = 0;
  for (const auto& statement : statements) {
    std::optional<verify::Structure> truss;
    if (structure) {
      const auto of_case = in_case_of(statement, *structure);
      if (!of_case) {
        refuse(fmt::format("{}: no load case {}", options.problem,
                           support::in_quotes(statement.load_case)));
        continue;
      }
      problems::limit_problem(*of_case);
      truss = evidence::verified_structure(*of_case);
    }
    const verify::LossClaim claim(statement, std::move(truss));
    if (const auto& why = claim.difference()) {
      refuse(*why);
      continue;
    }
    double upper = 0;
    for (const auto& why : claim.check_loss(upper)) refuse(why);
    if (statement.lower) {
      for (const auto& why : check_states(run, claim, statement.states.size())) refuse(why);
    }
    states += statement.states.size();
    if (statement.most != all.most) refuse("its load cases have different numbers of lost members");
    all.uncertain = all.uncertain || !statement.truss.uncertain->empty();
    all.kept = std::max<std::uint64_t>(all.kept, statement.kept.size());
    if (!statement.lower || !all.lower) {
      all.lower.reset();
    } else {
      all.lower = std::min(*all.lower, *statement.lower);
    }
    if (upper > all.upper || all.fatal) continue;
    all.upper = upper;
    all.fatal = statement.fatal;
    all.lost = names_of(statement, structure);
  }
  if (findings.check.refusals > 0) return findings;
  auto& summary = findings.summary;
  if (structure) {
    fmt::format_to(std::back_inserter(summary),
                   "problem: {}, from {}\ncoordinates, yield forces and loads are those of the "
                   "truss\n",
                   (*structure)->name, options.problem);
  } else {
    summary +=
        "the truss is that of the certificate; --problem FILE proves the result for a problem "
        "file\n";
  }
  if (const double sudden = statements.front().sudden; sudden != 1)
    fmt::format_to(std::back_inserter(summary), "yield forces divided by {}\n", sudden);
  fmt::format_to(std::back_inserter(summary), "{} cover all losses\n",
                 counted(states, "carrying stress state"));
  findings.check.claim = std::move(all);
  return findings;
}

}  // namespace kusabi::run
