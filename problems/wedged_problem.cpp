// From a structure to K and F of the wedged problem, with the checks that they deserve the name.
#include "problems/wedged_problem.hpp"

#include <algorithm>
#include <cstddef>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "problems/condensation.hpp"
#include "problems/contact_frame.hpp"
#include "problems/fingerprint.hpp"
#include "problems/mechanism.hpp"
#include "problems/quadrilateral.hpp"
#include "problems/structure_check.hpp"
#include "problems/truss.hpp"

namespace kusabi::problems {
namespace {

/// The wedged problem needs two things that a structure may be without.
void require_contact_and_stiffness(const Structure& structure) {
  const SourcePosition top =
      structure.sources.file.empty() ? SourcePosition{} : SourcePosition{1, 1};
  if (structure.contact.empty()) {
    throw structure_error(structure, top,
                          "no contact candidates; expected at least one [[contact]] group");
  }
  for (std::size_t index = 0; index < structure.members.size(); ++index) {
    if (structure.members[index].axial_stiffness != 0) continue;
    throw structure_error(structure,
                          position_of(structure.sources.axial_stiffnesses, static_cast<int>(index)),
                          "a [[members]] group has no EA; expected EA = axial stiffness, a force");
  }
}

[[noreturn]] void refuse_condition(const Structure& structure) {
  throw structure_error(structure, {},
                        "the stiffness is too ill-conditioned to compute with; expected axial "
                        "stiffnesses and lengths of similar size, and no almost free motion");
}

/// Numbers of the free displacements of the contact nodes, candidate by candidate.
std::vector<int> contact_places(const Structure& structure, const FreeDegrees& degrees) {
  std::vector<int> places;
  for (const ContactCandidate& candidate : structure.contact) {
    for (int axis = 0; axis < structure.dimension; ++axis) {
      places.push_back(degrees.number(axis, candidate.node));
    }
  }
  return places;
}

Eigen::MatrixXd block_diagonal(const std::vector<Eigen::MatrixXd>& frames, int dimension) {
  const Eigen::Index size = dimension * static_cast<Eigen::Index>(frames.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
  Eigen::Index start = 0;
  for (const Eigen::MatrixXd& frame : frames) {
    result.block(start, start, dimension, dimension) = frame;
    start += dimension;
  }
  return result;
}

Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd& matrix) {
  return (matrix + matrix.transpose()) / 2.0;
}

/// Whether the two halves of a matrix differ by rounding only, relative to its largest entry.
bool is_symmetric(const Eigen::MatrixXd& matrix) {
  return (matrix - matrix.transpose()).cwiseAbs().maxCoeff() <=
         inverse_tolerance * matrix.cwiseAbs().maxCoeff();
}

/// Every comparison is written so that NaN fails it.
bool is_sound(const CondensedMatrices& matrices) {
  if (!is_symmetric(matrices.stiffness) || !is_symmetric(matrices.compliance)) return false;
  const Eigen::Index size = matrices.stiffness.rows();
  const Eigen::MatrixXd residual =
      matrices.stiffness * matrices.compliance - Eigen::MatrixXd::Identity(size, size);
  if (!(residual.cwiseAbs().maxCoeff() <= inverse_tolerance)) return false;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric_part(matrices.stiffness),
                                                              Eigen::EigenvaluesOnly);
  return solver.info() == Eigen::Success &&
         solver.eigenvalues().minCoeff() > definite_tolerance * solver.eigenvalues().maxCoeff();
}

Eigen::SparseMatrix<double> whole_stiffness(const Structure& structure,
                                            const FreeDegrees& degrees) {
  Eigen::SparseMatrix<double> members =
      truss_stiffness(structure, degrees, member_stiffnesses(structure));
  if (structure.elements.empty()) return members;
  return members + element_stiffness(structure, degrees);
}

/// K and F, checked, then made symmetric to the last bit.
CondensedMatrices condensed(const Structure& structure, const FreeDegrees& degrees,
                            const std::vector<Eigen::MatrixXd>& frames) {
  const auto matrices =
      condense(whole_stiffness(structure, degrees), contact_places(structure, degrees),
               block_diagonal(frames, structure.dimension));
  if (!matrices || !is_sound(*matrices)) refuse_condition(structure);
  return {symmetric_part(matrices->stiffness), symmetric_part(matrices->compliance)};
}

void add(Fingerprint& fingerprint, const Eigen::MatrixXd& matrix) {
  for (const double value : matrix.reshaped()) fingerprint.add(value);
}

std::uint64_t fingerprint(const Structure& structure, const std::vector<Eigen::MatrixXd>& frames) {
  Fingerprint result;
  result.add(structure.dimension);
  result.add(structure.units.length);
  result.add(structure.units.force);
  result.add(static_cast<int>(structure.node_names.size()));
  add(result, structure.coordinates);
  result.add(static_cast<int>(structure.members.size()));
  for (const Member& member : structure.members) {
    result.add(member.first);
    result.add(member.second);
    result.add(member.axial_stiffness);
  }
  for (const auto& axes : structure.fixed) {
    for (int axis = 0; axis < structure.dimension; ++axis) {
      result.add(axes[static_cast<std::size_t>(axis)] ? 1 : 0);
    }
  }
  result.add(static_cast<int>(structure.contact.size()));
  for (const ContactCandidate& candidate : structure.contact) {
    result.add(candidate.node);
    result.add(candidate.friction);
  }
  for (const Eigen::MatrixXd& frame : frames) add(result, frame);
  for (const Quadrilateral& element : structure.elements) {  // none: the number of a truss stays
    for (const int node : element.nodes) result.add(node);
    result.add(element.modulus);
    result.add(element.ratio);
    result.add(element.thickness);
    result.add(static_cast<int>(element.state));
  }
  return result.value();
}

}  // namespace

bool uniform_friction(const WedgedProblem& problem) {
  return std::all_of(problem.friction.begin(), problem.friction.end(),
                     [](double friction) { return friction == 1; });
}

double mean_normal_compliance(const WedgedProblem& problem) {
  const auto m = static_cast<Eigen::Index>(problem.contact_names.size());
  double sum = 0;
  for (Eigen::Index i = 0; i < m; ++i) {
    const Eigen::Index normal = problem.dimension * i;
    sum += problem.compliance(normal, normal);
  }
  return sum / static_cast<double>(m);
}

std::uint64_t wedged_fingerprint(const Structure& structure) {
  std::vector<Eigen::MatrixXd> frames;
  for (const ContactCandidate& candidate : structure.contact) {
    frames.push_back(contact_frame(candidate));
  }
  return fingerprint(structure, frames);
}

WedgedProblem wedged_problem(const Structure& structure) {
  check_structure(structure);
  require_contact_and_stiffness(structure);
  const FreeDegrees degrees = free_degrees(structure);
  refuse_mechanism(structure, degrees);
  WedgedProblem problem;
  problem.name = structure.name;
  problem.dimension = structure.dimension;
  problem.units = structure.units;
  for (const ContactCandidate& candidate : structure.contact) {
    problem.contact_names.push_back(structure.node_names[static_cast<std::size_t>(candidate.node)]);
    problem.frames.push_back(contact_frame(candidate));
    problem.friction.push_back(candidate.friction);
  }
  CondensedMatrices matrices = condensed(structure, degrees, problem.frames);
  problem.stiffness = std::move(matrices.stiffness);
  problem.compliance = std::move(matrices.compliance);
  problem.nodes = static_cast<int>(structure.node_names.size());
  problem.members = static_cast<int>(structure.members.size());
  problem.elements = static_cast<int>(structure.elements.size());
  problem.fingerprint = fingerprint(structure, problem.frames);
  return problem;
}

}  // namespace kusabi::problems
