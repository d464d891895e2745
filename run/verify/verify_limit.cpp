// Sentences about statements of limit loads.
#include "run/verify/verify_limit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "run/output/values.hpp"
#include "run/verify/limit_statements.hpp"
#include "run/verify/proof_words.hpp"
#include "support/input_error.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::run {
namespace {

using verify::LimitClaim;

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

// Infinite: none is proved.
std::optional<support::Bound> bound(double proved) {
  if (std::isinf(proved)) return {};
  return support::Bound{proved, support::Standing::proved};
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
  factor.largest = {bound(all.largest_lower), bound(all.largest_upper)};
  if (all.of_least || all.min_lower > all.largest_upper)
    factor.minimum = {bound(all.min_lower), bound(all.min_upper)};
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
  factor.largest.lower = of_all ? bound(carried.largest_lower) : std::nullopt;
  factor.minimum.upper = of_all && carried.of_least ? bound(carried.min_upper) : std::nullopt;
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
  for (const auto& each : statements) covered.push_back(verify::on_one_line(each.load_case));
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
