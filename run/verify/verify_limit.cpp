// The proofs of verify/limit_proof, shared among the ranks, and what is said of them.
#include "run/verify/verify_limit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <boost/serialization/string.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/campaign.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/load_cases.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "support/input_error.hpp"
#include "verify/limit_agreement.hpp"
#include "verify/limit_certificate.hpp"
#include "verify/limit_proof.hpp"

namespace kusabi::run {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// What became of the claim of one node.
struct NodeVerdict {
  double lower = -infinity;  // rounded down
  std::string refusal;       // empty: proved

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& lower& refusal;
  }
};

verify::LimitCertificate certificate_in(const std::string& text, const std::string& file) {
  try {
    return verify::read_limit_certificate(text, file);
  } catch (const verify::CertificateError& error) {
    throw WrongInput(error.what());
  }
}

/// What a certificate is proved of.
struct AgreedTruss {
  verify::LimitTruss truss;
  std::uint64_t fingerprint = 0;
  std::string load_case;  // empty: the file has none
};

// The first load case that the certificate speaks of; or why there is none.
// @throws InputError if it is no truss
std::variant<AgreedTruss, std::string> truss_of(const verify::LimitCertificate& certificate,
                                                const problems::Structure& structure) {
  auto names = problems::load_cases(structure);
  if (names.empty()) names.emplace_back();
  std::vector<std::string> whys;
  for (const auto& name : names) {
    const auto of_case = name.empty() ? structure : problems::in_load_case(structure, name);
    const auto fingerprint = problems::limit_problem(of_case).fingerprint;
    auto found = verify::limit_agreement(certificate, evidence::verified_structure(of_case));
    if (auto* const truss = std::get_if<verify::LimitTruss>(&found))
      return AgreedTruss{std::move(*truss), fingerprint, name};
    const auto& why = std::get<std::string>(found);
    whys.push_back(name.empty() ? why : fmt::format("case {}: {}", support::in_quotes(name), why));
  }
  return fmt::format("{}", fmt::join(whys, "; "));
}

// Zeros if there are no columns.
std::pair<double, double> ends_of(const std::vector<double>& alpha) {
  if (alpha.empty()) return {};
  const auto [least, most] = std::ranges::minmax(alpha);
  return {least, most};
}

// "2 uncertain loads within +- 5, 1 within +- 30"
std::string half_widths_text(const std::vector<double>& alpha) {
  std::map<double, std::size_t> loads;
  for (const double half_width : alpha) ++loads[half_width];
  std::vector<std::string> parts;
  parts.reserve(loads.size());
  for (const auto& [half_width, count] : loads)
    parts.push_back(fmt::format("{} within +- {}", count, half_width));
  return fmt::format("uncertain loads: {}\n", fmt::join(parts, ", "));
}

}  // namespace

VerifyFindings verify_limit(CommandRun& run, const VerifyOptions& options,
                            const std::optional<problems::Structure>& structure,
                            const std::string& text) {
  const auto certificate = certificate_in(text, options.certificate);
  auto truss = verify::recorded_truss(certificate);
  std::uint64_t fingerprint = 0;
  std::string load_case;
  if (structure) {
    auto found = truss_of(certificate, *structure);
    if (const auto* why = std::get_if<std::string>(&found)) {
      return {.check = {.refusals = 1},
              .refusals =
                  fmt::format("{}: refused: {}: {}\n", options.certificate, options.problem, *why)};
    }
    auto& agreed = std::get<AgreedTruss>(found);
    truss = std::move(agreed.truss);
    fingerprint = agreed.fingerprint;
    if (!agreed.load_case.empty())
      load_case = "load case " + support::in_quotes(agreed.load_case) + "\n";
  }
  const verify::LimitProof proof(certificate, std::move(truss));
  std::vector<std::string> refusals;
  const auto upper = proof.upper();
  if (const auto* why = std::get_if<std::string>(&upper)) {
    refusals.push_back("the upper end: " + *why);
  } else if (std::isinf(verify::rounded_up(std::get<mpq_class>(upper)))) {
    refusals.emplace_back("the upper end: it is beyond any number in double precision");
  }
  if (const auto flaw = verify::flaw_of_sign_cover(certificate)) refusals.push_back(*flaw);
  double lower = infinity;
  if (!certificate.nodes.empty()) {
    const auto verdict = [&](std::uint64_t number) {
      const auto bound = proof.lower(certificate.nodes[number]);
      NodeVerdict found;
      if (const auto* value = std::get_if<mpq_class>(&bound)) {
        found.lower = verify::rounded_down(*value);
      } else {
        found.refusal = std::get<std::string>(bound);
      }
      return found;
    };
    engine::SharedWork<NodeVerdict> work(certificate.nodes.size(), verdict);
    // Stopped by signals only if it can be gone on with.
    engine::Supervision kept;
    if (!options.checkpoint.state.empty()) kept = run.supervision({});
    engine::Campaign campaign(run.session().transport(), std::move(kept));
    const auto outcome = campaign.search(work, {});
    if (outcome.status != engine::Status::solved) return {.status = outcome.status};
    const auto verdicts = engine::from_first_rank(run.session().transport(), [&] {
      std::vector<NodeVerdict> found;
      for (const auto& each : outcome.solutions) found.push_back(each.solution);
      return found;
    });
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      lower = std::min(lower, verdicts[i].lower);
      if (!verdicts[i].refusal.empty()) {
        refusals.push_back(
            fmt::format("the node of line {}: {}", certificate.nodes[i].line, verdicts[i].refusal));
      }
    }
  }
  VerifyFindings findings{.check = {.refusals = refusals.size()}};
  for (const auto& refusal : refusals) {
    findings.refusals += fmt::format("{}: refused: {}\n", options.certificate, refusal);
  }
  auto& summary = findings.summary;
  if (!refusals.empty()) return findings;
  const double above = verify::rounded_up(std::get<mpq_class>(upper));
  const auto out = std::back_inserter(summary);
  if (structure) {
    fmt::format_to(out,
                   "problem: {}, from {}, fingerprint {}\n"
                   "direction cosines were computed anew from the truss, yield forces and loads "
                   "compared\n",
                   structure->name, options.problem, hexadecimal(fingerprint));
    summary += load_case;
  } else {
    summary += "the truss is the certificate's own; --problem FILE proves it of a file\n";
  }
  fmt::format_to(out, "{} cuts, {} nodes cover all loads\n", certificate.cuts.size(),
                 certificate.nodes.size());
  const auto [least, most] = ends_of(certificate.alpha);
  if (least != most) summary += half_widths_text(certificate.alpha);
  CertificateCheck::Factor factor{.loads = {}, .lower = std::min(lower, above), .upper = above};
  if (least == most) factor.loads.half_width = most;
  findings.check.claim = factor;
  return findings;
}

}  // namespace kusabi::run
