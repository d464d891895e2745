// Reconstruction of the search tree from its closed nodes.
#include "verify/wedged/cover.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace kusabi::verify {

using support::IndexSet;

namespace {

/// A node, or the pattern of a wedged configuration.
struct ClosedPart {
  std::size_t line;
  const char* keyword;
  const IndexSet& contact;
  const IndexSet& separated;
};

class Cover {
 public:
  Cover(const Certificate& certificate, const IndexSet& block)
      : certificate_(certificate), block_(block) {}

  // Checks that `parts` cover all patterns below the node (contact, separated), which contains
  // all of them. A candidate decided by all of them partitions the patterns and the parts, so any
  // such candidate will do. The depth does not exceed the number of candidates.
  std::optional<std::string> flaw(std::span<ClosedPart*> parts, const IndexSet& contact,
                                  const IndexSet& separated) {
    if (parts.empty()) {
      return "no node covers " + node_name(contact, separated) +
             "; expected an infeasible or a feasible one";
    }
    auto common = block_ - (contact | separated);
    for (const auto* part : parts) common &= part->contact | part->separated;
    if (common.empty()) return flaw_of_one(parts, contact, separated);
    const int candidate = common.lowest();
    const auto one = IndexSet::single(candidate);
    const auto middle = std::partition(
        parts.begin(), parts.end(),
        [candidate](const ClosedPart* part) { return part->contact.contains(candidate); });
    const auto touching = static_cast<std::size_t>(middle - parts.begin());
    auto found = flaw(parts.first(touching), contact | one, separated);
    if (!found) found = flaw(parts.subspan(touching), contact, separated | one);
    return found;
  }

 private:
  // The fault of parts of which no candidate is decided in all.
  [[nodiscard]] std::optional<std::string> flaw_of_one(std::span<ClosedPart*> parts,
                                                       const IndexSet& contact,
                                                       const IndexSet& separated) const {
    const auto whole = [&](const ClosedPart* part) {
      return (part->contact | part->separated) == (contact | separated);
    };
    const auto first = std::find_if(parts.begin(), parts.end(), whole);
    if (first == parts.end()) {
      return "the nodes below " + node_name(contact, separated) +
             " do not form a tree: they have no decided candidate in common";
    }
    if (parts.size() == 1) return {};
    const auto* const other = parts[first == parts.begin() ? 1 : 0];
    const auto line = "line " + std::to_string((*first)->line);
    const auto other_line = "line " + std::to_string(other->line);
    if (!whole(other))
      return line + " and " + other_line + " both cover patterns below " +
             node_name(contact, separated);
    return line + " says " + (*first)->keyword + " and " + other_line + " says " + other->keyword +
           " of " + node_name(contact, separated);
  }

  [[nodiscard]] std::string node_name(const IndexSet& contact, const IndexSet& separated) const {
    return "contact " + certificate_.names_of(contact) + " separated " +
           certificate_.names_of(separated);
  }

  const Certificate& certificate_;
  const IndexSet& block_;
};

}  // namespace

std::optional<std::string> flaw_of_cover(const Certificate& certificate, std::size_t theorem) {
  const auto& about = certificate.theorems[theorem];
  std::vector<ClosedPart> all;
  for (const auto& node : certificate.nodes) {
    if (node.theorem == theorem)
      all.push_back({node.line, claim_name(node.claim), node.contact, node.separated});
  }
  for (const auto& state : certificate.states) {
    if (about.about_wedged() && !state.share && state.block == about.block)
      all.push_back({state.line, "wedged", state.contact, state.separated});
  }
  std::vector<ClosedPart*> parts;
  parts.reserve(all.size());
  for (auto& part : all) parts.push_back(&part);
  auto flaw = Cover(certificate, certificate.blocks[about.block]).flaw(parts, {}, {});
  if (flaw && certificate.blocks.size() > 1)
    *flaw = "block " + std::to_string(about.block + 1) + ": " + *flaw;
  return flaw;
}

}  // namespace kusabi::verify
