// Wedged configurations in the output files of patterns, rays and critical: JSON, CSV, VTK.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "pictures/vtu/structure_grid.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "problems/wedged/whole_structure.hpp"
#include "run/output/csv.hpp"

namespace kusabi::run {

/// Whole-structure solver common to all outputs, built at first use, since it takes seconds for a
/// large body.
class WholeStates {
 public:
  /// Both must outlive it.
  WholeStates(const problems::CheckedStructure& structure, const problems::WedgedProblem& problem)
      : structure_(structure), problem_(problem) {}

  [[nodiscard]] const problems::Structure& structure() const { return structure_; }
  [[nodiscard]] const problems::WedgedProblem& problem() const { return problem_; }
  [[nodiscard]] const problems::WholeStructure& whole() const {
    if (!whole_) whole_.emplace(structure_, problem_);
    return *whole_;
  }

 private:
  const problems::CheckedStructure& structure_;
  const problems::WedgedProblem& problem_;
  mutable std::optional<problems::WholeStructure> whole_;
};

/// Configurations of a list, from the first, whose whole state is in the result file unless
/// `--whole` requests all: enough for pictures and tables, and a few MB for large structures.
constexpr std::size_t whole_unless_requested = 100;

/// State of the whole structure in a configuration, for the result file: (4) and (5) of the wedged
/// paper.
class WholeStateJson {
 public:
  /// @param states must outlive it
  explicit WholeStateJson(const WholeStates& states) : states_(states) {}

  /// Adds `all_displacements`, of the nodes in their order, and `support_reactions`, by the names
  /// of nodes, both in global axes; `axial_forces` if there are members, `utilisation` if a yield
  /// force is known for any, `stresses` and `von_mises` if there are elements, and `imbalance`.
  /// @param reactions of all candidates, dm
  /// @param displacements likewise
  void add_to(nlohmann::ordered_json& configuration, std::span<const double> reactions,
              std::span<const double> displacements) const;

  /// Adds the `displacement` of the candidates, and these members, of a configuration of one block.
  void add_to(nlohmann::ordered_json& configuration, std::uint32_t block,
              std::span<const double> reactions, std::span<const double> displacements) const;

 private:
  const WholeStates& states_;
};

/// block, contact, separated, at_rest.
void add_pattern_columns(CsvWriter& csv);

/// @param inactive candidates of blocks that cannot wedge, which are inactive, too
void add_pattern(CsvWriter& csv, const problems::WedgedProblem& problem, std::uint32_t block,
                 const wedged::SignPattern& pattern, const support::IndexSet& inactive = {});

/// "r_n a" of all candidates, then "r_t a" (in space "r_t1 a", "r_t2 a"), then the same for u.
void add_configuration_columns(CsvWriter& csv, const problems::WedgedProblem& problem);

/// @param reactions dm, in the frames of all candidates; force. Empty: empty cells
/// @param displacements likewise; length
void add_configuration(CsvWriter& csv, const problems::WedgedProblem& problem,
                       std::span<const double> reactions, std::span<const double> displacements);

/// The answer to which a configuration belongs.
struct GridFacts {
  std::string remark;              ///< text in the head of the file
  std::optional<double> friction;  ///< coefficient of the search
  std::optional<double> margin{};  ///< t*
};

/// Configurations as VTK grids: the whole structure with displacements, reactions and contact
/// states.
class ConfigurationGrids {
 public:
  /// @param states must outlive it
  explicit ConfigurationGrids(const WholeStates& states)
      : states_(states), structure_(pictures::structure_grid(states.structure())) {}

  /// The structure with point data `displacement`, `contact_reaction` (of the obstacle; for two
  /// bodies on both), `support_reaction`, all in global axes, `state`, `gap` (u_n of separated
  /// candidates) and, if a friction coefficient is known, `friction_use`, |r_t|/(mu r_n); field
  /// data `mu` and `margin`, units as VTK's UNITS_LABEL; cell data of members `axial_force` and, if
  /// a yield force is known for any, `utilisation`; of elements `stress` (xx, yy, zz, xy, yz, xz)
  /// and `von_mises`.
  /// @param reactions of all candidates, dm, in their frames
  /// @param displacements likewise
  /// @param contact one per candidate
  [[nodiscard]] pictures::UnstructuredGrid grid(
      const GridFacts& facts, std::span<const double> reactions,
      std::span<const double> displacements, std::span<const pictures::ContactState> contact) const;

  /// Configuration of one block; candidates of other blocks are inactive.
  [[nodiscard]] pictures::UnstructuredGrid grid(const GridFacts& facts, std::uint32_t block,
                                                const wedged::SignPattern& pattern,
                                                const support::IndexSet& inactive,
                                                std::span<const double> reactions,
                                                std::span<const double> displacements) const;

 private:
  const WholeStates& states_;
  pictures::UnstructuredGrid structure_;
};

}  // namespace kusabi::run
