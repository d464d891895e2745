// Reconstruction of the search tree from its closed nodes.
#include "verify/wedged/cover.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace kusabi::verify {

using support::IndexSet;

namespace {

class Cover {
 public:
  Cover(const Certificate& certificate, const IndexSet& block)
      : certificate_(certificate), block_(block) {}

  // Checks that `records` cover all patterns below the node (contact, separated), which contains
  // all of them. A candidate decided by all of them partitions the patterns and the records, so any
  // such candidate will do. The depth does not exceed the number of candidates.
  std::optional<std::string> flaw(std::span<const Record*> records, const IndexSet& contact,
                                  const IndexSet& separated) {
    if (records.empty()) {
      return "no node covers " + node_name(contact, separated) + "; expected one dead or one alive";
    }
    auto common = block_ - (contact | separated);
    for (const auto* record : records) common &= record->contact | record->separated;
    if (common.empty()) return flaw_of_one(records, contact, separated);
    const int candidate = common.lowest();
    const auto one = IndexSet::single(candidate);
    const auto middle = std::partition(
        records.begin(), records.end(),
        [candidate](const Record* record) { return record->contact.contains(candidate); });
    const auto touching = static_cast<std::size_t>(middle - records.begin());
    auto found = flaw(records.first(touching), contact | one, separated);
    if (!found) found = flaw(records.subspan(touching), contact, separated | one);
    return found;
  }

 private:
  // The fault of records of which no candidate is decided in all.
  [[nodiscard]] std::optional<std::string> flaw_of_one(std::span<const Record*> records,
                                                       const IndexSet& contact,
                                                       const IndexSet& separated) const {
    const auto whole = [&](const Record* record) {
      return (record->contact | record->separated) == (contact | separated);
    };
    const auto first = std::find_if(records.begin(), records.end(), whole);
    if (first == records.end()) {
      return "the nodes below " + node_name(contact, separated) +
             " do not form a tree: they have no decided candidate in common";
    }
    if (records.size() == 1) return {};
    const auto* const other = records[first == records.begin() ? 1 : 0];
    const auto line = "line " + std::to_string((*first)->line);
    const auto other_line = "line " + std::to_string(other->line);
    if (!whole(other))
      return line + " and " + other_line + " both cover patterns below " +
             node_name(contact, separated);
    return line + " says " + claim_name((*first)->claim) + " and " + other_line + " says " +
           claim_name(other->claim) + " of " + node_name(contact, separated);
  }

  [[nodiscard]] std::string node_name(const IndexSet& contact, const IndexSet& separated) const {
    return "contact " + certificate_.names_of(contact) + " separated " +
           certificate_.names_of(separated);
  }

  const Certificate& certificate_;
  const IndexSet& block_;
};

}  // namespace

std::optional<std::string> flaw_of_cover(const Certificate& certificate, const IndexSet& block,
                                         std::vector<const Record*> records) {
  return Cover(certificate, block).flaw(records, {}, {});
}

std::optional<std::string> flaw_of_cover(const Certificate& certificate) {
  for (std::size_t b = 0; b < certificate.blocks.size(); ++b) {
    std::vector<const Record*> records;
    for (const auto& record : certificate.records) {
      if (record.block == b) records.push_back(&record);
    }
    auto flaw = Cover(certificate, certificate.blocks[b]).flaw(records, {}, {});
    if (flaw && certificate.blocks.size() > 1) {
      *flaw = "block " + std::to_string(b + 1) + ": " + *flaw;
    }
    if (flaw) return flaw;
  }
  return {};
}

}  // namespace kusabi::verify
