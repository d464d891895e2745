// The forces in bars and elements under unit reactions, summed up at the supports.
#include "problems/wedged/whole_structure.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "problems/structure/contact_frame.hpp"
#include "problems/structure/elongation.hpp"
#include "problems/structure/quadrilateral.hpp"
#include "problems/structure/truss.hpp"

namespace kusabi::problems {
namespace {

using numbers::Precise;

/// All displacements, fixed ones included, node by node.
FreeDegrees all_degrees(Structure structure) {
  for (auto& axes : structure.fixed) axes = {};
  return free_degrees(structure);
}

// The rows of a matrix over the free displacements, at their places among all.
numbers::PreciseMatrix among_all(const numbers::PreciseMatrix& free, const FreeDegrees& degrees,
                                 const FreeDegrees& all) {
  numbers::PreciseMatrix result = numbers::PreciseMatrix::Zero(all.size(), free.cols());
  for (int i = 0; i < degrees.size(); ++i) {
    const auto& place = degrees.free[static_cast<std::size_t>(i)];
    result.row(all.number(place.axis, place.node)) = free.row(i);
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

// K^0 u for every column u.
numbers::PreciseMatrix forces_of(const Structure& structure, const FreeDegrees& all,
                                 const numbers::PreciseMatrix& displacements) {
  numbers::PreciseMatrix forces =
      numbers::PreciseMatrix::Zero(displacements.rows(), displacements.cols());
  for (const Member& member : structure.members) {
    add_forces(elongation_vector<Precise>(structure, all, member),
               bar_stiffness<Precise>(structure, member), displacements, forces);
  }
  for (const Quadrilateral& element : structure.elements) {
    for (const auto& vector : strain_vectors<Precise>(structure, all, element)) {
      add_forces(vector, Precise(1.0), displacements, forces);
    }
  }
  return forces;
}

}  // namespace

WholeStructure::WholeStructure(const Structure& structure, const WedgedProblem& problem)
    : dimension_(structure.dimension), coordinates_(structure.coordinates) {
  const auto all = all_degrees(structure);
  const auto displacements = among_all(*problem.response, free_degrees(structure), all);
  displacements_ = displacements.cast<double>();
  internal_forces_ = forces_of(structure, all, displacements).cast<double>();
  for (std::size_t node = 0; node < structure.fixed.size(); ++node) {
    bool any = false;
    for (int axis = 0; axis < dimension_; ++axis) {
      const bool fixed = structure.fixed[node][static_cast<std::size_t>(axis)];
      any = any || fixed;
      if (!fixed) internal_forces_.row(all.number(axis, static_cast<int>(node))).setZero();
    }
    supported_.push_back(any);
  }
  contact_forces_.setZero(all.size(), displacements_.cols());
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    contact_forces_.block(dimension_ * structure.contact[i].node, column, dimension_, dimension_) =
        problem.frames[i];
    column += dimension_;
  }
}

WholeState WholeStructure::under(std::span<const double> reactions) const {
  const Eigen::Map<const Eigen::VectorXd> r(reactions.data(),
                                            static_cast<Eigen::Index>(reactions.size()));
  const auto by_node = [this](const Eigen::VectorXd& values) -> Eigen::MatrixXd {
    return values.reshaped(dimension_, coordinates_.cols());
  };
  WholeState state;
  state.displacements = by_node(displacements_ * r);
  state.reactions = by_node(internal_forces_ * r);
  state.imbalance = imbalance(state.reactions + by_node(contact_forces_ * r));
  return state;
}

bool WholeStructure::is_supported(int node) const {
  return supported_[static_cast<std::size_t>(node)];
}

double WholeStructure::imbalance(const Eigen::MatrixXd& forces) const {
  const double all = forces.cwiseAbs().sum();
  if (all == 0) return 0;
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
  return worst / all;
}

}  // namespace kusabi::problems
