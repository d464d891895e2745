// Evidence of closed nodes: an exact test that accepts or refuses it, and its recorder.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "nodes/wedged/tree/pattern_tally.hpp"

namespace kusabi::wedged {

/// Evidence of a closed node for a certificate (docs/certificates.md).
struct Evidence {
  enum class Kind {
    infeasible,  ///< numbers: the multipliers of the proof, one for each candidate of the block
    feasible,    ///< a leaf; numbers: the tangential reactions of the candidates in U. For
                 ///< unconstrained bodies both continue with the mean motion of w or u
                 ///< (relaxation/mean_motion.hpp)
    cut,   ///< infeasible with cuts; numbers: those of `infeasible`, then one for the cut of each
           ///< candidate
    form,  ///< the whole block; numbers: QuadraticMultipliers::numbers()
    no_claim,  ///< a flat, marginal or undecided leaf; no numbers
  };
  Kind kind = Kind::no_claim;
  std::uint32_t block = 0;
  SignPattern node;                 ///< of the whole problem's candidates
  std::span<const double> numbers;  ///< valid during the call
};

/// Recorder of the evidence of every closed node.
using EvidenceRecorder = std::function<void(const Evidence&)>;

/// Result of the exact test of a claim. Proofs may leave out large displacements
/// (verify/wedged/block_model.hpp).
enum class NodeProof : char { refused, except_large_displacements, complete };

/// Exact test of the evidence of a node to be closed. For a node without claim: refused unless its
/// configurations all belong to other nodes.
using ExactNodeTest = std::function<NodeProof(const Evidence&)>;

/// Exact test and recorder of evidence, either of which may be absent.
class EvidenceGate {
 public:
  void report_to(EvidenceRecorder recorder) { recorder_ = std::move(recorder); }

  /// @param binding true: refused claims are not used
  void test_with(ExactNodeTest test, bool binding) {
    test_ = std::move(test);
    binding_ = binding;
  }

  [[nodiscard]] bool records() const { return static_cast<bool>(recorder_); }
  [[nodiscard]] bool wants_evidence() const { return recorder_ || test_; }

  /// Records a claim. @return false: the test refuses it, and refused claims are not used
  bool passes(const Evidence& claim, SignPatternTally& tally) const;

  /// Records a closed node without claim; counts it as unproved unless the test accepts it.
  void pass_open(const Evidence& node, SignPatternTally& tally) const;

 private:
  EvidenceRecorder recorder_;
  ExactNodeTest test_;
  bool binding_ = false;
};

}  // namespace kusabi::wedged
