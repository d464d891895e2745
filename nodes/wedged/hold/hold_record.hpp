// Evidence of states under load for a certificate (docs/certificates.md): trees without states, and
// states. Trees are recorded while they are searched.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/hold/hold_tree.hpp"
#include "nodes/wedged/hold/load_program.hpp"

namespace kusabi::wedged {

/// The outcome of one tree, on all ranks.
struct HoldOutcome {
  engine::Status status = engine::Status::solved;
  std::vector<LoadedLeaf> leaves{};  ///< with states that are proved; of first_leaf() at most one
  HoldTally tally{};
  std::uint64_t opened = 0;

  /// True if there is no state below the root, proved.
  [[nodiscard]] bool is_infeasible() const {
    return status == engine::Status::solved && leaves.empty() && tally.computed == 0 &&
           tally.of_other_leaves == 0 && tally.unresolved() == 0 && tally.limits.empty();
  }

  /// True if states may be missing: the search was stopped, or leaves are undecided.
  [[nodiscard]] bool is_unresolved() const {
    return status != engine::Status::solved || tally.unresolved() != 0;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& leaves& tally& opened;
  }
};

/// Searches a whole tree for all leaves with states; every rank gets the same, in one order.
HoldOutcome all_leaves(engine::Analysis& analysis, HoldTree& tree);

/// A pattern of a block as one of the whole problem.
LoadedPattern in_whole(const LoadedPattern& own, const support::IndexSet& candidates);

/// Evidence of a tree without states.
struct TreeEvidence {
  double mu = 0;
  std::vector<LoadShare> shares{};                 ///< none: wedged configurations
  std::optional<GripRestriction> grip{};           ///< of its states
  bool except_dead = false;                        ///< states of the dead load alone do not count
  std::optional<std::vector<ClosedNode>> nodes{};  ///< those that this rank closed; nothing: an
                                                   ///< earlier run closed some of them
  std::uint64_t opened = 0;                        ///< nodes of the tree, on all ranks
  std::optional<std::uint64_t> max_nodes{};        ///< and bounds; nothing: any number
  std::vector<ProvedBound> bounds{};  ///< of candidates, used by its nodes; on every rank
  std::vector<double> weights{};      ///< with bounds: c_j of each share, to which they refer

  /// Bounds refer to a sum of reactions and loads. That of a search for sums beyond a given one has
  /// the excess as well, which is not in a certificate.
  [[nodiscard]] bool may_have_bounds() const {
    return !grip || grip->kind == GripRestriction::Kind::equal;
  }
};

/// The tree of these loads, coefficient and restriction, without its evidence.
HoldTree tree_of(const LoadedProblem& block, const TreeEvidence& evidence, Precision precision);

/// Searches a tree on rank 0 until its first leaf, with at most this many nodes; every rank gets
/// the same result.
/// @param evidence null, or receives the nodes without states of a tree that has no more nodes
HoldOutcome first_leaf_of_small(engine::Analysis& analysis, HoldTree& tree, std::uint64_t maximum,
                                TreeEvidence* evidence = nullptr);

/// Searches a tree until its first leaf; every rank gets the same result.
/// @param evidence null, or receives the nodes without states
HoldOutcome first_leaf(engine::Analysis& analysis, HoldTree& tree,
                       TreeEvidence* evidence = nullptr);

/// Kind of a certificate: of a bound of the holding friction coefficient, or of all load factors.
enum class HoldClaim { lower, upper, factors };

/// Receives the evidence of one certificate. Sets of candidates are those of the whole problem.
class HoldRecord {
 public:
  HoldRecord() = default;
  HoldRecord(const HoldRecord&) = delete;
  HoldRecord& operator=(const HoldRecord&) = delete;
  virtual ~HoldRecord() = default;

  /// A tree without states; on every rank, with the nodes that it closed.
  /// @return false if a bound of a candidate is refused, and the tree with it
  virtual bool tree(std::uint32_t block, const TreeEvidence& tree) = 0;
  /// A state under a load, or without one a wedged configuration that holds every load; on every
  /// rank.
  virtual void state(std::uint32_t block, const std::optional<LoadShare>& share,
                     const LoadedPattern& pattern, std::span<const double> numbers) = 0;
  /// The certificate is complete; on every rank.
  virtual void finish() = 0;
};

/// Opens a certificate for a friction coefficient.
using HoldRecorder = std::function<std::unique_ptr<HoldRecord>(HoldClaim end, double mu)>;

/// A block whose evidence is recorded.
struct RecordedBlock {
  const LoadedProblem& problem;
  support::IndexSet candidates;  ///< in the whole problem
  std::uint32_t number = 0;
  double mu = 0;
  Precision precision = Precision::escalating;
};

/// Records a tree, which is searched again if its nodes are not known: if some were closed by an
/// earlier run, or with bounds that cannot be recorded or are refused. It is not recorded if it has
/// too many nodes.
void record_tree(engine::Analysis& analysis, const RecordedBlock& block, TreeEvidence evidence,
                 HoldRecord& record);

/// Solves a leaf and records its state, if it has one.
/// @param share nothing: a wedged configuration
/// @param grip at least, at most or exactly this sum of the normal reactions, if the pattern has
///        such a state with strict inequalities; otherwise any sum
void record_state(engine::Analysis& analysis, const RecordedBlock& block,
                  const LoadedPattern& pattern, const std::optional<LoadShare>& share,
                  const std::optional<GripRestriction>& grip, HoldRecord& record);

}  // namespace kusabi::wedged
