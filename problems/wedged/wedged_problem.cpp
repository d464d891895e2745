// From a structure to K and F of the wedged problem, with the checks that they deserve the name.
#include "problems/wedged/wedged_problem.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/contact_frame.hpp"
#include "problems/structure/mechanism.hpp"
#include "problems/structure/structure_check.hpp"
#include "problems/structure/truss.hpp"
#include "problems/wedged/contact_blocks.hpp"
#include "problems/wedged/precise_compliance.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::problems {
namespace {

/// The wedged problem needs two things that a structure may be without.
void require_contact_and_stiffness(const Structure& structure) {
  const support::SourcePosition top =
      structure.sources.file.empty() ? support::SourcePosition{} : support::SourcePosition{1, 1};
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

void add(support::Fingerprint& fingerprint, const Eigen::MatrixXd& matrix) {
  for (const double value : matrix.reshaped()) fingerprint.add(value);
}

/// K and F, each the rounding of its precise value.
void set_compliance(WedgedProblem& problem, const Structure& structure) {
  auto [precise, error, response] = enclosed_compliance(structure);
  if (!(error <= largest_compliance_error)) refuse_condition(structure);
  problem.stiffness = stiffness_of(precise).cast<double>();
  problem.compliance = precise.cast<double>();
  if (!problem.stiffness.allFinite() || !problem.compliance.allFinite())
    refuse_condition(structure);
  problem.precise_compliance = std::move(precise);
  problem.precise_error = error;
  problem.response = std::make_shared<const numbers::PreciseMatrix>(std::move(response));
  // |F_ij| <= sqrt(F_ii F_jj), so half a unit in the last place of an entry is no more of that.
  problem.compliance_error = error + 1.01 * numbers::unit_roundoff<double>;
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
  set_compliance(problem, structure);
  problem.blocks = contact_blocks(structure, degrees);
  problem.nodes = static_cast<int>(structure.node_names.size());
  problem.members = static_cast<int>(structure.members.size());
  problem.elements = static_cast<int>(structure.elements.size());
  problem.fingerprint = fingerprint(structure, problem.frames);
  return problem;
}

}  // namespace kusabi::problems
