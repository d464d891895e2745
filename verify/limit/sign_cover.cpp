// Division of the nodes by columns that all of them have decided.
#include "verify/limit/sign_cover.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace kusabi::verify {
namespace {

constexpr const char* of_no_node = "no node covers some combination of signs";

// Checks that `nodes`, at least one, which all have the signs decided so far, cover all
// combinations of the others. A column decided by all of them partitions both the combinations and
// the nodes; each part has fewer nodes, so that the depth of the calls is below their number.
std::optional<std::string> flaw(std::span<const LimitNode*> nodes, std::vector<bool>& decided,
                                std::size_t depth) {
  for (std::size_t j = 0; j < decided.size(); ++j) {
    if (decided[j] || std::ranges::any_of(nodes, [j](const auto* n) { return n->signs[j] == 0; })) {
      continue;
    }
    decided[j] = true;
    const auto middle = std::partition(nodes.begin(), nodes.end(),
                                       [j](const auto* node) { return node->signs[j] > 0; });
    const auto positive = static_cast<std::size_t>(middle - nodes.begin());
    if (positive == 0 || positive == nodes.size()) return of_no_node;
    auto found = flaw(nodes.first(positive), decided, depth + 1);
    if (!found) found = flaw(nodes.subspan(positive), decided, depth + 1);
    decided[j] = false;
    return found;
  }
  const auto whole = [depth](const LimitNode* node) {
    const auto count =
        node->signs.size() - static_cast<std::size_t>(std::ranges::count(node->signs, 0));
    return count == depth;
  };
  // A node that decides no further sign covers the whole subtree.
  if (std::ranges::any_of(nodes, whole)) return {};
  return "the nodes do not form a tree: some of them have no decided sign in common";
}

}  // namespace

std::optional<std::string> flaw_of_sign_cover(std::span<const LimitNode> nodes,
                                              std::size_t columns) {
  std::vector<const LimitNode*> all;
  for (const auto& node : nodes) all.push_back(&node);
  std::vector<bool> decided(columns, false);
  return nodes.empty() ? of_no_node : flaw(all, decided, 0);
}

}  // namespace kusabi::verify
