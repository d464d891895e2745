// Proof of one range of records.
#include "run/verify/verification.hpp"

#include <utility>

namespace kusabi::run {

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

}  // namespace kusabi::run
