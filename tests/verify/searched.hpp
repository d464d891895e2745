// Certificates to try: as a search writes them, and taken apart to be spoilt.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "problems/wedged_problem.hpp"

namespace kusabi::verify {

/// The lines of a certificate up to "end", each with its end.
struct Draft {
  std::vector<std::string> header;  ///< up to the line "nodes"
  std::vector<std::string> nodes;

  /// The certificate, with the right count and the right digest.
  [[nodiscard]] std::string text() const;
};

/// `text` up to its digest, with the right one: whatever was done to it.
std::string sealed(const std::string& text);

/// A file of examples/.
problems::WedgedProblem example(const std::string& name);

/// What a search finds, on one rank.
Draft searched(const problems::WedgedProblem& problem, double friction);

/// What is said of a certificate: refusals of nodes, of the cover, of K.
struct Verdict {
  std::vector<std::string> refusals;
  std::set<std::uint64_t> alive;  ///< U of those proved
  std::size_t dead = 0;           ///< proved
  std::size_t marginal = 0;

  [[nodiscard]] bool proved() const { return refusals.empty(); }
};

/// @throws CertificateError
Verdict verdict(const std::string& text);

}  // namespace kusabi::verify
