// Proofs of verify/wedged, shared among the ranks, and sentences about them.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "engine/analysis/analysis.hpp"
#include "engine/counts.hpp"
#include "engine/expansion.hpp"
#include "engine/index_range.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/session/progress_line.hpp"
#include "run/verify/proof_words.hpp"
#include "run/verify/verify.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/consistency.hpp"
#include "verify/wedged/cover.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::run {
namespace {

/// Problem type of engine::search.
class Verification {
 public:
  using Node = engine::IndexRange;  ///< of records

  /// A record whose claim is refused.
  struct Solution {
    std::uint64_t record = 0;
    std::string reason;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& record& reason;
    }
  };

  /// Numbers of nodes by proved claim.
  struct Tally : engine::Counts<Tally> {
    std::uint64_t infeasible = 0;  ///< with cuts or without
    std::uint64_t feasible = 0;
    std::uint64_t marginal = 0;  ///< without a claim
    /// Infeasible nodes, proved only for displacements up to `displacement_ratio` times the
    /// strains.
    std::uint64_t except_large_displacements = 0;
    /// Undecided nodes with a proof that some candidate in contact stays unloaded.
    std::uint64_t unloaded = 0;

    [[nodiscard]] std::uint64_t open() const { return marginal - unloaded; }

    static constexpr auto fields() {
      return std::tuple{field("dead", &Tally::infeasible), field("alive", &Tally::feasible),
                        field("marginal", &Tally::marginal),
                        field(large_displacements_column, &Tally::except_large_displacements),
                        field("unloaded", &Tally::unloaded)};
    }
  };

  /// Both must outlive this.
  Verification(const verify::Certificate& certificate, const verify::Proof& proof)
      : certificate_(certificate), proof_(proof) {}

  Node root() const { return {0, certificate_.records.size()}; }
  void expand(Node&& node, engine::Expansion<Verification>& out);
  Tally tally() const { return tally_; }

 private:
  const verify::Certificate& certificate_;
  const verify::Proof& proof_;
  Tally tally_;
};

void Verification::expand(Node&& node, engine::Expansion<Verification>& out) {
  constexpr std::uint64_t few = 16;
  if (engine::branch_into_halves(node, few, out)) return;
  for (auto number = node.first; number < node.last; ++number) {
    const auto& record = certificate_.records[number];
    auto proof_result = proof_.proof_result(record);
    if (proof_result.refusal) {
      out.solution({number, std::move(*proof_result.refusal)});
      continue;
    }
    if (proof_result.except_large_displacements) ++tally_.except_large_displacements;
    if (proof_result.unloaded) ++tally_.unloaded;
    switch (record.claim) {
      case verify::Claim::infeasible:
      case verify::Claim::cut:
      case verify::Claim::form:
        ++tally_.infeasible;
        break;
      case verify::Claim::feasible:
        ++tally_.feasible;
        break;
      case verify::Claim::none:
        ++tally_.marginal;
        break;
    }
    out.poll();
  }
}

std::string all_patterns(int candidates) {
  constexpr int easily_read = 20;
  if (candidates > easily_read) return fmt::format("2^{}", candidates);
  return std::to_string(1 << candidates);
}

void write_refusal(std::string& text, const VerifyOptions& options,
                   const verify::Certificate& certificate, const Verification::Solution& refusal) {
  const auto& record = certificate.records[refusal.record];
  fmt::format_to(std::back_inserter(text), "{}:{}: refused: {} contact {} separated {}: {}\n",
                 options.certificate, record.line, verify::claim_name(record.claim),
                 certificate.names_of(record.contact), certificate.names_of(record.separated),
                 refusal.reason);
}

// Adds proved bounds in their order, on each rank: each bound may use those before it, and all
// proofs of nodes use them.
std::vector<std::string> refusals_of_bounds(verify::Proof& proof, const VerifyOptions& options,
                                            const verify::Certificate& certificate) {
  std::vector<std::string> refusals;
  for (const auto& bound : certificate.bounds) {
    const auto why = proof.add_bound(bound);
    if (!why) continue;
    refusals.push_back(
        fmt::format("{}:{}: refused: {} {} {}: {}\n", options.certificate, bound.line,
                    bound.maximum ? fmt::format("bound {:.3g}", *bound.maximum) : "never",
                    certificate.names[static_cast<std::size_t>(bound.candidate)],
                    verify::side_name(bound.side), *why));
  }
  return refusals;
}

// Claims that are proved, and their problem.
void write_subject(std::string& text, const VerifyOptions& options,
                   const verify::Certificate& certificate,
                   const std::optional<problems::CheckedStructure>& structure,
                   const std::optional<verify::ConsistentStructure>& consistent) {
  fmt::format_to(std::back_inserter(text), "contact candidates: {}\n",
                 fmt::join(certificate.names, " "));
  if (!structure) {
    fmt::format_to(std::back_inserter(text),
                   "K and the friction are those of the certificate; with --problem "
                   "FILE the claim is about a structure\n");
    return;
  }
  text +=
      verified_problem(options, *structure) + verified_friction(*structure, consistent->friction);
  fmt::format_to(std::back_inserter(text),
                 "K was recomputed from the structure with errors up to {:.1e}\n",
                 consistent->stiffness.radius.nearest());
}

// Proved claims, in the order of the proof.
void write_summary(std::string& text, const verify::Certificate& certificate,
                   const verify::Proof& proof, bool covered, std::size_t bounds,
                   const Verification::Tally& proved) {
  const auto* const word = answer::standing_word(support::Standing::proved);
  fmt::format_to(std::back_inserter(text),
                 "K is positive definite{}; its eigenvalues are above {:.3g}\n",
                 certificate.motions == 0
                     ? ""
                     : fmt::format(" with grounding springs for {} of unconstrained bodies",
                                   answer::counted(certificate.motions, "rigid-body mode")),
                 proof.min_eigenvalue()->nearest());
  if (covered) {
    for (std::size_t b = 0; b < certificate.blocks.size(); ++b) {
      const auto& block = certificate.blocks[b];
      const auto nodes = std::ranges::count(certificate.records, b, &verify::Record::block);
      fmt::format_to(std::back_inserter(text), "{}{} cover all {} sign patterns{}, each once\n",
                     certificate.blocks.size() > 1 ? fmt::format("block {}: ", b + 1) : "",
                     answer::counted(static_cast<std::uint64_t>(nodes), "node"),
                     all_patterns(block.size()),
                     certificate.blocks.size() > 1 ? " of " + certificate.names_of(block) : "");
    }
  }
  if (!certificate.bounds.empty())
    fmt::format_to(std::back_inserter(text), "bounds: {} {}\n", bounds, word);
  fmt::format_to(std::back_inserter(text),
                 "cannot stick: {} {}{}\n"
                 "sticks: {} {}\n",
                 proved.infeasible, word,
                 large_displacements_text(proved.except_large_displacements), proved.feasible,
                 word);
  if (proved.unloaded > 0)
    fmt::format_to(std::back_inserter(text), "a contact without a reaction: {} {}\n",
                   proved.unloaded, word);
  if (proved.open() > 0)
    fmt::format_to(std::back_inserter(text), "marginal: {} open\n", proved.open());
}

// Signals stop it only if it can be resumed.
engine::Outcome<Verification> verified(CommandRun& run, Verification& verification,
                                       const VerifyOptions& options) {
  engine::Options search_options;
  std::optional<ProgressLine> progress;
  if (run.shows()) {
    progress.emplace(search_options.goal);
    search_options.progress = [&](const auto& state) { progress->show(state); };
  }
  if (options.checkpoint.state.empty())
    return engine::search(verification, run.session().transport(), search_options);
  engine::Analysis analysis(run.session().transport(), run.analysis_options({}));
  return analysis.search(verification, search_options);
}

answer::CertificateCheck::List list_of(const Verification::Tally& proved) {
  return {.patterns = proved.feasible,
          .nodes = proved.infeasible + proved.feasible + proved.unloaded,
          .undecided = proved.open(),
          .except_large_displacements = proved.except_large_displacements,
          .displacement_ratio = verify::largest_displacement_ratio};
}

}  // namespace

VerifyFindings verify_patterns(CommandRun& run, const VerifyOptions& options,
                               const std::optional<problems::CheckedStructure>& structure,
                               const std::string& text) {
  // Every rank reads the certificate and proves the parts that all nodes depend on.
  const auto certificate =
      read_certificate_text([&] { return verify::read_certificate(text, options.certificate); });
  std::optional<verify::ConsistentStructure> consistent;
  if (structure) {
    auto found = verify::consistency(certificate, evidence::verified_structure(*structure));
    if (const auto* why = std::get_if<std::string>(&found))
      return refusal_of_certificate(options, fmt::format("{}: {}", options.problem, *why));
    consistent = std::move(std::get<verify::ConsistentStructure>(found));
  }
  auto proof = consistent ? verify::Proof(certificate, consistent->stiffness, consistent->motions)
                          : verify::Proof(certificate);
  if (!proof.min_eigenvalue())
    return refusal_of_certificate(options, indefinite_stiffness(certificate.motions));

  const auto bounds_refused = refusals_of_bounds(proof, options, certificate);
  Verification verification(certificate, proof);
  const auto outcome = verified(run, verification, options);
  if (outcome.status != engine::Status::solved) return {.status = outcome.status};

  const auto proved = outcome.tally();
  const bool one_pattern = certificate.one_pattern;
  auto flaw = one_pattern ? std::optional<std::string>() : verify::flaw_of_cover(certificate);
  if (one_pattern && proved.feasible == 0) flaw = "the pattern of the certificate is missing";
  VerifyFindings findings{
      .check = {.refusals = outcome.solutions.size() + bounds_refused.size() + (flaw ? 1U : 0U)}};
  if (one_pattern)
    findings.check.claim = answer::CertificateCheck::Example{.patterns = proved.feasible};
  else
    findings.check.claim = list_of(proved);
  if (!run.session().is_first()) return findings;  // refusals are on rank 0
  for (const auto& refusal : bounds_refused) findings.refusals += refusal;
  for (const auto& found : outcome.solutions) {
    write_refusal(findings.refusals, options, certificate, found.solution);
  }
  if (flaw) findings.refusals += fmt::format("{}: refused: {}\n", options.certificate, *flaw);
  write_subject(findings.summary, options, certificate, structure, consistent);
  write_summary(findings.summary, certificate, proof, !flaw && !one_pattern,
                certificate.bounds.size() - bounds_refused.size(), proved);
  return findings;
}

}  // namespace kusabi::run
