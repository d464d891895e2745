// Critical friction coefficients of given patterns on all ranks: Algorithm 6.1 of the wedged paper,
// step 2.
//
// A flat cone is treated like a solid one, under any of its sign patterns. An undecided leaf has a
// lower bound only.
//
// A node is a range of the patterns, which is halved down to one, or one pattern with the cell that
// contains its critical coefficient, which is halved down to the width; by Newton's method the
// latter is one node. When ranks outnumber patterns, the first cell of each is divided into
// several, of which one contains the change. As all cells end on one grid, the answer is the same
// on any number of ranks, by either method.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/counts.hpp"
#include "engine/expansion.hpp"
#include "engine/search_declaration.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/tree/node_interruption.hpp"

namespace kusabi::wedged {

/// A pattern and the cell of its critical coefficient.
struct CriticalPattern {
  std::uint32_t number = 0;  ///< in the list of patterns
  CriticalCell cell;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& number& cell;
  }
};

/// Problem type of engine::search.
class CriticalPatternTree {
 public:
  struct Node {
    std::uint32_t first = 0, count = 0;  ///< a range of patterns
    CriticalCell cell;                   ///< of its one pattern
    bool claimed = true;  ///< true if the pattern is known to become feasible within the cell

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& first& count& cell& claimed;
    }
  };
  using Solution = CriticalPattern;

  struct Tally : engine::Counts<Tally> {
    std::uint64_t programs = 0;  ///< cone programs solved

    static constexpr auto fields() { return std::tuple{field("programs", &Tally::programs)}; }
  };

  /// A leaf of a block's tree at the coefficient `start` x width.
  struct Pattern {
    PatternNode leaf;
    bool feasible = true;  ///< feasible there; otherwise undecided
  };

  /// @param sections number of cells into which the first cell of a pattern is divided
  CriticalPatternTree(const problems::WedgedProblem& problem, double width,
                      std::vector<Pattern> patterns, std::int64_t start, CriticalMethod method,
                      std::int64_t sections);

  [[nodiscard]] Node root() const;
  void expand(Node&& node, engine::Expansion<CriticalPatternTree>& out);
  [[nodiscard]] Tally tally() const;

 private:
  // A smaller cell of a node's pattern.
  struct Located {
    CriticalCell cell;
    bool done = false;  // it is not divided further
  };

  void begin(const Node& node, engine::Expansion<CriticalPatternTree>& out);
  // Nothing if the change is in another cell.
  std::optional<Located> locate(Node node);

  NodeInterruption interruption_;
  std::vector<CriticalFriction> critical_;  // of each block
  std::vector<Pattern> patterns_;
  std::int64_t start_;
  CriticalMethod method_;
  std::int64_t sections_;
};

}  // namespace kusabi::wedged

extern template kusabi::engine::OutcomeOf<kusabi::wedged::CriticalPatternTree>
kusabi::engine::search(kusabi::wedged::CriticalPatternTree&, kusabi::engine::Transport&,
                       const kusabi::engine::Options&);
