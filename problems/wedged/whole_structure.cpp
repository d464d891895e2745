// Forces in bars and elements under unit reactions, summed at the supports.
#include "problems/wedged/whole_structure.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "problems/structure/assembly/contact_frame.hpp"
#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/elongation.hpp"
#include "problems/structure/model/superelement.hpp"
#include "problems/structure/model/truss.hpp"
#include "problems/wedged/contact_motions.hpp"

namespace kusabi::problems {
namespace {

using numbers::Precise;

/// All displacements that are not dependent by multi-point constraints, including fixed ones, by
/// nodes.
FreeDegrees without_supports(Structure structure) {
  for (auto& axes : structure.fixed) axes = {};
  structure.inclined.clear();
  structure.contact.clear();
  return free_degrees(structure);
}

// The displacements of all nodes, (d nodes) x columns, from the free ones.
numbers::PreciseMatrix of_all_nodes(const numbers::PreciseMatrix& free,
                                    const FreeDegrees& degrees) {
  const Eigen::Index d = degrees.number.rows();
  numbers::PreciseMatrix result = numbers::PreciseMatrix::Zero(degrees.number.size(), free.cols());
  for (int node = 0; node < static_cast<int>(degrees.number.cols()); ++node) {
    for (int axis = 0; axis < static_cast<int>(d); ++axis) {
      StrainVector<Precise> parts;
      add_entry(degrees, axis, node, Precise(1.0), parts);
      for (const auto& [number, weight] : parts)
        result.row(d * node + axis) += weight * free.row(number);
    }
  }
  return result;
}

// Adds weight b b^T u for every column u.
void add_forces(const StrainVector<Precise>& vector, const Precise& weight,
                const numbers::PreciseMatrix& displacements, numbers::PreciseMatrix& forces) {
  for (Eigen::Index column = 0; column < displacements.cols(); ++column) {
    Precise strain = 0.0;
    for (const auto& entry : vector) strain += entry.value * displacements(entry.number, column);
    strain *= weight;
    for (const auto& entry : vector) forces(entry.number, column) += entry.value * strain;
  }
}

// Adds the rows of K u, for every column u, that belong to fixed displacements.
void add_forces(const Structure& structure, const FreeDegrees& all, const std::vector<bool>& held,
                const Element& element, const numbers::PreciseMatrix& displacements,
                numbers::PreciseMatrix& forces) {
  const auto parts = element_parts<Precise>(all, element);
  const auto is_held = [&](const ElementPart<Precise>& part) {
    return held[static_cast<std::size_t>(part.number)];
  };
  if (std::ranges::none_of(parts, is_held)) return;
  const auto matrix = element_matrix<Precise>(structure, element);
  for (const auto& row : parts) {
    if (!is_held(row)) continue;
    for (const auto& part : parts) {
      forces.row(row.number) += matrix(row.place, part.place) * (row.weight * part.weight) *
                                displacements.row(part.number);
    }
  }
}

// The same for superelements.
void add_forces(const Structure& structure, const FreeDegrees& all, const std::vector<bool>& held,
                const numbers::PreciseMatrix& displacements, numbers::PreciseMatrix& forces) {
  for (std::size_t index = 0; index < structure.superelements.size(); ++index) {
    for_each_entry<Precise>(structure, all, index, [&](int row, int column, const Precise& value) {
      if (row < all.of_nodes() && held[static_cast<std::size_t>(row)])
        forces.row(row) += value * displacements.row(column);
    });
  }
}

// K u, including springs, for every column u of the displacements of all nodes; for elements and
// superelements only at fixed displacements. Forces on dependent nodes are transferred to their
// masters.
// @param internal_unknowns of superelements, for the same columns
numbers::PreciseMatrix forces_of(const Structure& structure, const FreeDegrees& all,
                                 const std::vector<bool>& held,
                                 const numbers::PreciseMatrix& displacements,
                                 const numbers::PreciseMatrix& internal_unknowns) {
  numbers::PreciseMatrix own(all.size(), displacements.cols());
  for (int i = 0; i < all.of_nodes(); ++i) {
    const auto& place = all.free[static_cast<std::size_t>(i)];
    own.row(i) = displacements.row(structure.dimension * place.node + place.axis);
  }
  own.bottomRows(all.internal_count) = internal_unknowns;
  numbers::PreciseMatrix forces = numbers::PreciseMatrix::Zero(all.size(), own.cols());
  for (const Member& member : structure.members) {
    add_forces(elongation_vector<Precise>(structure, all, member),
               bar_stiffness<Precise>(structure, member), own, forces);
  }
  for (const Spring& spring : structure.springs) {
    add_forces(parts_of<Precise>(all, spring.axis, spring.node), Precise(spring.stiffness), own,
               forces);
  }
  for (const Element& element : structure.elements)
    add_forces(structure, all, held, element, own, forces);
  add_forces(structure, all, held, own, forces);
  return forces;
}

// EA / L times the elongation of each member, for every column of the displacements of all nodes.
numbers::PreciseMatrix axial_forces_of(const Structure& structure,
                                       const numbers::PreciseMatrix& displacements) {
  const Eigen::Index d = structure.dimension;
  const auto count = static_cast<Eigen::Index>(structure.members.size());
  numbers::PreciseMatrix forces = numbers::PreciseMatrix::Zero(count, displacements.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    const Member& member = structure.members[static_cast<std::size_t>(i)];
    const auto along = extent<Precise>(structure, member);
    const Precise weight = bar_stiffness<Precise>(structure, member) / along.stableNorm();
    for (Eigen::Index axis = 0; axis < d; ++axis) {
      forces.row(i) += weight * along(axis) *
                       (displacements.row(d * member.second + axis) -
                        displacements.row(d * member.first + axis));
    }
  }
  return forces;
}

}  // namespace

WholeStructure::WholeStructure(const CheckedStructure& structure, const WedgedProblem& problem)
    : dimension_(structure->dimension), coordinates_(structure->coordinates) {
  const FreeDegrees& degrees = structure.degrees();
  const auto displacements = of_all_nodes(*problem.compliance.response, degrees);
  displacements_ = displacements.cast<double>();
  axial_forces_ = axial_forces_of(structure, displacements).cast<double>();
  contact_forces_.setZero(displacements.rows(), displacements.cols());
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < structure->contact.size(); ++i, column += dimension_) {
    const ContactCandidate& candidate = structure->contact[i];
    const auto at = [&](int node) {
      return contact_forces_.block(dimension_ * node, column, dimension_, dimension_);
    };
    at(candidate.node) += problem.frames[i];
    for (const auto& [node, weight] : candidate.against) at(node) -= weight * problem.frames[i];
  }
  set_reactions(structure, displacements,
                problem.compliance.response->bottomRows(degrees.internal_count));
  set_motions(structure, problem);
}

// Support reactions and spring forces, without the contact forces.
// @param internal_unknowns of superelements, under each unit reaction
void WholeStructure::set_reactions(const Structure& structure,
                                   const numbers::PreciseMatrix& displacements,
                                   const numbers::PreciseMatrix& internal_unknowns) {
  const auto all = without_supports(structure);
  auto fixed = structure.fixed;
  for (const InclinedSupport& support : structure.inclined)
    fixed[static_cast<std::size_t>(support.node)] = {true, true, true};
  std::vector<bool> held;
  for (const auto& [node, axis] : all.free)
    held.push_back(fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(axis)]);
  const Eigen::MatrixXd internal =
      forces_of(structure, all, held, displacements, internal_unknowns).cast<double>();
  support_forces_.setZero(displacements.rows(), displacements.cols());
  for (const auto& axes : fixed)
    supported_.push_back(axes[0] || axes[1] || (dimension_ == 3 && axes[2]));
  for (int number = 0; number < all.of_nodes(); ++number) {
    if (!held[static_cast<std::size_t>(number)]) continue;
    const auto& [node, axis] = all.free[static_cast<std::size_t>(number)];
    const Eigen::Index row = dimension_ * node + axis;
    support_forces_.row(row) = internal.row(number) - contact_forces_.row(row);
  }
  for (const Spring& spring : structure.springs) {
    const Eigen::Index row = dimension_ * spring.node + spring.axis;
    support_forces_.row(row) -= spring.stiffness * displacements_.row(row);
    supported_[static_cast<std::size_t>(spring.node)] = true;
  }
}

void WholeStructure::set_motions(const CheckedStructure& structure, const WedgedProblem& problem) {
  const auto& bodies = structure.unconstrained_bodies();
  if (bodies.empty()) return;
  compliance_ = problem.compliance.matrix;
  const Eigen::MatrixXd restricted = restricted_modes(structure, bodies).cast<double>();
  restricted_modes_.compute(restricted);
  motions_.setZero(displacements_.rows(), restricted.cols());
  Eigen::Index column = 0;
  for (const UnconstrainedBody& body : bodies) {
    for (const int node : body.nodes) {
      motions_.block(dimension_ * node, column, dimension_, body.count()) =
          problems::displacements(body, structure->coordinates.col(node)).cast<double>();
    }
    column += body.count();
  }
}

WholeState WholeStructure::under(std::span<const double> reactions,
                                 std::span<const double> displacements) const {
  const Eigen::Map<const Eigen::VectorXd> r(reactions.data(),
                                            static_cast<Eigen::Index>(reactions.size()));
  WholeState state;
  Eigen::VectorXd everywhere = displacements_ * r;
  if (motions_.cols() > 0 && !displacements.empty()) {
    // u = F r + G alpha with the least-squares alpha, since modes that displace no candidate are
    // arbitrary.
    const Eigen::Map<const Eigen::VectorXd> u(displacements.data(), r.size());
    everywhere += motions_ * restricted_modes_.solve(u - compliance_ * r);
  }
  state.displacements = everywhere.reshaped(dimension_, coordinates_.cols());
  state.reactions = (support_forces_ * r).reshaped(dimension_, coordinates_.cols());
  state.axial_forces = axial_forces_ * r;
  const double sizes =
      state.reactions.cwiseAbs().sum() + (contact_forces_.cwiseAbs() * r.cwiseAbs()).sum();
  state.imbalance = imbalance(state.reactions + contact_forces(reactions), sizes);
  return state;
}

Eigen::MatrixXd WholeStructure::contact_forces(std::span<const double> reactions) const {
  const Eigen::Map<const Eigen::VectorXd> r(reactions.data(),
                                            static_cast<Eigen::Index>(reactions.size()));
  return (contact_forces_ * r).reshaped(dimension_, coordinates_.cols());
}

bool WholeStructure::is_supported(int node) const {
  return supported_[static_cast<std::size_t>(node)];
}

double WholeStructure::imbalance(const Eigen::MatrixXd& forces, double sizes) const {
  if (sizes == 0) return 0;
  double worst = forces.rowwise().sum().cwiseAbs().maxCoeff();
  const Eigen::MatrixXd arms = coordinates_.colwise() - coordinates_.rowwise().mean();
  const double size = arms.cwiseAbs().maxCoeff();
  for (int first = 0; size > 0 && first < dimension_; ++first) {
    for (int second = first + 1; second < dimension_; ++second) {
      const double moment = (arms.row(first).cwiseProduct(forces.row(second)) -
                             arms.row(second).cwiseProduct(forces.row(first)))
                                .sum();
      worst = std::max(worst, std::abs(moment) / size);
    }
  }
  return worst / sizes;
}

}  // namespace kusabi::problems
