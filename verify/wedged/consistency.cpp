// Comparisons of a certificate with a structure, the inexpensive ones first.
#include "verify/wedged/consistency.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <optional>

#include "support/one_line.hpp"
#include "verify/arithmetic/least_squares.hpp"
#include "verify/structure/assembly.hpp"
#include "verify/structure/enclosed_problem.hpp"

namespace kusabi::verify {
namespace {

// In any locale with a decimal point.
std::string text_of(double value) {
  constexpr int digits = 10;
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value,
                                          std::chars_format::general, digits);
  return {text.data(), end};
}

std::optional<std::string> other_candidates(const Certificate& certificate,
                                            const Structure& structure) {
  if (certificate.dimension != structure.dimension) {
    return "the certificate has dimension " + std::to_string(certificate.dimension) +
           ", the structure " + std::to_string(structure.dimension);
  }
  if (certificate.candidates() != structure.contact.size()) {
    return "the certificate has " + std::to_string(certificate.candidates()) +
           " contact candidates, the structure has " + std::to_string(structure.contact.size());
  }
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const auto name = support::on_one_line(name_of(structure, i));
    if (name != certificate.names[i]) {
      return "contact candidate " + std::to_string(i + 1) + " of the certificate is " +
             certificate.names[i] + ", that of the structure " + name;
    }
  }
  return {};
}

// The common coefficient mu with mu_i = mu times the relative friction, up to rounding.
std::variant<double, std::string> common_friction(const Certificate& certificate,
                                                  const Structure& structure) {
  constexpr double roundings = 0x1p-50;
  std::optional<double> mu;
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const double relative = structure.contact[i].friction;
    const double own = certificate.friction[i];
    if (!mu && relative != 0) mu = own / relative;
    const double expected = mu.value_or(0) * relative;
    if (!(std::abs(own - expected) <= roundings * expected)) {
      return "the friction at " + certificate.names[i] + " is " + text_of(own) +
             ", but with the relative frictions of the structure expected to be " +
             text_of(expected) + ", as at the candidates before";
    }
  }
  return mu.value_or(0);
}

std::optional<std::string> other_blocks(const Certificate& certificate,
                                        const Structure& structure) {
  const auto piece = pieces(structure, Freedom(structure));
  for (const auto& block : certificate.blocks) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (block.contains(static_cast<int>(i)) != block.contains(static_cast<int>(piece[i]))) {
        return certificate.names[piece[i]] + " and " + certificate.names[i] +
               " are in different blocks, but the structure connects them";
      }
    }
  }
  return {};
}

// All candidates of an unconstrained body are in one block, since its rigid-body modes couple them.
std::optional<std::string> other_bodies(const Certificate& certificate,
                                        const ContactMotions& motions) {
  for (std::size_t k = 0; k < motions.count; ++k) {
    support::IndexSet moving;
    for (std::size_t row = 0; row < motions.rows.size(); ++row) {
      if (sgn(motions.rows[row][k]) != 0)
        moving.insert(static_cast<int>(row / certificate.dimension));
    }
    for (const auto& block : certificate.blocks) {
      if (block.meets(moving) && !block.includes(moving)) {
        return certificate.names_of(moving) +
               " are in different blocks, but on one unconstrained body";
      }
    }
  }
  return {};
}

// Each rigid-body mode of the certificate is a combination of those of the structure, and their
// number is equal.
std::optional<std::string> other_motions(const Certificate& certificate,
                                         const ContactMotions& motions) {
  const auto p = motions.count;
  if (certificate.motions != p) {
    return "the certificate has " + std::to_string(certificate.motions) +
           " rigid-body modes of unconstrained bodies, the structure has " + std::to_string(p);
  }
  const auto own = motions.nearest();
  const LeastSquares of_own(own, motions.rows.size());
  for (std::size_t k = 0; k < p; ++k) {
    std::vector<double> column;
    double largest = 0;
    for (std::size_t row = 0; row < motions.rows.size(); ++row) {
      column.push_back(certificate.motion_values[p * row + k]);
      largest = std::max(largest, std::abs(column.back()));
    }
    const auto parts = of_own.solve(column);
    for (std::size_t row = 0; row < column.size(); ++row) {
      double moves = 0;
      for (std::size_t j = 0; parts && j < p; ++j) moves += own[p * row + j] * (*parts)[j];
      // The condition is false for NaN.
      if (!(std::abs(column[row] - moves) <= motion_tolerance * largest)) {
        return "its motion " + std::to_string(k + 1) +
               " is not a rigid-body mode of the "
               "structure: it strains at " +
               certificate.names[row / certificate.dimension];
      }
    }
  }
  return {};
}

std::string direction_name(const Certificate& certificate, std::size_t displacement) {
  constexpr std::array<const char*, 3> kinds{"n", "t1", "t2"};
  const auto d = certificate.dimension;
  return certificate.names[displacement / d] + " (" +
         (d == 2 && displacement % d == 1 ? "t" : kinds[displacement % d]) + ")";
}

// By candidate: a lower bound of the scale for comparisons, since K of an unconstrained body may be
// zero where the K of a search has rounding errors.
std::vector<double> min_scales(const Structure& structure, const ContactMotions& motions) {
  const double root = std::sqrt(typical_stiffness(structure));
  std::vector<double> scales(structure.contact.size(), 0.0);
  for (std::size_t row = 0; row < motions.rows.size(); ++row) {
    const auto& moves = motions.rows[row];
    if (std::any_of(moves.begin(), moves.end(), [](const auto& value) { return sgn(value) != 0; }))
      scales[row / structure.dimension] = root;
  }
  return scales;
}

std::optional<std::string> other_stiffness(const Certificate& certificate,
                                           const EnclosedMatrix& stiffness,
                                           const std::vector<double>& min_scale) {
  const auto d = certificate.dimension;
  const auto size = certificate.displacements();
  const auto& entries = stiffness.middle.entries;
  auto scale = min_scale;
  for (std::size_t i = 0; i < size; ++i) {
    scale[i / d] = std::max(scale[i / d], std::sqrt(entries[size * i + i].nearest()));
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double true_one = entries[size * i + j].nearest();
      const double own = certificate.stiffness[size * i + j];
      // The condition is false for NaN.
      if (!(std::abs(own - true_one) <= stiffness_tolerance * scale[i / d] * scale[j / d])) {
        return "K of the certificate is not that of the structure: between " +
               direction_name(certificate, i) + " and " + direction_name(certificate, j) +
               " it is " + text_of(own) + ", expected " + text_of(true_one);
      }
    }
  }
  return {};
}

// Clearances are part of the proofs, and the same numbers.
std::optional<std::string> other_clearances(const RecordedLoads& loads, const Structure& structure,
                                            const Certificate& certificate) {
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const double own = structure.contact[i].clearance;
    if (loads.clearance[i] != own)
      return "the clearance at " + certificate.names[i] + " is " + text_of(loads.clearance[i]) +
             ", that of the structure " + text_of(own);
  }
  return {};
}

double sum_of(const std::vector<Force>& forces) {
  double sum = 0;
  for (const auto& force : forces)
    for (const double component : force.components) sum += std::abs(component);
  return sum;
}

std::optional<std::string> other_forces(const std::vector<double>& recorded,
                                        const EnclosedLoad& load, const std::vector<Force>& forces,
                                        const char* name, const Certificate& certificate) {
  // A load that no reaction can balance has no equivalent forces at the candidates.
  if (load.work.is_unbalanced()) return {};
  double largest = 0;
  for (std::size_t i = 0; i < recorded.size(); ++i)
    largest = std::max(largest, std::abs(load.condensed.forces[i].nearest()));
  const double carried = carried_by_supports * sum_of(forces);
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    const double own = load.condensed.forces[i].nearest();
    if (!(std::abs(recorded[i] - own) <= load_tolerance * largest + carried))
      return std::string("the ") + name +
             " load of the certificate is not that of the structure: at " +
             direction_name(certificate, i) + " it is " + text_of(recorded[i]) + ", expected " +
             text_of(own);
  }
  return {};
}

// @return of a structure without its loads, or with them
std::variant<LoadedEnclosure, std::string> enclosure_for(const Certificate& certificate,
                                                         const Structure& structure) {
  if (certificate.loads) return enclosed_loads(structure);
  auto problem = enclosed_problem(structure);
  if (auto* why = std::get_if<std::string>(&problem)) return *why;
  return LoadedEnclosure{std::move(std::get<EnclosedProblem>(problem)), {}};
}

}  // namespace

std::variant<ConsistentStructure, std::string> consistency(const Certificate& certificate,
                                                           const Structure& structure) {
  if (auto why = other_candidates(certificate, structure)) return *why;
  const auto friction = common_friction(certificate, structure);
  if (const auto* why = std::get_if<std::string>(&friction)) return *why;
  if (auto why = other_blocks(certificate, structure)) return *why;
  auto found = enclosure_for(certificate, structure);
  if (auto* why = std::get_if<std::string>(&found))
    return "K of the structure is not enclosed: " + *why;
  auto& [problem, loads] = std::get<LoadedEnclosure>(found);
  auto& [stiffness, motions] = problem;
  if (auto why = other_bodies(certificate, motions)) return *why;
  if (auto why = other_motions(certificate, motions)) return *why;
  if (auto why = other_stiffness(certificate, stiffness, min_scales(structure, motions)))
    return *why;
  if (certificate.loads) {
    const auto& recorded = *certificate.loads;
    if (auto why = other_clearances(recorded, structure, certificate)) return *why;
    if (auto why = other_forces(recorded.dead, loads[0], structure.dead, "dead", certificate))
      return *why;
    if (auto why = other_forces(recorded.reference, loads[1], structure.reference, "reference",
                                certificate))
      return *why;
  }
  return ConsistentStructure{std::move(stiffness), std::move(motions), std::move(loads),
                             std::get<double>(friction)};
}

}  // namespace kusabi::verify
