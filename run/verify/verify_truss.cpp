// Theorems on trusses: their proofs, shared among the ranks, and the sentences that follow.
#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

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
#include "verify/limit/truss_certificate.hpp"
#include "verify/limit/truss_consistency.hpp"
#include "verify/limit/truss_proof.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::run {
namespace {

using verify::LimitClaim;
using verify::TrussTheorem;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Name, or nothing, and half-width of each uncertain load.
using HalfWidths = std::vector<std::pair<std::string, double>>;

/// A theorem, of the truss of the certificate or of the problem file, and its proof.
struct Checked {
  TrussTheorem theorem;
  std::uint64_t fingerprint = 0;  ///< of the problem file, if there is one
  bool as_given = false;          ///< the file has uncertain loads, the theorem has none
  HalfWidths half_widths{};
  double lower = infinity, upper = infinity;  ///< of the load factor, rounded outwards
  std::vector<std::string> refusals{};        ///< empty: it is proved
};

using Theorems = std::vector<Checked>;

// Result for one piece of a proof.
struct PieceVerdict {
  double lower = -infinity;  // rounded down
  std::string refusal;       // empty: proved

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& lower& refusal;
  }
};

// The fingerprint of a problem; nothing, and the reason in `fault`, if limit analysis does not apply
// to it, as to a load case without a reference load.
std::optional<std::uint64_t> limit_fingerprint(const problems::CheckedStructure& structure,
                                               std::optional<support::InputError>& fault) {
  try {
    return problems::limit_problem(structure).fingerprint;
  } catch (const support::InputError& error) {
    fault = error;
    return {};
  }
}

// The load cases that a theorem may refer to. One without a load case is that of `limit --case`.
std::vector<std::string> cases_for(const TrussTheorem& theorem,
                                   const problems::Structure& structure) {
  auto names = problems::load_cases(structure);
  if (names.empty()) names.emplace_back();
  if (!theorem.load_case.empty()) {
    std::erase_if(
        names, [&](const auto& name) { return support::on_one_line(name) != theorem.load_case; });
  }
  return names;
}

// Compares the truss with that of the file, in the first load case that agrees, whose name the
// theorem receives with those of the nodes. @return the reason if there is none
// @throws InputError if limit analysis applies to none
std::optional<std::string> difference(const problems::CheckedStructure& structure,
                                      Checked& checked) {
  auto& theorem = checked.theorem;
  std::vector<std::string> whys;
  std::optional<support::InputError> fault;
  for (const auto& name : cases_for(theorem, structure)) {
    const auto of_case =
        name.empty() ? structure : problems::checked(problems::in_load_case(structure, name));
    const auto fingerprint = limit_fingerprint(of_case, fault);
    if (!fingerprint) continue;
    if (theorem.residual && !problems::has_struts(structure)) {
      return "the claim is for residual strength, but no member of the problem file has "
             "`residual`; "
             "expected the file that was analysed";
    }
    auto file = evidence::verified_structure(of_case);
    if (const auto why = verify::truss_difference(theorem, file)) {
      whys.push_back(name.empty() ? *why
                                  : fmt::format("case {}: {}", support::in_quotes(name), *why));
      continue;
    }
    checked.as_given =
        theorem.truss.uncertain->empty() && file.uncertain && !file.uncertain->empty();
    theorem.load_case = name;
    theorem.truss.names = std::move(file.names);
    checked.fingerprint = *fingerprint;
    return {};
  }
  if (!whys.empty()) return fmt::format("{}", fmt::join(whys, "; "));
  if (fault) throw support::InputError(*fault);
  return fmt::format("no load case {}", support::in_quotes(theorem.load_case));
}

/// A piece of a proof.
struct Piece {
  std::size_t theorem;
  std::size_t number;
};

// Proves the pieces of all theorems as a tree for the engine.
engine::Status prove_pieces(CommandRun& run, const VerifyOptions& options,
                            const std::vector<std::unique_ptr<verify::TrussProof>>& proofs,
                            std::span<const Piece> pieces, Theorems& all) {
  engine::SharedWork<PieceVerdict> work(pieces.size(), [&](std::uint64_t number) {
    const auto& piece = pieces[number];
    const auto bound = proofs[piece.theorem]->lower(piece.number);
    PieceVerdict found;
    if (const auto* const value = std::get_if<double>(&bound)) {
      found.lower = *value;
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
    std::vector<PieceVerdict> found;
    for (const auto& each : outcome.solutions) found.push_back(each.solution);
    return found;
  });
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    auto& checked = all[pieces[i].theorem];
    checked.lower = std::min(checked.lower, verdicts[i].lower);
    if (!verdicts[i].refusal.empty()) checked.refusals.push_back(verdicts[i].refusal);
  }
  return outcome.status;
}

// Bounds of a least factor are so far those of its opposite.
void conclude(std::size_t pieces, Checked& checked) {
  checked.lower = pieces == 0 ? -infinity : std::min(checked.lower, checked.upper);
  if (checked.theorem.claim != LimitClaim::minimum) return;
  checked.lower = -std::exchange(checked.upper, -checked.lower);
}

// Proves all theorems on all ranks.
// @param structure of the problem file to prove them for, if any
// @throws support::InputError if limit analysis does not apply to the structure
engine::Status prove(CommandRun& run, const VerifyOptions& options,
                     const std::optional<problems::CheckedStructure>& structure, Theorems& all) {
  std::vector<std::unique_ptr<verify::TrussProof>> proofs;
  std::vector<Piece> pieces;
  for (auto& checked : all) {
    proofs.emplace_back();
    if (structure) {
      if (const auto why = difference(*structure, checked)) {
        checked.refusals.push_back(options.problem + ": " + *why);
        continue;
      }
    }
    const auto& truss = checked.theorem.truss;
    for (std::size_t j = 0; j < truss.half_widths.size(); ++j)
      checked.half_widths.emplace_back(truss.load_names[j], *truss.half_widths[j]);
    proofs.back() = std::make_unique<verify::TrussProof>(checked.theorem);
    checked.refusals = proofs.back()->refusals(checked.upper);
    for (std::size_t piece = 0; piece < proofs.back()->pieces(); ++piece)
      pieces.push_back({proofs.size() - 1, piece});
  }
  const auto status =
      pieces.empty() ? engine::Status::solved : prove_pieces(run, options, proofs, pieces, all);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].refusals.empty()) conclude(proofs[k]->pieces(), all[k]);
  }
  return status;
}

// "34 cuts, 1 node covers all loads"; empty: only an upper bound is claimed.
std::string covering_text(const TrussTheorem& theorem) {
  const auto all_of = [](std::size_t count, const char* piece, const char* what) {
    return fmt::format("{} {} all {}\n", answer::counted(count, piece),
                       count == 1 ? "covers" : "cover", what);
  };
  if (!theorem.states.empty())
    return all_of(theorem.states.size(), "carrying stress state", "losses");
  if (theorem.claim == LimitClaim::none || theorem.losses > 0) return {};
  const std::string least = theorem.claim == LimitClaim::minimum ? "least factors: " : "";
  if (theorem.nodes.empty()) return least + "a bound from below\n";
  return least + answer::counted(theorem.cuts.size(), "cut") + ", " +
         all_of(theorem.nodes.size(), "node", "loads");
}

// Half-width of all uncertain loads, 0 if there are none; nothing if they differ.
std::optional<double> half_width_of(const Theorems& theorems) {
  std::set<double> all;
  for (const auto& each : theorems) {
    if (each.half_widths.empty()) all.insert(0);
    for (const auto& [name, half_width] : each.half_widths) all.insert(half_width);
  }
  return all.size() == 1 ? std::optional(*all.begin()) : std::nullopt;
}

// Line "uncertain loads: wind within +- 5, snow within +- 1, 2 unnamed within +- 30"
std::string half_widths_text(const HalfWidths& all) {
  if (all.empty()) return "uncertain loads: none\n";
  std::map<std::tuple<bool, std::string, double>, std::size_t> loads;  // unnamed ones last
  for (const auto& [name, half_width] : all) ++loads[{name.empty(), name, half_width}];
  std::vector<std::string> parts;
  for (const auto& [load, count] : loads) {
    const auto& [unnamed, name, half_width] = load;
    const auto what = unnamed      ? fmt::format("{} unnamed", count)
                      : count == 1 ? support::in_quotes(name)
                                   : fmt::format("{} ({} loads)", support::in_quotes(name), count);
    parts.push_back(fmt::format("{} within +- {}", what, half_width));
  }
  return fmt::format("uncertain loads: {}\n", fmt::join(parts, ", "));
}

// The problem; names of the cases, and once for each case its half-widths, if those of all are not
// one number; covers.
std::string summary_of(const VerifyOptions& options, const Theorems& theorems,
                       const std::optional<problems::CheckedStructure>& structure) {
  std::string text =
      "the truss is that of the certificate; with --problem FILE the claim is about a problem "
      "file\n";
  if (structure) {
    text = fmt::format(
        "problem: {}, from {}, fingerprint {}\n"
        "coordinates, yield forces and loads are those of the truss\n",
        (*structure)->name, options.problem, hexadecimal(theorems.front().fingerprint));
  }
  if (const double sudden = theorems.front().theorem.sudden; sudden != 1)
    text += fmt::format("yield forces divided by {}\n", sudden);
  const bool one_number = half_width_of(theorems).has_value();
  std::vector<std::string> cases;
  for (const auto& each : theorems) {
    const auto& name = each.theorem.load_case;
    if (cases.empty() || cases.back() != support::on_one_line(name)) {
      cases.push_back(support::on_one_line(name));
      text += covered_cases_text({name});
      if (!one_number) text += half_widths_text(each.half_widths);
    }
    text += covering_text(each.theorem);
  }
  if (structure) text += cases_left_text(cases, **structure);
  return text;
}

std::set<std::string> cases_of(const Theorems& theorems) {
  std::set<std::string> cases;
  for (const auto& each : theorems) cases.insert(each.theorem.load_case);
  return cases;
}

// Sentence about all cases together: factors that are carried in each of them under every load.
answer::CertificateCheck::Factor factor_of(const Theorems& theorems) {
  const auto cases = cases_of(theorems);
  answer::CertificateCheck::Factor factor{.loads = {.half_width = half_width_of(theorems)},
                                          .cases = cases.size()};
  double largest_lower = infinity, largest_upper = infinity;
  double least_lower = -infinity, least_upper = -infinity;
  std::set<std::string> with_least;
  for (const auto& each : theorems) {
    if (each.theorem.claim == LimitClaim::none) {
      factor.at_none = true;
    } else if (each.theorem.claim == LimitClaim::largest) {
      largest_lower = std::min(largest_lower, each.lower);
      largest_upper = std::min(largest_upper, each.upper);
    } else {
      with_least.insert(each.theorem.load_case);
      least_lower = std::max(least_lower, each.lower);
      least_upper = std::max(least_upper, each.upper);
    }
  }
  if (factor.at_none) return factor;
  factor.largest = answer::CertificateCheck::proved_between(largest_lower, largest_upper);
  if (with_least == cases || least_lower > largest_upper)
    factor.minimum = answer::CertificateCheck::proved_between(
        least_lower, with_least == cases ? least_upper : infinity);
  return factor;
}

// Bounds of the factors that are carried while no strut falls below its residual strength: those
// carried at residual strength are, and those beyond the bounds at full strength are not.
answer::CertificateCheck::Factor factor_of_struts(const Theorems& at_strength,
                                                  const Theorems& after_buckling) {
  auto factor = factor_of(at_strength);
  factor.struts = true;
  const bool of_all = cases_of(at_strength) == cases_of(after_buckling);
  const auto carried = of_all ? factor_of(after_buckling) : answer::CertificateCheck::Factor();
  factor.largest.lower = carried.largest.lower;
  factor.minimum.upper = carried.minimum.upper;
  return factor;
}

// Load cases of the claims at residual strength; empty: the same as those at strength.
std::string cases_at_residual_text(const Theorems& at_strength, const Theorems& after_buckling) {
  const auto cases = cases_of(after_buckling);
  if (cases == cases_of(at_strength)) return {};
  std::vector<std::string> names;
  names.reserve(cases.size());
  for (const auto& each : cases) names.push_back(support::in_quotes(each));
  return fmt::format("the claims at residual strength are for load case{} {} only\n",
                     cases.size() == 1 ? "" : "s", fmt::join(names, ", "));
}

std::vector<std::string> names_of(const TrussTheorem& theorem,
                                  const std::vector<std::size_t>& members) {
  std::vector<std::string> names;
  for (const auto member : members) {
    const auto& bar = theorem.truss.bars[member];
    names.push_back(theorem.truss.names[bar.first] + '-' + theorem.truss.names[bar.second]);
  }
  return names;
}

// Sentence about the losses in all cases together.
answer::CertificateCheck::Loss loss_of(const Theorems& theorems) {
  const auto& first = theorems.front().theorem;
  const auto worst = std::ranges::min_element(theorems, {}, &Checked::upper);
  const double lower = std::ranges::min_element(theorems, {}, &Checked::lower)->lower;
  const auto cases = cases_of(theorems).size();
  const auto some = [&](auto has) { return std::ranges::any_of(theorems, has); };
  return {.maximum = first.losses,
          .cases = cases,
          .load_case = cases == 1 ? first.load_case : "",
          .uncertain = some([](const Checked& each) { return !each.half_widths.empty(); }),
          .loads = {.half_width = half_width_of(theorems)},
          .as_given = some([](const Checked& each) { return each.as_given; }),
          .kept = names_of(first, first.kept),
          .lost = names_of(worst->theorem, worst->theorem.collapse.lost),
          .fatal = worst->theorem.claim == LimitClaim::none,
          .factor = answer::CertificateCheck::proved_between(lower, worst->upper),
          .sudden = first.sudden};
}

}  // namespace

VerifyFindings verify_truss(CommandRun& run, const VerifyOptions& options,
                            const std::optional<problems::CheckedStructure>& structure,
                            const std::string& text) {
  Theorems theorems;
  auto recorded = read_certificate_text(
      [&] { return verify::read_truss_certificate(text, options.certificate); });
  for (auto& theorem : recorded) theorems.push_back({std::move(theorem)});
  const auto status = prove(run, options, structure, theorems);
  if (status != engine::Status::solved) return {.status = status};
  VerifyFindings findings;
  for (const auto& each : theorems) {
    findings.check.refusals += each.refusals.size();
    for (const auto& refusal : each.refusals)
      findings.refusals += fmt::format("{}: refused: {}\n", options.certificate, refusal);
  }
  if (findings.check.refusals > 0) return findings;
  auto& summary = findings.summary;
  summary = summary_of(options, theorems, structure);
  const bool of_losses = theorems.front().theorem.losses > 0;
  const auto split = std::stable_partition(theorems.begin(), theorems.end(),
                                           [](const auto& each) { return !each.theorem.residual; });
  const Theorems after_buckling(split, theorems.end());
  theorems.erase(split, theorems.end());
  const auto is_strut = [](const verify::Bar& bar) { return bar.residual < bar.compression; };
  const bool struts = !after_buckling.empty() ||
                      std::ranges::any_of(theorems.front().theorem.truss.bars, is_strut) ||
                      (structure && problems::has_struts(*structure));
  if (!after_buckling.empty()) {
    const auto claim = [&](const Theorems& of, bool upper) {
      if (of_losses) return answer::loss_claim(loss_of(of));
      const auto factors = answer::factor_claim(factor_of(of));
      return upper ? factors : answer::proved(factors);
    };
    summary += cases_at_residual_text(theorems, after_buckling);
    summary += fmt::format(
        "all struts at their strength, an upper value{} {}\nall struts at {}, {}\n",
        of_losses ? ";" : ":", claim(theorems, true),
        structure ? "their residual strength" : "the residual strengths of the certificate",
        claim(after_buckling, false));
  }
  if (of_losses) {
    auto loss = loss_of(theorems);
    // The factor at strength bounds that of struts with a residual strength from outside only.
    loss.struts = struts;
    if (struts)
      loss.factor.lower = cases_of(after_buckling) == cases_of(theorems)
                              ? loss_of(after_buckling).factor.lower
                              : std::nullopt;
    findings.check.claim = std::move(loss);
  } else {
    findings.check.claim =
        struts ? factor_of_struts(theorems, after_buckling) : factor_of(theorems);
  }
  return findings;
}

}  // namespace kusabi::run
