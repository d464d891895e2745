// Counts of a search of a tree of sign patterns.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/counts.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"

namespace kusabi::wedged {

/// Counts of opened nodes by their result, and costs.
struct SignPatternTally : engine::Counts<SignPatternTally> {
  std::uint64_t branched = 0;    ///< both children added to the tree
  std::uint64_t infeasible = 0;  ///< pruned: no wedged configuration below
  std::uint64_t found = 0;       ///< feasible leaves
  std::uint64_t flat = 0;        ///< nodes closed as flat cones, maximal or not
  std::uint64_t faces = 0;     ///< degenerate nodes closed: another node has all of their solutions
  std::uint64_t marginal = 0;  ///< leaves that are marginal
  std::uint64_t undecided = 0;           ///< leaves that are undecided
  std::uint64_t branched_undecided = 0;  ///< nodes branched although they are marginal or undecided
  std::uint64_t escalated = 0;           ///< nodes solved at a higher precision level
  std::uint64_t probed = 0;              ///< children solved for strong branching
  std::uint64_t iterations = 0;          ///< interior-point iterations, over all nodes
  std::uint64_t polyhedral_leaves = 0;   ///< leaves to test of Algorithm 5.8
  std::vector<PolyhedralLeaf> tested;    ///< these leaves; not a count
  std::vector<std::uint64_t> of_block;   ///< feasible leaves of each block; not a count
  /// Feasible leaves of largest margin if they are recorded elsewhere, at most `max_kept`.
  std::vector<Configuration> largest;
  std::uint64_t proved = 0;   ///< leaves proved feasible by the exact test
  std::uint64_t refused = 0;  ///< claims refused by it
  /// Nodes closed as infeasible although the test refuses their evidence.
  std::uint64_t closed_unproved = 0;
  std::uint64_t unproved = 0;                    ///< closed nodes without claim and without proof
  std::uint64_t except_large_displacements = 0;  ///< nodes whose proof leaves these out

  SignPatternTally& operator+=(const SignPatternTally& other) {
    Counts::operator+=(other);
    proved += other.proved;
    refused += other.refused;
    closed_unproved += other.closed_unproved;
    unproved += other.unproved;
    except_large_displacements += other.except_large_displacements;
    tested.insert(tested.end(), other.tested.begin(), other.tested.end());
    of_block.resize(std::max(of_block.size(), other.of_block.size()));
    for (std::size_t block = 0; block < other.of_block.size(); ++block)
      of_block[block] += other.of_block[block];
    for (const auto& leaf : other.largest) keep(leaf);
    return *this;
  }

  static constexpr std::size_t max_kept = 10;

  /// Adds a leaf to `largest`, which is in the order of decreasing margins.
  void keep(const Configuration& leaf) {
    if (largest.size() == max_kept && !has_larger_margin(leaf, largest.back())) return;
    largest.insert(std::ranges::upper_bound(largest, leaf, has_larger_margin), leaf);
    if (largest.size() > max_kept) largest.pop_back();
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned version) {
    Counts::serialize(archive, version);
    archive& tested& of_block& largest& proved& refused& closed_unproved& unproved&
        except_large_displacements;
  }

  static constexpr auto fields() {
    return std::tuple{field("branched", &SignPatternTally::branched),
                      field("infeasible", &SignPatternTally::infeasible),
                      field("found", &SignPatternTally::found),
                      field("flat_nodes", &SignPatternTally::flat),
                      field("faces", &SignPatternTally::faces),
                      field("marginal_leaves", &SignPatternTally::marginal),
                      field("undecided_leaves", &SignPatternTally::undecided),
                      field("undecided_branched", &SignPatternTally::branched_undecided),
                      field("escalated", &SignPatternTally::escalated),
                      field("probed", &SignPatternTally::probed),
                      field("iterations", &SignPatternTally::iterations),
                      field("candidates", &SignPatternTally::polyhedral_leaves)};
  }
};

}  // namespace kusabi::wedged
