// Proofs of verify/wedged/hold_proof, shared among the ranks, and what follows from them.
#include <algorithm>
#include <cstdint>
#include <tuple>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "engine/counts.hpp"
#include "engine/index_range.hpp"
#include "engine/search.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/output/wrong_input.hpp"
#include "run/verify/proof_words.hpp"
#include "run/verify/verify.hpp"
#include "verify/wedged/consistency.hpp"
#include "verify/wedged/hold_certificate.hpp"
#include "verify/wedged/hold_proof.hpp"

namespace kusabi::run {
namespace {

/// Problem type of engine::search: nodes, then states, in pieces of a few.
class HoldVerification {
 public:
  using Node = engine::IndexRange;

  /// A refused claim: a node, or with the number of nodes added a state.
  struct Solution {
    std::uint64_t claim = 0;
    std::string reason;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& claim& reason;
    }
  };

  struct Tally : engine::Counts<Tally> {
    std::uint64_t proved = 0;
    std::uint64_t except_large_displacements = 0;

    static constexpr auto fields() {
      return std::tuple{field("proved", &Tally::proved),
                        field(large_displacements_column, &Tally::except_large_displacements)};
    }
  };

  HoldVerification(const verify::HoldCertificate& certificate, const verify::HoldProof& proof)
      : certificate_(certificate), proof_(proof) {}

  Node root() const { return {0, certificate_.nodes.size() + certificate_.states.size()}; }

  void expand(Node&& node, engine::Expansion<HoldVerification>& out) {
    constexpr std::uint64_t few = 16;
    if (engine::branch_into_halves(node, few, out)) return;
    const auto nodes = certificate_.nodes.size();
    for (auto number = node.first; number < node.last; ++number) {
      auto proof_result =
          number < nodes
              ? proof_.proof_result(certificate_.nodes[number])
              : verify::ProofResult{.refusal = proof_.refusal(certificate_.states[number - nodes])};
      if (proof_result.refusal) {
        out.solution({number, std::move(*proof_result.refusal)});
      } else {
        ++tally_.proved;
        if (proof_result.except_large_displacements) ++tally_.except_large_displacements;
      }
      out.poll();
    }
  }

  Tally tally() const { return tally_; }

 private:
  const verify::HoldCertificate& certificate_;
  const verify::HoldProof& proof_;
  Tally tally_;
};

std::string refusal_line(const VerifyOptions& options, const verify::HoldCertificate& certificate,
                         const HoldVerification::Solution& refusal) {
  const auto nodes = certificate.nodes.size();
  const auto& header = certificate.header;
  const auto line = [&](std::size_t number, const char* kind, const auto& of) {
    return fmt::format("{}:{}: refused: {} contact {} separated {}: {}\n", options.certificate,
                       number, kind, header.names_of(of.contact), header.names_of(of.separated),
                       refusal.reason);
  };
  if (refusal.claim < nodes) {
    const auto& record = certificate.nodes[refusal.claim].record;
    return line(record.line, "dead", record);
  }
  const auto& state = certificate.states[refusal.claim - nodes];
  return line(state.line, state.share ? "alive" : "wedged", state);
}

std::vector<answer::CertificateCheck::Range> ranges_of(
    const std::vector<verify::FactorRange>& ranges) {
  std::vector<answer::CertificateCheck::Range> result;
  result.reserve(ranges.size());
  for (const auto& [low, high] : ranges) result.push_back({low, high});
  return result;
}

answer::CertificateCheck::Held held_of(const verify::HoldClaims& claims, double friction,
                                       bool reference) {
  answer::CertificateCheck::Held held{.friction = friction,
                                      .of_reference = reference,
                                      .total = claims.total,
                                      .held = ranges_of(claims.held),
                                      .none = ranges_of(claims.none)};
  if (!claims.grip) return held;
  held.grip = {claims.grip->below, claims.grip->above, {}};
  if (const auto& states = claims.grip->states)
    held.grip->states = answer::CertificateCheck::Range{states->low, states->high};
  return held;
}

/// Trees and states whose claims are proved.
struct ProvedParts {
  std::vector<bool> trees, states;
};

// Adds the refused claims to the findings.
ProvedParts proved_parts(const engine::Outcome<HoldVerification>& outcome,
                         const verify::HoldCertificate& certificate, const verify::HoldProof& proof,
                         const VerifyOptions& options, VerifyFindings& findings) {
  ProvedParts proved{.trees = std::vector<bool>(certificate.trees.size(), true),
                     .states = std::vector<bool>(certificate.states.size(), true)};
  const auto nodes = certificate.nodes.size();
  for (const auto& each : outcome.solutions) {
    findings.refusals += refusal_line(options, certificate, each.solution);
    const auto claim = each.solution.claim;
    if (claim < nodes)
      proved.trees[certificate.nodes[claim].tree] = false;
    else
      proved.states[claim - nodes] = false;
  }
  findings.check.refusals = outcome.solutions.size();
  for (std::size_t t = 0; t < proved.trees.size(); ++t) {
    const auto flaw = proof.flaw(t);
    if (!flaw) continue;
    proved.trees[t] = false;
    ++findings.check.refusals;
    findings.refusals += fmt::format("{}:{}: refused: tree: {}\n", options.certificate,
                                     certificate.trees[t].line, *flaw);
  }
  return proved;
}

std::string summary_of(const VerifyOptions& options, const problems::CheckedStructure& structure,
                       const verify::HoldCertificate& certificate,
                       const verify::ConsistentLoads& consistent,
                       std::uint64_t except_large_displacements) {
  const auto& [enclosure, friction] = consistent;
  return fmt::format(
      "contact candidates: {}\n{}{}{}{}"
      "K was recomputed from the structure, and the loads from the forces on its nodes, with "
      "errors "
      "up to {:.1e}\n"
      "nodes without a state: {} of {}{}\nstates: {}\n",
      fmt::join(certificate.header.names, " "), verified_problem(options, structure),
      verified_friction(structure, friction), covered_cases_text({certificate.load_case}),
      cases_left_text({certificate.load_case}, structure),
      enclosure.problem.stiffness.radius.nearest(), certificate.nodes.size(),
      answer::counted(certificate.trees.size(), "tree"),
      large_displacements_text(except_large_displacements), certificate.states.size());
}

}  // namespace

VerifyFindings verify_hold(CommandRun& run, const VerifyOptions& options,
                           const std::optional<problems::CheckedStructure>& structure,
                           const std::string& text) {
  if (!structure) {
    throw WrongInput(
        fmt::format("{}: a certificate of loads is about a problem file; expected --problem FILE",
                    options.certificate));
  }
  const auto certificate = read_certificate_text(
      [&] { return verify::read_hold_certificate(text, options.certificate); });
  const auto loaded = in_case_of_certificate(*structure, certificate.load_case);
  if (!loaded) return refusal_of_certificate(options, no_such_case(options, certificate.load_case));
  problems::check_certain(*loaded);
  const auto verified = evidence::verified_under_load(*loaded);
  auto found = verify::consistency_under_load(certificate.header, verified);
  if (const auto* why = std::get_if<std::string>(&found))
    return refusal_of_certificate(options, fmt::format("{}: {}", options.problem, *why));
  const auto& consistent = std::get<verify::ConsistentLoads>(found);
  const auto& [enclosure, friction] = consistent;
  std::vector<double> clearances;
  for (const auto& point : verified.contact) clearances.push_back(point.clearance);
  const verify::HoldProof proof(certificate, enclosure, clearances);
  if (!proof.min_eigenvalue())
    return refusal_of_certificate(options, indefinite_stiffness(certificate.header.motions));

  HoldVerification verification(certificate, proof);
  const auto outcome = engine::search(verification, run.session().transport(), engine::Options{});
  if (outcome.status != engine::Status::solved) return {.status = outcome.status};
  VerifyFindings findings;
  if (!run.session().is_first()) {  // refusals are on rank 0
    findings.check.refusals = outcome.solutions.size();
    return findings;
  }
  const auto [trees, states] = proved_parts(outcome, certificate, proof, options, findings);
  const auto except_large_displacements = outcome.tally().except_large_displacements;
  const bool reference =
      std::ranges::any_of(enclosure.loads[1].acts, [](bool acts) { return acts; });
  auto held = held_of(proof.claims(trees, states), friction, reference);
  held.load_case = certificate.load_case;
  held.except_large_displacements = except_large_displacements > 0;
  held.displacement_ratio = verify::largest_displacement_ratio;
  findings.check.claim = std::move(held);
  findings.summary =
      summary_of(options, *structure, certificate, consistent, except_large_displacements);
  return findings;
}

}  // namespace kusabi::run
