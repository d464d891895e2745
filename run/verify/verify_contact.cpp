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
#include "problems/structure/model/load_cases.hpp"
#include "run/session/progress_line.hpp"
#include "run/verify/proof_words.hpp"
#include "run/verify/verify.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/conclusion.hpp"
#include "verify/wedged/consistency.hpp"
#include "verify/wedged/cover.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::run {
namespace {

/// Problem type of engine::search: nodes, then states, in pieces of a few.
class Verification {
 public:
  using Node = engine::IndexRange;

  /// A refused statement: a node, or with the number of nodes added a state.
  struct Solution {
    std::uint64_t statement = 0;
    std::string reason;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& statement& reason;
    }
  };

  /// Numbers of proved statements.
  struct Tally : engine::Counts<Tally> {
    std::uint64_t infeasible = 0;  ///< nodes, with cuts or without
    std::uint64_t states = 0;
    std::uint64_t marginal = 0;  ///< nodes without a claim
    /// Infeasible nodes, proved only for displacements up to `displacement_ratio` times the
    /// strains.
    std::uint64_t except_large_displacements = 0;
    /// Nodes without a claim, with a proof that some candidate in contact stays unloaded.
    std::uint64_t unloaded = 0;

    [[nodiscard]] std::uint64_t open() const { return marginal - unloaded; }

    static constexpr auto fields() {
      return std::tuple{field("infeasible", &Tally::infeasible), field("states", &Tally::states),
                        field("marginal", &Tally::marginal),
                        field("except large displacements", &Tally::except_large_displacements),
                        field("unloaded", &Tally::unloaded)};
    }
  };

  /// Both must outlive this.
  Verification(const verify::Certificate& certificate, const verify::Proof& proof)
      : certificate_(certificate), proof_(proof) {}

  Node root() const { return {0, certificate_.nodes.size() + certificate_.states.size()}; }

  void expand(Node&& node, engine::Expansion<Verification>& out) {
    constexpr std::uint64_t few = 16;
    if (engine::branch_into_halves(node, few, out)) return;
    for (auto number = node.first; number < node.last; ++number) {
      if (auto why = refusal(number)) out.solution({number, std::move(*why)});
      out.poll();
    }
  }

  Tally tally() const { return tally_; }

 private:
  std::optional<std::string> refusal(std::uint64_t number) {
    const auto nodes = certificate_.nodes.size();
    if (number >= nodes) {
      auto why = proof_.refusal(certificate_.states[number - nodes]);
      if (!why) ++tally_.states;
      return why;
    }
    const auto& node = certificate_.nodes[number];
    auto result = proof_.proof_result(node);
    if (result.refusal) return std::move(result.refusal);
    ++(node.claim == verify::Claim::none ? tally_.marginal : tally_.infeasible);
    if (result.except_large_displacements) ++tally_.except_large_displacements;
    if (result.unloaded) ++tally_.unloaded;
    return {};
  }

  const verify::Certificate& certificate_;
  const verify::Proof& proof_;
  Tally tally_;
};

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

std::string refusal_line(const VerifyOptions& options, const verify::Certificate& certificate,
                         const Verification::Solution& refusal) {
  const auto line = [&](const char* keyword, const auto& of) {
    return fmt::format("{}:{}: refused: {} contact {} separated {}: {}\n", options.certificate,
                       of.line, keyword, certificate.names_of(of.contact),
                       certificate.names_of(of.separated), refusal.reason);
  };
  const auto nodes = certificate.nodes.size();
  if (refusal.statement < nodes) {
    const auto& node = certificate.nodes[refusal.statement];
    return line(verify::claim_name(node.claim), node);
  }
  const auto& state = certificate.states[refusal.statement - nodes];
  return line(state.share ? "held" : "wedged", state);
}

/// Lines about refused statements, and the statements that are proved.
struct Findings {
  std::vector<std::string> refusals;
  verify::Proved proved;
};

// Adds proved bounds in their order, on each rank: each bound may use those before it, and all
// proofs of nodes use them.
void prove_bounds(verify::Proof& proof, const VerifyOptions& options,
                  const verify::Certificate& certificate, Findings& findings) {
  for (const auto& bound : certificate.bounds) {
    const auto why = proof.add_bound(bound);
    if (!why) continue;
    findings.refusals.push_back(
        fmt::format("{}:{}: refused: {} {} {}: {}\n", options.certificate, bound.line,
                    bound.maximum ? fmt::format("bound {:.3g}", *bound.maximum) : "never",
                    certificate.names[static_cast<std::size_t>(bound.candidate)],
                    verify::side_name(bound.side), *why));
  }
}

void add_outcome(const engine::Outcome<Verification>& outcome, const VerifyOptions& options,
                 const verify::Certificate& certificate, Findings& findings) {
  findings.proved = {.theorems = std::vector<bool>(certificate.theorems.size(), true),
                     .states = std::vector<bool>(certificate.states.size(), true),
                     .except_large_displacements = outcome.tally().except_large_displacements > 0};
  const auto nodes = certificate.nodes.size();
  for (const auto& each : outcome.solutions) {
    findings.refusals.push_back(refusal_line(options, certificate, each.solution));
    const auto number = each.solution.statement;
    if (number < nodes)
      findings.proved.theorems[certificate.nodes[number].theorem] = false;
    else
      findings.proved.states[number - nodes] = false;
  }
  for (std::size_t t = 0; t < certificate.theorems.size(); ++t) {
    const auto flaw = verify::flaw_of_cover(certificate, t);
    if (!flaw) continue;
    findings.proved.theorems[t] = false;
    findings.refusals.push_back(fmt::format("{}:{}: refused: {}\n", options.certificate,
                                            certificate.theorems[t].line, *flaw));
  }
}

std::string all_patterns(int candidates) {
  constexpr int easily_read = 20;
  if (candidates > easily_read) return fmt::format("2^{}", candidates);
  return std::to_string(1 << candidates);
}

// The problem of the proof.
std::string subject(const VerifyOptions& options, const verify::Certificate& certificate,
                    const std::optional<problems::CheckedStructure>& structure,
                    const verify::ConsistentStructure& problem) {
  auto text = fmt::format("contact candidates: {}\n", fmt::join(certificate.names, " "));
  if (!structure) {
    return text +
           fmt::format(
               "{} and the friction are those of the certificate; with --problem FILE the claim "
               "is about a structure\n",
               certificate.loads ? "K, the loads" : "K");
  }
  text += verified_problem(options, *structure) + verified_friction(*structure, problem.friction);
  if (certificate.loads) {
    const std::vector covered{certificate.loads->load_case};
    text += covered_cases_text(covered) + cases_left_text(covered, *structure);
  }
  return text +
         fmt::format("K was recomputed from the structure{} with errors up to {:.1e}\n",
                     certificate.loads ? ", and the loads from the forces on its nodes," : "",
                     problem.stiffness.radius.nearest());
}

// Proved trees of a list of patterns, one for each block.
std::string covers(const verify::Certificate& certificate) {
  std::string text;
  const bool several = certificate.blocks.size() > 1;
  for (std::size_t t = 0; t < certificate.theorems.size(); ++t) {
    const auto b = certificate.theorems[t].block;
    const auto& block = certificate.blocks[b];
    const auto nodes = std::ranges::count(certificate.nodes, t, &verify::Node::theorem) +
                       std::ranges::count(certificate.states, b, &verify::State::block);
    text +=
        fmt::format("{}{} {} all {} sign patterns{}, each once\n",
                    several ? fmt::format("block {}: ", b + 1) : "", answer::counted(nodes, "node"),
                    nodes == 1 ? "covers" : "cover", all_patterns(block.size()),
                    several ? " of " + certificate.names_of(block) : "");
  }
  return text;
}

// Proved claims, in the order of the proof.
std::string summary(const verify::Certificate& certificate, const verify::Proof& proof,
                    const verify::Conclusion& conclusion, std::size_t bounds,
                    const Verification::Tally& proved) {
  const auto* const word = answer::standing_word(support::Standing::proved);
  auto text =
      fmt::format("K is positive definite{}; its eigenvalues are above {:.3g}\n",
                  certificate.motions == 0
                      ? ""
                      : fmt::format(" with grounding springs for {} of unconstrained bodies",
                                    answer::counted(certificate.motions, "rigid-body mode")),
                  proof.min_eigenvalue()->nearest());
  const auto large = large_displacements_text(proved.except_large_displacements);
  if (!certificate.bounds.empty() && certificate.loads)
    text += fmt::format("bounds: {} {}\n", bounds, word);
  if (certificate.loads) {
    return text + fmt::format("nodes without a state: {} {}, of {}{}\nstates: {} {}\n",
                              proved.infeasible, word,
                              answer::counted(certificate.theorems.size(), "tree"), large,
                              proved.states, word);
  }
  if (conclusion.complete_list) text += covers(certificate);
  if (!certificate.bounds.empty()) text += fmt::format("bounds: {} {}\n", bounds, word);
  text += fmt::format("cannot stick: {} {}{}\nsticks: {} {}\n", proved.infeasible, word, large,
                      proved.states, word);
  if (proved.unloaded > 0)
    text += fmt::format("a contact without a reaction: {} {}\n", proved.unloaded, word);
  if (proved.open() > 0) text += fmt::format("marginal: {} open\n", proved.open());
  return text;
}

answer::CertificateCheck::List list_of(const Verification::Tally& proved) {
  answer::CertificateCheck::List list{.patterns = proved.states,
                                      .nodes = proved.infeasible + proved.states + proved.unloaded,
                                      .undecided = proved.open()};
  if (proved.except_large_displacements > 0)
    list.displacement_ratio = verify::largest_displacement_ratio;
  return list;
}

std::vector<support::Bracket> ranges_of(const std::vector<verify::FactorRange>& ranges) {
  std::vector<support::Bracket> result;
  result.reserve(ranges.size());
  for (const auto& [low, high] : ranges)
    result.push_back(answer::CertificateCheck::proved_between(low, high));
  return result;
}

// True if a load acts on a body with candidates, be it only on motions that displace none of them.
bool acts(const verify::EnclosedLoad& load) {
  return std::ranges::find(load.acts, true) != load.acts.end() || load.work.is_unbalanced();
}

answer::CertificateCheck::Held held_of(const verify::Certificate& certificate,
                                       const verify::ConsistentStructure& problem,
                                       const verify::HoldClaims& claims, bool except_large) {
  answer::CertificateCheck::Held held{.friction = {},
                                      .load_case = certificate.loads->load_case,
                                      .of_reference = acts(problem.loads[1]),
                                      .total = certificate.total,
                                      .held = ranges_of(claims.held),
                                      .none = ranges_of(claims.none)};
  const auto [least, largest] = std::ranges::minmax(certificate.friction);
  if (least == largest) held.friction = largest;
  if (except_large) held.displacement_ratio = verify::largest_displacement_ratio;
  if (!claims.restricts_a_sum) return held;
  const auto proved = answer::CertificateCheck::proved_at;
  held.grip = answer::CertificateCheck::Grip{};
  auto& [sum, sums_of_states] = *held.grip;
  if (claims.grip.below > 0) sum.lower = proved(claims.grip.below);
  if (claims.grip.above) sum.upper = proved(*claims.grip.above);
  if (const auto& states = claims.grip.states)
    sums_of_states = support::Bracket::proved(states->low, states->high);
  return held;
}

// The problem of the certificate itself; friction is the largest of the candidates.
verify::ConsistentStructure recorded_problem(const verify::Certificate& certificate) {
  return {.stiffness = verify::recorded_stiffness(certificate),
          .motions = verify::recorded_motions(certificate.motion_values, certificate.motions),
          .loads = verify::recorded_loads(certificate),
          .friction = std::ranges::max(certificate.friction)};
}

// The problem of the proof: that of the certificate, or the structure in its load case.
std::variant<verify::ConsistentStructure, std::string> problem_of(
    const verify::Certificate& certificate,
    const std::optional<problems::CheckedStructure>& structure, const VerifyOptions& options) {
  if (!structure) return recorded_problem(certificate);
  std::variant<verify::ConsistentStructure, std::string> found;
  if (certificate.loads) {
    const auto& load_case = certificate.loads->load_case;
    const auto loaded = in_case_of_certificate(*structure, load_case);
    if (!loaded) return no_such_case(options, load_case);
    problems::check_certain(*loaded);
    found = verify::consistency(certificate, evidence::verified_under_load(*loaded));
  } else {
    found = verify::consistency(certificate, evidence::verified_structure(*structure));
  }
  if (auto* why = std::get_if<std::string>(&found))
    return fmt::format("{}: {}", options.problem, *why);
  return found;
}

}  // namespace

VerifyFindings verify_contact(CommandRun& run, const VerifyOptions& options,
                              const std::optional<problems::CheckedStructure>& structure,
                              const std::string& text) {
  // Every rank reads the certificate and proves the parts that all nodes depend on.
  const auto certificate =
      read_certificate_text([&] { return verify::read_certificate(text, options.certificate); });
  const auto found = problem_of(certificate, structure, options);
  if (const auto* why = std::get_if<std::string>(&found))
    return refusal_of_certificate(options, *why);
  const auto& problem = std::get<verify::ConsistentStructure>(found);
  verify::Proof proof(certificate, problem.stiffness, problem.motions, problem.loads);
  if (!proof.min_eigenvalue())
    return refusal_of_certificate(options, indefinite_stiffness(certificate.motions));

  Findings findings;
  prove_bounds(proof, options, certificate, findings);
  const auto bounds = certificate.bounds.size() - findings.refusals.size();
  Verification verification(certificate, proof);
  const auto outcome = verified(run, verification, options);
  if (outcome.status != engine::Status::solved) return {.status = outcome.status};
  if (!run.session().is_first()) return {};  // refused statements are on rank 0
  add_outcome(outcome, options, certificate, findings);
  const auto conclusion = verify::conclude(certificate, proof, findings.proved);
  if (conclusion.refusal)
    findings.refusals.push_back(
        fmt::format("{}: refused: {}\n", options.certificate, *conclusion.refusal));
  const auto proved = outcome.tally();
  VerifyFindings result{.check = {.refusals = findings.refusals.size()},
                        .refusals = fmt::format("{}", fmt::join(findings.refusals, ""))};
  if (conclusion.loads)
    result.check.claim = held_of(certificate, problem, *conclusion.loads,
                                 findings.proved.except_large_displacements);
  else if (certificate.theorems.empty())
    result.check.claim = answer::CertificateCheck::Example{.patterns = proved.states};
  else
    result.check.claim = list_of(proved);
  result.summary = subject(options, certificate, structure, problem) +
                   summary(certificate, proof, conclusion, bounds, proved);
  return result;
}

}  // namespace kusabi::run
