// Connected displacements by disjoint sets.
#include "problems/wedged/contact_blocks.hpp"

#include <map>

#include <boost/pending/disjoint_sets.hpp>

#include "problems/structure/model/elongation.hpp"
#include "problems/structure/model/several_normals.hpp"
#include "problems/structure/model/superelement.hpp"

namespace kusabi::problems {
namespace {

/// Sets of connected free displacements.
class Connections {
 public:
  explicit Connections(int displacements) : sets_(static_cast<std::size_t>(displacements)) {}

  void join(const std::vector<int>& displacements) {
    for (const int number : displacements) {
      sets_.union_set(at(displacements.front()), at(number));
    }
  }
  std::size_t representative(int displacement) { return sets_.find_set(at(displacement)); }

 private:
  static std::size_t at(int number) { return static_cast<std::size_t>(number); }

  boost::disjoint_sets_with_storage<> sets_;
};

std::vector<int> free_of(const Structure& structure, const FreeDegrees& degrees, int node) {
  std::vector<int> numbers;
  for (int axis = 0; axis < structure.dimension; ++axis) {
    if (degrees.number(axis, node) >= 0) numbers.push_back(degrees.number(axis, node));
  }
  return numbers;
}

}  // namespace

std::vector<support::IndexSet> contact_blocks(const Structure& structure,
                                              const FreeDegrees& degrees,
                                              std::span<const UnconstrainedBody> bodies) {
  Connections connections(degrees.size());
  const auto join_nodes = [&](const std::vector<int>& nodes) {
    std::vector<int> moving;
    for (const int node : nodes) {
      for (int axis = 0; axis < structure.dimension; ++axis) {
        for (const auto& part : parts_of<double>(degrees, axis, node))
          moving.push_back(part.number);
      }
    }
    connections.join(moving);
  };
  for (const Member& member : structure.members) {
    std::vector<int> stretching;
    for (const auto& entry : elongation_vector<double>(structure, degrees, member)) {
      if (entry.value != 0) stretching.push_back(entry.number);
    }
    connections.join(stretching);
  }
  for (const Spring& spring : structure.springs) {
    std::vector<int> stretching;
    for (const auto& part : parts_of<double>(degrees, spring.axis, spring.node))
      stretching.push_back(part.number);
    connections.join(stretching);
  }
  for (const Element& element : structure.elements) join_nodes(element.nodes);
  for (std::size_t index = 0; index < structure.superelements.size(); ++index) {
    for_each_entry<double>(structure, degrees, index, [&](int row, int column, double) {
      connections.join({row, column});
    });
  }
  for (const UnconstrainedBody& body : bodies) join_nodes(body.nodes);
  for (const ContactCandidate& candidate : structure.contact) {
    auto together = free_of(structure, degrees, candidate.node);
    if (degrees.several_normals.contains(candidate.node)) {
      for (int axis = 0; axis < structure.dimension; ++axis) {
        for (const auto& part : candidate_displacement<double>(degrees, candidate, axis))
          together.push_back(part.number);
      }
    }
    connections.join(together);
  }
  std::vector<support::IndexSet> blocks;
  std::map<std::size_t, std::size_t> place;  // block of each representative
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const int first = free_of(structure, degrees, structure.contact[i].node).front();
    const auto [entry, is_new] = place.emplace(connections.representative(first), blocks.size());
    if (is_new) blocks.emplace_back();
    blocks[entry->second].insert(static_cast<int>(i));
  }
  return blocks;
}

}  // namespace kusabi::problems
