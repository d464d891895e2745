// Texts of refusals and of the subject of a proof.
#include "run/verify/proof_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "problems/wedged/wedged_problem.hpp"
#include "run/output/values.hpp"
#include "verify/wedged/block_proof.hpp"

namespace kusabi::run {

VerifyFindings refusal_of_certificate(const VerifyOptions& options, const std::string& why) {
  return {.check = {.refusals = 1},
          .refusals = fmt::format("{}: refused: {}\n", options.certificate, why)};
}

std::string indefinite_stiffness(std::size_t motions) {
  return fmt::format("K was not proved to be positive definite{}",
                     motions == 0 ? "" : " except for rigid-body modes of unconstrained bodies");
}

std::string verified_problem(const VerifyOptions& options,
                             const problems::CheckedStructure& structure) {
  return fmt::format("problem: {}, from {}, fingerprint {}\n", structure->name, options.problem,
                     hexadecimal(problems::wedged_fingerprint(structure)));
}

std::string verified_friction(const problems::CheckedStructure& structure, double friction) {
  const bool same =
      std::ranges::all_of(structure->contact, [](const auto& each) { return each.friction == 1; });
  return fmt::format("friction coefficient: {}{}\n", friction,
                     same ? "" : " times that of each candidate");
}

std::string large_displacements_text(std::uint64_t nodes) {
  if (nodes == 0) return {};
  return fmt::format(", {} of them only for displacements up to {:.2g} times the strains", nodes,
                     verify::largest_displacement_ratio);
}

}  // namespace kusabi::run
