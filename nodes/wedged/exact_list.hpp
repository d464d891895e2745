// Comparison of results without proof, by rays and by histories of leaves, with the list of
// patterns of a search with exact test.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/rays/ray_search.hpp"
#include "nodes/wedged/sweep/sweep_findings.hpp"
#include "nodes/wedged/tree/evidence.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// A structure, and the extent of the proof.
struct ExactParameters {
  const problems::CheckedStructure& structure;
  const problems::WedgedProblem& problem;
  Proving proving = Proving::automatic;
};

/// Receives the evidence of the list at each coefficient of a sweep; on every rank.
class ListRecords {
 public:
  ListRecords() = default;
  ListRecords(const ListRecords&) = delete;
  ListRecords& operator=(const ListRecords&) = delete;
  virtual ~ListRecords() = default;

  /// Lists of so many coefficients are to be tested, as long as the test goes on.
  virtual void expect(std::size_t lists) = 0;
  /// A list begins. @param coefficient of friction, which multiplies those of the candidates
  virtual EvidenceRecorder begin(double coefficient) = 0;
  /// It has ended. @param friction of each candidate
  virtual void end(const PatternFindings& list, std::span<const double> friction) = 0;
};

/// Compares the maximal cones that were found with those of the list: it proves their sets of
/// candidates, not the rays in them. Nothing is done if no test is required. Every rank makes the same call; the answer is valid on rank 0.
/// @param found of a complete search
ExactTest tested_cones(engine::Analysis& analysis, const ExactParameters& parameters,
                       std::span<const double> friction, const std::vector<rays::Cone>& found);

/// The same for the counts of a sweep: at given points, at the largest coefficient and at both
/// bounds of every bracket. A cone feasible at a coefficient is feasible at all larger ones, so
/// equal lists at both bounds of a step imply the same list between them.
/// @param records null, or receives the evidence of each list
ExactTest tested_counts(engine::Analysis& analysis, const ExactParameters& parameters,
                        std::span<const double> points, const SweepFindings& found,
                        ListRecords* records = nullptr);

}  // namespace kusabi::wedged
