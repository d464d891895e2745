// The proofs of verify/limit_proof, shared among the ranks, and what is said of them.
#include "run/verify/verify_limit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <boost/serialization/string.hpp>
#include <fmt/format.h>

#include "engine/shared_work.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "problems/limit/limit_problem.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/standard_output.hpp"
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

int verify_limit(Session& session, const VerifyOptions& options,
                 const std::optional<problems::Structure>& structure, const std::string& text) {
  const auto certificate = certificate_in(text, options.certificate);
  auto truss = verify::recorded_truss(certificate);
  std::uint64_t fingerprint = 0;
  if (structure) {
    fingerprint = problems::limit_problem(*structure).fingerprint;  // or an error: it is no truss
    auto found = verify::limit_agreement(certificate, evidence::verified_structure(*structure));
    if (const auto* why = std::get_if<std::string>(&found)) {
      if (session.speaks()) {
        fmt::print("{}: refused: {}: {}\n", options.certificate, options.problem, *why);
        if (!options.quiet) fmt::print("NOT PROVED\n");
        flush_standard_output();
      }
      return failed;
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
    const auto verdicts =
        engine::share_work<NodeVerdict>(session.transport(), certificate.nodes.size(), verdict);
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      lower = std::min(lower, verdicts[i].lower);
      if (!verdicts[i].refusal.empty()) {
        refusals.push_back(
            fmt::format("the node of line {}: {}", certificate.nodes[i].line, verdicts[i].refusal));
      }
    }
  }
  if (!session.speaks()) return refusals.empty() ? solved : failed;
  for (const auto& refusal : refusals)
    fmt::print("{}: refused: {}\n", options.certificate, refusal);
  if (!options.quiet && refusals.empty()) {
    const double above = verify::rounded_up(std::get<mpq_class>(upper));
    if (structure) {
      fmt::print(
          "problem: {}, from {}, fingerprint {:016x}\n"
          "direction cosines were computed anew from the truss, yield forces and loads "
          "compared\n",
          structure->name, options.problem, fingerprint);
    } else {
      fmt::print("the truss is the certificate's own; --problem FILE proves it of a file\n");
    }
    fmt::print("{} cuts, {} nodes cover all loads\n", certificate.cuts.size(),
               certificate.nodes.size());
    fmt::print("PROVED: the least load factor for alpha = {} is between {:.17g} and {:.17g}\n",
               certificate.alpha, std::min(lower, above), above);
  } else if (!options.quiet) {
    fmt::print("NOT PROVED\n");
  }
  flush_standard_output();
  return refusals.empty() ? solved : failed;
}

}  // namespace kusabi::run
