// A spring of equal stiffness along each axis of an orthonormal frame is a multiple of the unit
// matrix.
#include "verify/structure/enclosed_problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/structure/assembly.hpp"

namespace kusabi::verify {
namespace {

double distance(const Structure& structure, std::size_t a, std::size_t b) {
  double sum = 0;
  for (std::size_t axis = 0; axis < structure.dimension; ++axis)
    sum += std::pow(structure.coordinates[a][axis] - structure.coordinates[b][axis], 2);
  return std::sqrt(sum);
}

}  // namespace

double typical_stiffness(const Structure& structure) {
  double largest = 0;
  for (const auto& bar : structure.bars) {
    largest = std::max(largest, bar.axial_stiffness / distance(structure, bar.first, bar.second));
  }
  for (const auto& element : structure.elements) {
    const double size = structure.dimension == 2
                            ? element.thickness
                            : distance(structure, element.nodes[0], element.nodes[1]);
    largest = std::max(largest, element.modulus * size);
  }
  for (const auto& stiffness : structure.given) {
    for (const auto& [row, column, value] : stiffness.entries) {
      if (row == column && stiffness.rows[row].node) largest = std::max(largest, value);
    }
  }
  return largest > 0 && std::isfinite(largest) ? std::exp2(std::round(std::log2(largest))) : 1;
}

namespace {

std::variant<LoadedEnclosure, std::string> enclosed(const Structure& structure,
                                                    const std::vector<ForceList>& loads,
                                                    const support::LongWork& work) {
  auto modes = unconstrained_modes(structure);
  const bool constrained = modes.of_candidates.count == 0 && modes.others.empty();
  auto grounded = structure;
  const double stiffness = typical_stiffness(structure);
  if (!constrained) {
    for (auto spring : modes.others) {
      spring.stiffness = stiffness;
      grounded.springs.push_back(spring);
    }
  }
  auto found = loaded_stiffness(grounded, loads, constrained ? 0 : stiffness, work);
  if (auto* why = std::get_if<std::string>(&found)) return std::move(*why);
  auto& [matrix, condensed] = std::get<LoadedStiffness>(found);
  if (!constrained) {
    const auto size = matrix.middle.size;
    std::vector<double> springs(size * size, 0);
    for (std::size_t k = 0; k < size; ++k) springs[size * k + k] = -stiffness;
    matrix.middle.entries += DyadicList(springs);
  }
  LoadedEnclosure result{{std::move(matrix), std::move(modes.of_candidates)}, {}};
  if (loads.empty()) return result;
  auto works = works_of(structure, result.problem.motions, loads);
  const Freedom freedom(structure);
  for (std::size_t load = 0; load < loads.size(); ++load) {
    result.loads.push_back({std::move(condensed[load]), std::move(works[load]),
                            touched(structure, freedom, loads[load])});
  }
  return result;
}

}  // namespace

std::variant<EnclosedProblem, std::string> enclosed_problem(const Structure& structure,
                                                            const support::LongWork& work) {
  auto found = enclosed(structure, {}, work);
  if (auto* why = std::get_if<std::string>(&found)) return std::move(*why);
  return std::move(std::get<LoadedEnclosure>(found).problem);
}

std::variant<LoadedEnclosure, std::string> enclosed_loads(const Structure& structure,
                                                          const support::LongWork& work) {
  return enclosed(structure, {structure.dead, structure.reference}, work);
}

}  // namespace kusabi::verify
