// Leaf of a configuration in the tree of its block.
#include "nodes/wedged/relaxation/sign_pattern.hpp"

#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

using support::IndexSet;

SignPattern own_leaf(const Configuration& found, const IndexSet& block) {
  const auto& contact = found.pattern.contact;
  return {.contact = problems::in_block(contact, block),
          .separated = problems::in_block(block - contact, block),
          .inactive = {}};
}

PatternNode own_node(const Configuration& found, const std::vector<IndexSet>& blocks) {
  return {.block = found.block, .pattern = own_leaf(found, blocks[found.block])};
}

}  // namespace kusabi::wedged
