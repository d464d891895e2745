// Truss of each statement, its upper bound on every rank, its nodes shared among the ranks.
#include "run/verify/limit_statements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <boost/serialization/string.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/analysis/analysis.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "support/input_error.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/sign_cover.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::run {
namespace {

using verify::LimitClaim;
using verify::LimitStatement;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Result for the claim of one node.
struct NodeVerdict {
  double lower = -infinity;  // rounded down
  std::string refusal;       // empty: proved

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& lower& refusal;
  }
};

// A truss that statements refer to.
struct AgreedTruss {
  verify::LimitTruss truss;
  std::string load_case;
  std::uint64_t fingerprint = 0;
  std::vector<std::string> names;  // of its uncertain loads; empty: unnamed
};

// The load cases that a statement may refer to.
std::vector<std::string> cases_for(const LimitStatement& statement,
                                   const problems::Structure& structure) {
  auto names = problems::load_cases(structure);
  if (names.empty()) names.emplace_back();
  if (!statement.load_case.empty()) {
    std::erase_if(
        names, [&](const auto& name) { return verify::on_one_line(name) != statement.load_case; });
  }
  return names;
}

// The first load case that the statement refers to, or the reason why there is none.
// @throws InputError if limit analysis applies to none
std::variant<AgreedTruss, std::string> truss_of(const LimitStatement& statement,
                                                const problems::CheckedStructure& structure) {
  std::vector<std::string> whys;
  std::optional<support::InputError> fault;
  for (const auto& name : cases_for(statement, structure)) {
    const auto of_case =
        name.empty() ? structure : problems::checked(problems::in_load_case(structure, name));
    const auto fingerprint = limit_fingerprint(of_case, fault);
    if (!fingerprint) continue;
    if (statement.residual && !problems::has_struts(structure)) return no_struts;
    auto truss = evidence::verified_structure(statement.residual ? problems::after_buckling(of_case)
                                                                 : of_case);
    if (statement.claim == LimitClaim::minimum) {
      truss = verify::with_reversed_reference(std::move(truss));
    }
    auto found = verify::limit_consistency(statement.evidence, truss);
    if (auto* const agreed = std::get_if<verify::LimitTruss>(&found))
      return AgreedTruss{std::move(*agreed), name, *fingerprint, std::move(truss.load_names)};
    const auto& why = std::get<std::string>(found);
    whys.push_back(name.empty() ? why : fmt::format("case {}: {}", support::in_quotes(name), why));
  }
  if (whys.empty()) {
    if (fault) throw support::InputError(*fault);
    return fmt::format("no load case {}", support::in_quotes(statement.load_case));
  }
  return fmt::format("{}", fmt::join(whys, "; "));
}

/// A statement with its proof.
struct Checking {
  const LimitStatement& statement;
  verify::LimitProof proof;
};

// Truss of the certificate, or that of the structure; nothing if they disagree.
std::optional<Checking> checking(const LimitStatement& statement,
                                 const std::optional<problems::CheckedStructure>& structure,
                                 const std::string& file, CheckedStatement& checked) {
  auto truss = verify::recorded_truss(statement.evidence);
  auto names = statement.evidence.names;
  checked.load_case = statement.load_case;
  if (structure) {
    auto found = truss_of(statement, *structure);
    if (const auto* why = std::get_if<std::string>(&found)) {
      checked.refusals.push_back(file + ": " + *why);
      return {};
    }
    auto& agreed = std::get<AgreedTruss>(found);
    truss = std::move(agreed.truss);
    names = std::move(agreed.names);
    checked.load_case = std::move(agreed.load_case);
    checked.fingerprint = agreed.fingerprint;
  }
  for (std::size_t j = 0; j < truss.half_widths.size(); ++j)
    checked.half_widths.emplace_back(names.empty() ? "" : names[j], truss.half_widths[j]);
  return Checking{statement, verify::LimitProof(statement.evidence, std::move(truss))};
}

// Checks everything except the nodes.
void check_load(const Checking& at, CheckedStatement& checked) {
  auto& refusals = checked.refusals;
  if (at.statement.claim == LimitClaim::none) {
    if (!at.proof.shows_no_factor()) {
      refusals.emplace_back("the motion does not show that the load is not carried at any factor");
    }
    return;
  }
  const auto upper = at.proof.upper();
  if (const auto* why = std::get_if<std::string>(&upper)) {
    refusals.push_back("upper bound: " + *why);
  } else {
    checked.upper = verify::rounded_up(std::get<mpq_class>(upper));
    if (std::isinf(checked.upper))
      refusals.emplace_back("the upper bound exceeds the range of double precision");
  }
  if (at.statement.claim == LimitClaim::minimum && at.statement.evidence.nodes.empty()) {
    checked.lower = -infinity;  // so far that of the opposite: only one bound is claimed
    return;
  }
  if (const auto flaw = verify::flaw_of_sign_cover(at.statement.evidence))
    refusals.push_back(*flaw);
  checked.lower = infinity;
}

// Bounds of a least factor are so far those of its opposite.
void conclude(CheckedStatement& checked) {
  checked.lower = std::min(checked.lower, checked.upper);
  if (checked.claim != LimitClaim::minimum) return;
  const double upper = checked.upper;
  checked.upper = -checked.lower;
  checked.lower = -upper;
}

/// A node of a statement.
struct NodePlace {
  std::size_t statement;
  std::size_t node;
};

// Proof of nodes as a tree for the engine.
engine::Status prove_nodes(CommandRun& run, const VerifyOptions& options,
                           const std::vector<std::optional<Checking>>& proofs,
                           std::span<const NodePlace> places, std::vector<CheckedStatement>& all) {
  const auto node_of = [&](const NodePlace& place) -> const verify::LimitNode& {
    return proofs[place.statement]->statement.evidence.nodes[place.node];
  };
  engine::SharedWork<NodeVerdict> work(places.size(), [&](std::uint64_t number) {
    const auto& place = places[number];
    const auto bound = proofs[place.statement]->proof.lower(node_of(place));
    NodeVerdict found;
    if (const auto* value = std::get_if<mpq_class>(&bound)) {
      found.lower = verify::rounded_down(*value);
    } else {
      found.refusal = std::get<std::string>(bound);
    }
    return found;
  });
  // Signals stop it only if it can be resumed.
  engine::AnalysisOptions kept;
  if (!options.checkpoint.state.empty()) kept = run.analysis_options({});
  engine::Analysis analysis(run.session().transport(), std::move(kept));
  const auto outcome = analysis.search(work, {});
  if (outcome.status != engine::Status::solved) return outcome.status;
  const auto verdicts = engine::from_first_rank(run.session().transport(), [&] {
    std::vector<NodeVerdict> found;
    for (const auto& each : outcome.solutions) found.push_back(each.solution);
    return found;
  });
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    auto& checked = all[places[i].statement];
    checked.lower = std::min(checked.lower, verdicts[i].lower);
    if (verdicts[i].refusal.empty()) continue;
    checked.refusals.push_back(
        fmt::format("the node of line {}: {}", node_of(places[i]).line, verdicts[i].refusal));
  }
  return outcome.status;
}

}  // namespace

std::optional<std::uint64_t> limit_fingerprint(const problems::CheckedStructure& structure,
                                               std::optional<support::InputError>& fault) {
  try {
    return problems::limit_problem(structure).fingerprint;
  } catch (const support::InputError& error) {
    fault = error;
    return {};
  }
}

CheckedStatements check_statements(CommandRun& run, const VerifyOptions& options,
                                   const std::optional<problems::CheckedStructure>& structure,
                                   std::span<const LimitStatement> statements) {
  CheckedStatements result;
  auto& all = result.statements;
  std::vector<std::optional<Checking>> proofs;
  std::vector<NodePlace> places;
  for (const auto& statement : statements) {
    auto& checked = all.emplace_back();
    checked.claim = statement.claim;
    checked.residual = statement.residual;
    checked.cuts = statement.evidence.cuts.size();
    checked.nodes = statement.evidence.nodes.size();
    proofs.push_back(checking(statement, structure, options.problem, checked));
    if (!proofs.back()) continue;
    check_load(*proofs.back(), checked);
    if (statement.claim == LimitClaim::none) continue;
    for (std::size_t node = 0; node < checked.nodes; ++node)
      places.push_back({all.size() - 1, node});
  }
  if (!places.empty()) result.status = prove_nodes(run, options, proofs, places, all);
  for (auto& checked : all) {
    if (checked.refusals.empty()) conclude(checked);
  }
  return result;
}

}  // namespace kusabi::run
