// Ranges of positive numbers, and the widest of them.
#include "problems/wedged/scale_ratio.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::problems {
namespace {

class Range {
 public:
  void add(double value) {
    if (!(value > 0)) return;
    minimum_ = std::min(minimum_, value);
    maximum_ = std::max(maximum_, value);
  }
  [[nodiscard]] double ratio() const { return maximum_ > 0 ? maximum_ / minimum_ : 1; }

 private:
  double minimum_ = std::numeric_limits<double>::infinity();
  double maximum_ = 0;
};

double distance(const Structure& structure, int a, int b) {
  return (structure.coordinates.col(a) - structure.coordinates.col(b)).norm();
}

/// The largest distance of two nodes of an element.
double size_of(const Structure& structure, std::span<const int> nodes) {
  double size = 0;
  for (const int node : nodes) size = std::max(size, distance(structure, nodes.front(), node));
  return size;
}

double stiffness_ratio(const Structure& structure) {
  Range stiffnesses;
  for (const Member& member : structure.members)
    stiffnesses.add(member.axial_stiffness / distance(structure, member.first, member.second));
  for (const Element& element : structure.elements) {
    const double depth =
        structure.dimension == 2 ? element.thickness : size_of(structure, element.nodes);
    stiffnesses.add(element.modulus * depth);
  }
  for (const Spring& spring : structure.springs) stiffnesses.add(spring.stiffness);
  return stiffnesses.ratio();
}

double compliance_ratio(const WedgedProblem& problem) {
  double maximum = 1;
  for (const auto& block : blocks_of(problem)) {
    Range compliances;
    for (const int candidate : block) {
      const Eigen::Index normal = problem.dimension * candidate;
      compliances.add(problem.compliance.matrix(normal, normal));
    }
    maximum = std::max(maximum, compliances.ratio());
  }
  return maximum;
}

/// Ratio for one body: `within` marks its nodes.
double extent_ratio(const Structure& structure, const UnconstrainedBody& body,
                    const std::vector<bool>& within) {
  Range distances;
  for (const int node : body.nodes) distances.add(distance(structure, body.nodes.front(), node));
  const auto own = [&](int node) { return within[static_cast<std::size_t>(node)]; };
  for (const Member& member : structure.members)
    if (own(member.first) || own(member.second))
      distances.add(distance(structure, member.first, member.second));
  for (const Element& element : structure.elements) {
    if (!own(element.nodes.front())) continue;
    for (const int a : element.nodes)
      for (const int b : element.nodes) distances.add(distance(structure, a, b));
  }
  std::vector<int> touching;
  for (const ContactCandidate& candidate : structure.contact) {
    if (own(candidate.node)) touching.push_back(candidate.node);
    for (const WeightedNode& share : candidate.against)
      if (own(share.node)) touching.push_back(share.node);
  }
  for (const int a : touching)
    for (const int b : touching) distances.add(distance(structure, a, b));
  return distances.ratio();
}

}  // namespace

double scale_ratio(const CheckedStructure& structure, const WedgedProblem& problem) {
  double maximum = std::max(stiffness_ratio(structure), compliance_ratio(problem));
  for (const UnconstrainedBody& body : structure.unconstrained_bodies()) {
    std::vector<bool> within(structure->node_names.size(), false);
    for (const int node : body.nodes) within[static_cast<std::size_t>(node)] = true;
    maximum = std::max(maximum, extent_ratio(structure, body, within));
  }
  return maximum;
}

}  // namespace kusabi::problems
