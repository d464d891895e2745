// The proofs of verify/limit_proof, shared among the ranks, and what is said of them.
#include "run/verify/verify_limit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <boost/serialization/string.hpp>
#include <fmt/format.h>

#include "engine/campaign.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "problems/limit/limit_problem.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
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

}  // namespace

VerifyFindings verify_limit(CommandRun& run, const VerifyOptions& options,
                            const std::optional<problems::Structure>& structure,
                            const std::string& text) {
  const auto certificate = certificate_in(text, options.certificate);
  auto truss = verify::recorded_truss(certificate);
  std::uint64_t fingerprint = 0;
  if (structure) {
    fingerprint = problems::limit_problem(*structure).fingerprint;  // or an error: it is no truss
    auto found = verify::limit_agreement(certificate, evidence::verified_structure(*structure));
    if (const auto* why = std::get_if<std::string>(&found)) {
      return {.code = failed,
              .refusals =
                  fmt::format("{}: refused: {}: {}\n", options.certificate, options.problem, *why),
              .verdict = "NOT PROVED\n"};
    }
    truss = std::move(std::get<verify::LimitTruss>(found));
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
    if (outcome.status != engine::Status::solved)
      return {.code = stopped_early, .status = outcome.status};
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
  VerifyFindings findings{.code = refusals.empty() ? solved : failed};
  for (const auto& refusal : refusals) {
    findings.refusals += fmt::format("{}: refused: {}\n", options.certificate, refusal);
  }
  auto& summary = findings.summary;
  if (!refusals.empty()) {
    findings.verdict = "NOT PROVED\n";
    return findings;
  }
  const double above = verify::rounded_up(std::get<mpq_class>(upper));
  const auto out = std::back_inserter(summary);
  if (structure) {
    fmt::format_to(out,
                   "problem: {}, from {}, fingerprint {}\n"
                   "direction cosines were computed anew from the truss, yield forces and loads "
                   "compared\n",
                   structure->name, options.problem, hexadecimal(fingerprint));
  } else {
    summary += "the truss is the certificate's own; --problem FILE proves it of a file\n";
  }
  fmt::format_to(out, "{} cuts, {} nodes cover all loads\n", certificate.cuts.size(),
                 certificate.nodes.size());
  findings.verdict =
      fmt::format("PROVED: the least load factor for alpha = {} is between {:.17g} and {:.17g}\n",
                  certificate.alpha, std::min(lower, above), above);
  return findings;
}

}  // namespace kusabi::run
