// Hash of the input and of the computed problem.
#include "run/wedged/problem_comparison.hpp"

#include "engine/collectives.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {

void require_equal_on_all_ranks(Session& session, const problems::WedgedProblem& problem) {
  support::Fingerprint computed;
  computed.add(problem.provenance.fingerprint);
  for (const auto* matrix : {&problem.compliance.stiffness, &problem.compliance.matrix}) {
    for (const double number : matrix->reshaped()) computed.add(number);
  }
  engine::require_equal_on_all_ranks(session.transport(), computed.value());
}

}  // namespace kusabi::run
