// Statements on limit loads: which ones a certificate has, their proofs, shared among the ranks, and
// sentences about them.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <boost/serialization/string.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "engine/analysis/analysis.hpp"
#include "engine/outcome.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "run/command/command_run.hpp"
#include "run/output/values.hpp"
#include "run/verify/proof_words.hpp"
#include "run/verify/verify.hpp"
#include "support/input_error.hpp"
#include "support/one_line.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_consistency.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/sign_cover.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::run {
namespace {

/// Result for a statement.
struct CheckedStatement {
  verify::LimitClaim claim = verify::LimitClaim::largest;
  bool residual = false;          ///< with all struts at their residual strength
  std::string load_case{};        ///< of the problem file, or of the certificate
  std::uint64_t fingerprint = 0;  ///< of the problem file, if there is one
  HalfWidths half_widths{};
  double lower = 0, upper = 0;  ///< bounds of the load factor in the claim, rounded outwards
  std::size_t cuts = 0, nodes = 0;
  std::vector<std::string> refusals{};  ///< empty: it is proved
};

struct CheckedStatements {
  std::vector<CheckedStatement> statements;
  engine::Status status = engine::Status::solved;  ///< not solved: some were not checked
};

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
        names, [&](const auto& name) { return support::on_one_line(name) != statement.load_case; });
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

// Proves all statements on all ranks, in pieces of one node.
// @param structure of the problem file to prove them for, if any
// @throws support::InputError if limit analysis does not apply to the structure
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

// "34 cuts, 1 node covers all loads"
std::string covering_text(const CheckedStatement& statement) {
  return fmt::format("{}, {} {} all loads\n", answer::counted(statement.cuts, "cut"),
                     answer::counted(statement.nodes, "node"),
                     statement.nodes == 1 ? "covers" : "cover");
}

std::string summary_of(const CheckedStatement& statement) {
  switch (statement.claim) {
    case LimitClaim::largest:
      return covering_text(statement);
    case LimitClaim::minimum:
      if (statement.nodes == 0) return "least factors: a bound from below\n";
      return "least factors: " + covering_text(statement);
    case LimitClaim::none:
      break;
  }
  return {};
}

std::optional<double> half_width_of(const std::vector<CheckedStatement>& statements) {
  std::vector<HalfWidths> all;
  all.reserve(statements.size());
  for (const auto& each : statements) all.push_back(each.half_widths);
  return half_width_of_all(all);
}

// Names of the cases, and once for each case its half-widths, if those of all are not one number.
std::string summary_of(const std::vector<CheckedStatement>& statements) {
  std::string text;
  const bool one_number = half_width_of(statements).has_value();
  const CheckedStatement* before = nullptr;
  for (const auto& statement : statements) {
    const bool other_case = before == nullptr || before->load_case != statement.load_case;
    if (other_case && !statement.load_case.empty())
      text += "load case " + support::in_quotes(statement.load_case) + "\n";
    if (!one_number && (other_case || before->half_widths != statement.half_widths))
      text += half_widths_text(statement.half_widths);
    text += summary_of(statement);
    before = &statement;
  }
  return text;
}

/// Bounds of both ends of the factors carried in all cases under every load.
struct ProvedFactors {
  double min_lower = -std::numeric_limits<double>::infinity(), min_upper = min_lower;
  double largest_lower = std::numeric_limits<double>::infinity(), largest_upper = largest_lower;
  bool at_none = false;
  bool of_least = true;  // some bound of the least factors is known
};

ProvedFactors factors_of(const std::vector<CheckedStatement>& statements) {
  ProvedFactors all;
  using Loads = std::pair<std::string, HalfWidths>;
  std::set<Loads> largest;
  std::set<Loads> minimum;
  for (const auto& each : statements) {
    if (each.claim == LimitClaim::none) all.at_none = true;
    if (each.claim == LimitClaim::largest) {
      largest.emplace(each.load_case, each.half_widths);
      all.largest_lower = std::min(all.largest_lower, each.lower);
      all.largest_upper = std::min(all.largest_upper, each.upper);
    }
    if (each.claim == LimitClaim::minimum) {
      minimum.emplace(each.load_case, each.half_widths);
      all.min_lower = std::max(all.min_lower, each.lower);
      all.min_upper = std::max(all.min_upper, each.upper);
    }
  }
  all.of_least = minimum == largest;
  return all;
}

// Sentence about all cases together.
answer::CertificateCheck::Factor factor_of(const std::vector<CheckedStatement>& statements) {
  const auto all = factors_of(statements);
  std::set<std::string> cases;
  for (const auto& each : statements) cases.insert(each.load_case);
  answer::CertificateCheck::Factor factor{.loads = {.half_width = half_width_of(statements)},
                                          .cases = cases.size(),
                                          .at_none = all.at_none};
  if (all.at_none) return factor;
  using Check = answer::CertificateCheck;
  factor.largest = Check::proved_between(all.largest_lower, all.largest_upper);
  if (all.of_least || all.min_lower > all.largest_upper)
    factor.minimum = Check::proved_between(all.min_lower, all.min_upper);
  return factor;
}

// A claim at residual strength about the same loads as one at full strength.
bool is_counterpart(const CheckedStatement& one, const CheckedStatement& other) {
  return one.claim == other.claim && one.load_case == other.load_case &&
         one.half_widths == other.half_widths;
}

// Bounds of the factors that are carried while no strut falls below its residual strength: those
// carried at residual strength are, and those beyond the bounds at full strength are not.
answer::CertificateCheck::Factor factor_of_struts(
    const std::vector<CheckedStatement>& at_strength,
    const std::vector<CheckedStatement>& after_buckling) {
  auto factor = factor_of(at_strength);
  factor.struts = true;
  const bool of_all = std::ranges::all_of(at_strength, [&](const auto& full) {
    return full.claim != LimitClaim::largest ||
           std::ranges::any_of(after_buckling,
                               [&](const auto& each) { return is_counterpart(each, full); });
  });
  const auto carried = factors_of(after_buckling);
  const auto known = answer::CertificateCheck::proved_at;
  factor.largest.lower = of_all ? known(carried.largest_lower) : std::nullopt;
  factor.minimum.upper = of_all && carried.of_least ? known(carried.min_upper) : std::nullopt;
  return factor;
}

// Load cases of the claims at residual strength; empty: the same as those at strength.
std::string cases_at_residual_text(std::span<const CheckedStatement> at_strength,
                                   std::span<const CheckedStatement> after_buckling) {
  const auto cases_of = [](std::span<const CheckedStatement> statements) {
    std::set<std::string> cases;
    for (const auto& each : statements) cases.insert(support::in_quotes(each.load_case));
    return cases;
  };
  const auto cases = cases_of(after_buckling);
  if (cases == cases_of(at_strength)) return {};
  return fmt::format("the claims at residual strength are for load case{} {} only\n",
                     cases.size() == 1 ? "" : "s", fmt::join(cases, ", "));
}

std::vector<std::string> covered_cases(const std::vector<CheckedStatement>& statements) {
  std::vector<std::string> covered;
  covered.reserve(statements.size());
  for (const auto& each : statements) covered.push_back(support::on_one_line(each.load_case));
  return covered;
}

}  // namespace

VerifyFindings verify_limit(CommandRun& run, const VerifyOptions& options,
                            const std::optional<problems::CheckedStructure>& structure,
                            const std::string& text) {
  const auto recorded = read_certificate_text(
      [&] { return verify::read_limit_certificate(text, options.certificate); });
  auto [statements, status] = check_statements(run, options, structure, recorded);
  if (status != engine::Status::solved) return {.status = status};
  VerifyFindings findings;
  for (const auto& statement : statements) {
    findings.check.refusals += statement.refusals.size();
    for (const auto& refusal : statement.refusals)
      findings.refusals += fmt::format("{}: refused: {}\n", options.certificate, refusal);
  }
  if (findings.check.refusals > 0) return findings;
  auto& summary = findings.summary;
  if (structure) {
    fmt::format_to(
        std::back_inserter(summary),
        "problem: {}, from {}, fingerprint {}\n"
        "direction cosines were recomputed from the truss; yield forces and loads were compared\n",
        (*structure)->name, options.problem, hexadecimal(statements.front().fingerprint));
  } else {
    summary += truss_of_certificate;
  }
  summary += summary_of(statements);
  if (structure) summary += cases_left_text(covered_cases(statements), **structure);
  const auto is_at_strength = [](const CheckedStatement& each) { return !each.residual; };
  const auto split = std::stable_partition(statements.begin(), statements.end(), is_at_strength);
  const std::vector<CheckedStatement> after_buckling(split, statements.end());
  statements.erase(split, statements.end());
  if (!after_buckling.empty()) {
    summary += cases_at_residual_text(statements, after_buckling);
    summary += fmt::format(
        "all struts at their strength, an upper value: {}\nall struts at {}, {}\n",
        answer::factor_claim(factor_of(statements)), residual_strength(structure.has_value()),
        answer::proved(answer::factor_claim(factor_of(after_buckling))));
  }
  const bool struts = !after_buckling.empty() || (structure && problems::has_struts(*structure));
  findings.check.claim =
      struts ? factor_of_struts(statements, after_buckling) : factor_of(statements);
  return findings;
}

}  // namespace kusabi::run
