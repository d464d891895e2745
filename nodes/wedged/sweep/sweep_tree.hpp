// Histories of given leaves on all ranks: a node is a range of the leaves, which is halved down to
// one.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "engine/counts.hpp"
#include "engine/expansion.hpp"
#include "engine/index_range.hpp"
#include "engine/search_declaration.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/sweep/leaf_history.hpp"
#include "nodes/wedged/tree/node_interruption.hpp"

namespace kusabi::wedged {

/// Problem type of engine::search.
class SweepTree {
 public:
  using Node = engine::IndexRange;  ///< of leaves

  struct Solution {
    std::uint32_t number = 0;  ///< of the leaf in the list
    LeafHistory history;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& number& history;
    }
  };

  struct Tally : engine::Counts<Tally> {
    std::uint64_t leaves = 0;
    std::uint64_t programs = 0;  ///< cone programs solved

    static constexpr auto fields() {
      return std::tuple{field("leaves", &Tally::leaves), field("programs", &Tally::programs)};
    }
  };

  /// A leaf at the coefficient `maximum` x width; each candidate of the block is in contact or
  /// separated.
  struct Leaf {
    PatternNode place;
    LeafStage stage;  ///< not infeasible
  };

  /// Candidates with a reaction are in contact, all others separated, inactive or not.
  /// @param found at the coefficient `maximum` x width
  static Leaf leaf_of(const Configuration& found, const std::vector<support::IndexSet>& blocks);

  SweepTree(const problems::WedgedProblem& problem, double width, std::int64_t maximum,
            std::vector<Leaf> leaves);

  [[nodiscard]] Node root() const;
  void expand(Node&& node, engine::Expansion<SweepTree>& out);
  [[nodiscard]] Tally tally() const;

 private:
  NodeInterruption interruption_;
  std::vector<CriticalFriction> critical_;  // of each block
  std::vector<Leaf> leaves_;
  std::int64_t maximum_;
  Tally tally_;
};

}  // namespace kusabi::wedged

extern template kusabi::engine::OutcomeOf<kusabi::wedged::SweepTree> kusabi::engine::search(
    kusabi::wedged::SweepTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
