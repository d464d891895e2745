// K and F of the wedged problem from a structure, with checks of their accuracy.
#include "problems/wedged/wedged_problem.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include <Eigen/QR>
#include <fmt/format.h>

#include "problems/structure/assembly/contact_frame.hpp"
#include "problems/structure/bodies/grounding_springs.hpp"
#include "problems/structure/bodies/mechanism.hpp"
#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/checks/superelement_check.hpp"
#include "problems/structure/model/truss.hpp"
#include "problems/wedged/contact_blocks.hpp"
#include "problems/wedged/contact_motions.hpp"
#include "problems/wedged/precise_compliance.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::problems {
namespace {

/// Requires contact candidates and axial stiffnesses, which are optional in a structure.
void require_contact_and_stiffness(const Structure& structure) {
  const support::SourcePosition top =
      structure.sources.file.empty() ? support::SourcePosition{} : support::SourcePosition{1, 1};
  if (structure.contact.empty()) {
    throw structure_error(structure, top,
                          "no contact candidates; expected at least one [[contact]] group");
  }
  for (std::size_t index = 0; index < structure.members.size(); ++index) {
    if (structure.members[index].axial_stiffness != 0) continue;
    throw structure_error(
        structure, position_of(structure.sources.axial_stiffnesses, static_cast<int>(index)),
        "a [[members]] group has no EA; expected EA = axial stiffness, a force, or E and A");
  }
}

/// Larger Poisson's ratios are reported as the probable cause of ill-conditioning.
constexpr double almost_incompressible = 0.499;

[[noreturn]] void refuse_condition(const Structure& structure) {
  const auto& elements = structure.elements;
  const auto minimum = std::ranges::max_element(elements, {}, &Element::ratio);
  if (minimum != elements.end() && minimum->ratio > almost_incompressible) {
    const auto index = static_cast<int>(minimum - elements.begin());
    throw structure_error(
        structure, position_of(structure.sources.materials, index),
        fmt::format("nu is {}, almost incompressible, which leaves the stiffness too "
                    "ill-conditioned to compute with; expected nu up to {}, at which elements of "
                    "low order lock already",
                    minimum->ratio, almost_incompressible));
  }
  throw structure_error(
      structure, {},
      fmt::format("the stiffness is too ill-conditioned to compute with; expected {} of similar "
                  "size, and no almost free motion",
                  elements.empty()            ? "axial stiffnesses and lengths"
                  : structure.members.empty() ? "moduli E, thicknesses and elements"
                                              : "axial stiffnesses, moduli, lengths and elements"));
}

void add(support::Fingerprint& fingerprint, const Eigen::MatrixXd& matrix) {
  for (const double value : matrix.reshaped()) fingerprint.add(value);
}

/// Maximum number of rows of K that is computed with F: in 104 bits this takes as long as F itself,
/// and only certificates and exported matrices contain K.
constexpr Eigen::Index max_stored_stiffness = 600;

/// K and F as roundings of the precise values. @param grounded the structure with grounding springs
Compliance compliance_of(const Structure& grounded, const FreeDegrees& degrees,
                         const Eigen::MatrixXd& forces, LoadColumns& loads,
                         const support::LongWork& work) {
  auto [precise, error, response] = enclosed_compliance(grounded, degrees, forces, work);
  if (!(error <= largest_compliance_error)) refuse_condition(grounded);
  if (forces.cols() > 0) {
    const Eigen::Index own = precise.rows() - forces.cols();
    loads.displacements = precise.topRightCorner(own, forces.cols());
    loads.work = precise.bottomRightCorner(forces.cols(), forces.cols());
    loads.sizes = forces.cwiseAbs().colwise().sum().transpose();
    precise.conservativeResize(own, own);
    response.conservativeResize(response.rows(), own);
  }
  Compliance result;
  if (precise.rows() <= max_stored_stiffness)
    result.stiffness = stiffness_of(precise, work).cast<double>();
  result.matrix = precise.cast<double>();
  if (!result.stiffness.allFinite() || !result.matrix.allFinite()) refuse_condition(grounded);
  result.precise = std::move(precise);
  result.precise_error = error;
  result.response = std::make_shared<const numbers::PreciseMatrix>(std::move(response));
  // |F_ij| <= sqrt(F_ii F_jj), so the rounding of an entry is at most half a unit of that.
  result.error = error + 1.01 * numbers::unit_roundoff<double>;
  return result;
}

// Structures without constraints keep their fingerprint.
void add_constraints(const Structure& structure, support::Fingerprint& result) {
  const auto add_place = [&](std::string_view kind, int node,
                             const std::vector<WeightedNode>& place) {
    result.add(kind);
    result.add(node);
    for (const WeightedNode& share : place) {
      result.add(share.node);
      result.add(share.weight);
    }
  };
  for (const ContactCandidate& candidate : structure.contact) {
    if (!candidate.against.empty()) add_place("pair", candidate.node, candidate.against);
  }
  for (const MultiPointConstraint& tie : structure.ties) add_place("tie", tie.node, tie.to);
  for (const InclinedSupport& support : structure.inclined) {
    result.add(std::string_view("inclined"));
    result.add(support.node);
    add(result, support.direction);
  }
}

/// G and the descriptions of the unconstrained bodies.
RigidModes modes_of(const CheckedStructure& structure, const Eigen::MatrixXd& forces,
                    LoadColumns& loads) {
  RigidModes result;
  const auto& bodies = structure.unconstrained_bodies();
  if (bodies.empty()) return result;
  auto [matrix, error, restricted_work, work_on_other_modes] =
      contact_motions(structure, bodies, forces);
  loads.motions = std::move(restricted_work);
  loads.other_modes = std::move(work_on_other_modes);
  result.matrix = matrix.cast<double>();
  result.precise = std::move(matrix);
  result.precise_error = error;
  result.error = error + numbers::unit_roundoff<double>;  // for entries up to 1
  for (const UnconstrainedBody& body : bodies) {
    result.bodies.push_back({structure->node_names[static_cast<std::size_t>(body.nodes.front())],
                             static_cast<int>(body.nodes.size()), described(body)});
  }
  return result;
}

std::uint64_t fingerprint(const Structure& structure, const std::vector<Eigen::MatrixXd>& frames) {
  support::Fingerprint result;
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
  for (const Element& element :
       structure.elements) {  // trusses without elements keep their fingerprint
    for (const int node : element.nodes) result.add(node);
    result.add(element.modulus);
    result.add(element.ratio);
    if (structure.dimension == 2) {
      result.add(element.thickness);
      result.add(static_cast<int>(element.state));
    }
  }
  for (const Spring& spring : structure.springs) {
    result.add(spring.node);
    result.add(spring.axis);
    result.add(spring.stiffness);
  }
  add_constraints(structure, result);
  for (const Superelement& each : structure.superelements) {
    result.add(std::string_view("superelement"));
    for (const auto& [node, axis] : each.rows) {
      result.add(node);
      result.add(axis);
    }
    for (int column = 0; column < static_cast<int>(each.stiffness.outerSize()); ++column) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(each.stiffness, column); entry;
           ++entry) {
        result.add(static_cast<int>(entry.row()));
        result.add(column);
        result.add(entry.value());
      }
    }
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
    sum += problem.compliance.matrix(normal, normal);
  }
  return sum / static_cast<double>(m);
}

double margin_unit(const WedgedProblem& problem) {
  constexpr double min_strain_share = 1e-10;  // of F_nn; rounding leaves less
  const double mean = mean_normal_compliance(problem);
  if (problem.modes.matrix.cols() == 0) return mean;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(problem.modes.matrix);
  const Eigen::MatrixXd modes =
      factors.householderQ() *
      Eigen::MatrixXd::Identity(problem.modes.matrix.rows(), factors.rank());
  Eigen::MatrixXd projected = problem.compliance.matrix;
  projected -= modes * (modes.transpose() * projected);
  const Eigen::MatrixXd removed = projected * modes;
  double sum = 0;
  Eigen::Index count = 0;
  for (Eigen::Index normal = 0; normal < projected.rows(); normal += problem.dimension) {
    sum += projected(normal, normal) - removed.row(normal).dot(modes.row(normal));
    ++count;
  }
  const double own = sum / static_cast<double>(count);
  return own > min_strain_share * mean ? own : mean;
}

std::uint64_t wedged_fingerprint(const Structure& structure) {
  std::vector<Eigen::MatrixXd> frames;
  for (const ContactCandidate& candidate : structure.contact) {
    frames.push_back(contact_frame(candidate));
  }
  return fingerprint(structure, frames);
}

WedgedProblem wedged_problem(const CheckedStructure& structure, const support::LongWork& work) {
  LoadColumns none;
  return wedged_problem(structure, {}, none, work);
}

WedgedProblem wedged_problem(const CheckedStructure& structure, const Eigen::MatrixXd& forces,
                             LoadColumns& loads, const support::LongWork& work) {
  require_contact_and_stiffness(structure);
  const FreeDegrees& degrees = structure.degrees();
  const auto& bodies = structure.unconstrained_bodies();
  const Structure grounded = grounded_structure(structure, degrees, bodies);
  if (structure->superelements.empty()) {
    refuse_mechanism(grounded, degrees);
  } else {
    refuse_unconstrained(grounded, degrees);
  }
  WedgedProblem problem;
  problem.dimension = structure->dimension;
  for (const ContactCandidate& candidate : structure->contact) {
    problem.contact_names.push_back(candidate_name(structure, problem.contact_names.size()));
    problem.frames.push_back(contact_frame(candidate));
    problem.friction.push_back(candidate.friction);
  }
  problem.modes = modes_of(structure, forces, loads);
  problem.compliance = compliance_of(grounded, degrees, forces, loads, work);
  problem.blocks = contact_blocks(structure, degrees, bodies);
  problem.provenance = {.name = structure->name,
                        .units = structure->units,
                        .nodes = static_cast<int>(structure->node_names.size()),
                        .members = static_cast<int>(structure->members.size()),
                        .elements = static_cast<int>(structure->elements.size()),
                        .fingerprint = fingerprint(structure, problem.frames)};
  return problem;
}

}  // namespace kusabi::problems
