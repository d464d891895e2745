// Texts of refusals and of the subject of a proof.
#include "run/verify/proof_words.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/output/values.hpp"
#include "support/one_line.hpp"
#include "verify/wedged/block_proof.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::run {

VerifyFindings refusal_of_certificate(const VerifyOptions& options, const std::string& why) {
  return {.check = {.refusals = 1},
          .refusals = fmt::format("{}: refused: {}\n", options.certificate, why)};
}

std::string indefinite_stiffness(std::size_t motions) {
  return fmt::format("K was not shown to be positive definite{}",
                     motions == 0 ? "" : " except for rigid-body modes of unconstrained bodies");
}

std::optional<problems::Structure> in_case_of_certificate(const problems::Structure& structure,
                                                          const std::string& load_case) {
  const auto cases = problems::load_cases(structure);
  if (load_case.empty() && cases.empty()) return structure;
  for (const auto& each : cases) {
    if (support::on_one_line(each) == load_case) return problems::in_load_case(structure, each);
  }
  return {};
}

std::string no_such_case(const VerifyOptions& options, const std::string& load_case) {
  if (load_case.empty()) return options.problem + ": no load case has the loads of the certificate";
  return fmt::format("{}: no load case {}", options.problem, support::in_quotes(load_case));
}

std::string covered_cases_text(const std::vector<std::string>& covered) {
  std::string text;
  for (const auto& each : covered) {
    if (!each.empty()) text += "load case " + support::in_quotes(each) + "\n";
  }
  return text;
}

std::string cases_left_text(const std::vector<std::string>& covered,
                            const problems::Structure& structure) {
  std::vector<std::string> left;
  for (const auto& name : problems::load_cases(structure)) {
    if (std::ranges::find(covered, support::on_one_line(name)) == covered.end())
      left.push_back(support::in_quotes(name));
  }
  if (left.empty()) return {};
  return fmt::format("not part of the certificate: load case{} {}\n", left.size() == 1 ? "" : "s",
                     fmt::join(left, ", "));
}

std::string verified_problem(const VerifyOptions& options,
                             const problems::CheckedStructure& structure) {
  return fmt::format("problem: {}, from {}, fingerprint {}\n", structure->name, options.problem,
                     hexadecimal(problems::wedged_fingerprint(structure)));
}

std::string verified_friction(const problems::CheckedStructure& structure, double friction) {
  const bool same =
      std::ranges::all_of(structure->contact, [](const auto& each) { return each.friction == 1; });
  return fmt::format("{}: {}\n", answer::friction_name(!same), friction);
}

std::string large_displacements_text(std::uint64_t nodes) {
  if (nodes == 0) return {};
  return fmt::format(", {} of them only for displacements up to {:.2g} times the strains", nodes,
                     verify::largest_displacement_ratio);
}

}  // namespace kusabi::run
