// Rollers are released, and loads are the displacements of one more candidate.
#include "verify/structure/candidate_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/structure/enclosed_problem.hpp"

namespace kusabi::verify {
namespace {

class CandidateNumbering {
 public:
  CandidateNumbering(const Structure& structure, std::span<const ForceList> loads, double springs)
      : structure_(structure),
        loads_(loads),
        springs_(springs),
        rows_{.freedom = Freedom(structure)} {
    rows_.stiffness = enclosed_stiffness(structure_, rows_.freedom);
  }

  CandidateRows result();

 private:
  void add_loads();
  void release_rollers(const ContactPoint& point);

  const Structure& structure_;
  std::span<const ForceList> loads_;
  double springs_;
  CandidateRows rows_;
};

// Adds a grounding spring, without coupling, for a displacement of a candidate that a roller
// prevents, so that K has d rows for each candidate. It is as stiff as the node along the axis
// nearest to its normal. The roller takes the reaction of the obstacle along this displacement
// (docs/theory/wedged.md, "Rollers at candidates").
void CandidateNumbering::release_rollers(const ContactPoint& point) {
  auto& numbers = rows_.freedom.number[point.node];
  const auto normal = numbers[largest_component_axis(point.normal)];
  for (std::size_t axis = 0; axis < structure_.dimension; ++axis) {
    if (numbers[axis] != Freedom::none) continue;
    const auto spring = rows_.stiffness[normal][normal];
    numbers[axis] = rows_.freedom.count++;
    rows_.stiffness.emplace_back()[numbers[axis]] = spring;
  }
}

// A load is a row of K^0, H'f, and stays with the candidates: condensed with them it becomes E'f.
// Forces are scaled by powers of two to the size of the stiffness. Loads are the
// displacements of one more candidate.
void CandidateNumbering::add_loads() {
  const double size = typical_stiffness(structure_);
  for (std::size_t load = 0; load < structure_.dimension; ++load) {
    const auto row = rows_.freedom.count++;
    rows_.stiffness.emplace_back()[row] = Enclosure(size);
    rows_.loads.push_back(row);
    if (load >= loads_.size()) continue;
    double largest = 0;
    for (const auto& force : loads_[load]) {
      for (const double component : force.components)
        largest = std::max(largest, std::abs(component));
    }
    const int scale = largest == 0 ? 0 : std::ilogb(size) - std::ilogb(largest);
    rows_.load_scales.push_back(scale);
    for (const auto& [node, components] : loads_[load]) {
      for (std::size_t axis = 0; axis < structure_.dimension; ++axis) {
        const Enclosure force(Dyadic(components[axis]).scaled(scale));
        if (force.is_zero()) continue;
        for (const auto& [number, weight] : rows_.freedom.weighted(node, axis)) {
          rows_.stiffness[row][number] += force * weight;
          rows_.stiffness[number][row] += force * weight;
        }
      }
    }
  }
}

// A candidate alone at its node has the displacements of the node. Rollers are released before
// normal coordinates are introduced, since the opposite place may be at a node with several contact
// normals.
CandidateRows CandidateNumbering::result() {
  if (!loads_.empty()) add_loads();
  const auto shared = shared_nodes(structure_);
  const auto add_springs = [&](const auto& numbers) {
    for (const auto number : numbers) {
      if (springs_ != 0 && number != Freedom::none)
        rows_.stiffness[number][number] += Enclosure(springs_);
    }
  };
  for (const auto& point : structure_.contact) {
    if (shared.contains(point.node)) continue;
    add_springs(rows_.freedom.number[point.node]);
  }
  for (const auto& point : structure_.contact) {
    if (!shared.contains(point.node)) release_rollers(point);
  }
  rows_.shared = use_normal_coordinates(structure_, rows_.freedom, rows_.stiffness);
  for (const auto& [candidate, numbers] : rows_.shared) add_springs(numbers);
  const auto d = static_cast<std::ptrdiff_t>(structure_.dimension);
  for (std::size_t i = 0; i < structure_.contact.size(); ++i) {
    const auto found = rows_.shared.find(i);
    const auto& numbers = rows_.freedom.number[structure_.contact[i].node];
    rows_.seen.push_back(found != rows_.shared.end()
                             ? found->second
                             : std::vector<std::size_t>(numbers.begin(), numbers.begin() + d));
  }
  if (!rows_.loads.empty()) rows_.seen.push_back(rows_.loads);
  return std::move(rows_);
}

}  // namespace

CandidateRows candidate_rows(const Structure& structure, std::span<const ForceList> loads,
                             double springs) {
  return CandidateNumbering(structure, loads, springs).result();
}

}  // namespace kusabi::verify
