// A tree of sign patterns that counts what the verifier says of its nodes, so that the counts go
// with the search wherever it goes on.
#pragma once

#include <cstdint>
#include <functional>
#include <tuple>
#include <utility>

#include "engine/counts.hpp"
#include "engine/expansion.hpp"
#include "nodes/wedged/sign_pattern.hpp"

namespace kusabi::wedged {

/// The problem type that engine::search searches.
class JudgedTree {
 public:
  using Node = SignPatternTree::Node;
  using Solution = SignPatternTree::Solution;
  static constexpr auto work_of_first_child = SignPatternTree::work_of_first_child;

  struct Tally : engine::Counts<Tally> {
    std::uint64_t alive = 0;     ///< leaves that live by the verifier's test
    std::uint64_t unproved = 0;  ///< nodes of which it proves nothing

    static constexpr auto fields() {
      return std::tuple{field("alive", &Tally::alive), field("unproved", &Tally::unproved)};
    }
  };

  /// @param holds whether the verifier accepts what is said of a node
  JudgedTree(SignPatternTree tree, std::function<bool(const Evidence&)> holds)
      : tree_(std::move(tree)), holds_(std::move(holds)) {
    tree_.report_to([this](const auto& evidence) {
      const bool held = holds_(evidence);
      if (!held || evidence.kind == Evidence::Kind::marginal) ++tally_.unproved;
      if (held && evidence.kind == Evidence::Kind::alive) ++tally_.alive;
    });
  }
  JudgedTree(const JudgedTree&) = delete;
  JudgedTree& operator=(const JudgedTree&) = delete;
  ~JudgedTree() = default;

  Node root() const { return tree_.root(); }
  Tally tally() const { return tally_; }

  void expand(Node&& node, engine::Expansion<JudgedTree>& out) {
    auto fate = tree_.decide(node, out);
    if (!fate) return;
    if (fate->leaf) out.solution(std::move(*fate->leaf));
    for (const Node& child : fate->children) out.branch(child);
  }

 private:
  SignPatternTree tree_;
  std::function<bool(const Evidence&)> holds_;
  Tally tally_;
};

}  // namespace kusabi::wedged
