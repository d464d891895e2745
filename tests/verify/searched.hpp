// Certificates for tests: as written by a search, and in parts for falsification.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// The lines of a certificate of a list of patterns, each with its line feed.
struct Draft {
  std::vector<std::string> header;  ///< up to the modes
  std::vector<std::string> bounds;
  std::vector<std::string> nodes;  ///< of the theorem of each block, and wedged configurations

  /// The certificate, with the right counts and the right digest.
  [[nodiscard]] std::string text() const;
  /// Lines up to the first node.
  [[nodiscard]] std::size_t lines_before_nodes() const;

 private:
  [[nodiscard]] std::vector<std::string> before_nodes() const;
};

/// `text` up to its digest, followed by the right one.
std::string sealed(const std::string& text);

/// The same with one to three letters of its part from `begin`, of `size`, replaced by other valid
/// letters, with the right digest.
std::string misspelt(std::string text, std::size_t begin, std::size_t size,
                     std::mt19937_64& generator);

/// A file of examples/.
problems::WedgedProblem example(const std::string& name);

problems::Structure example_structure(const std::string& name);

/// Expects that the enclosure of K is narrow, and that of the solver up to rounding.
void expect_same_stiffness(const problems::Structure& structure);

/// The certificate as written by `kusabi patterns --certificate`, also for unconstrained bodies.
std::string written(const problems::WedgedProblem& problem, double mu);

/// Result of a search on one rank as a certificate with one block.
Draft searched(const problems::WedgedProblem& problem, double friction);

/// Two drafts of one dimension as the two blocks of a certificate.
Draft in_blocks(const Draft& first, const Draft& second);

/// Verdict on a certificate: refusals of bounds, of nodes, of the cover, of K.
struct Verdict {
  std::vector<std::string> refusals;
  std::set<support::IndexSet> feasible;  ///< U of those proved
  std::size_t bounds = 0;                ///< proved
  std::size_t infeasible = 0;            ///< proved, with cuts or without
  std::size_t marginal = 0;
  std::size_t except_large_displacements = 0;  ///< of the infeasible ones
  std::size_t unloaded = 0;                    ///< of the undecided ones

  [[nodiscard]] bool proved() const { return refusals.empty(); }
};

/// @throws CertificateError
Verdict verdict(const std::string& text);

/// The same with the K of a structure, unless it is null. An inconsistency is the only refusal
/// then.
/// @throws CertificateError
Verdict verdict(const std::string& text, const Structure* structure);

}  // namespace kusabi::verify
