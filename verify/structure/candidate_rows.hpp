// Rows of K^0 that belong to the contact candidates: those of their nodes, of normal coordinates,
// of released rollers, and of loads.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "verify/structure/assembly.hpp"
#include "verify/structure/freedom.hpp"
#include "verify/structure/several_normals.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// Nodal forces that act together.
using ForceList = std::vector<Force>;

/// K^0 and the rows of the candidates.
struct CandidateRows {
  Freedom freedom;
  SparseEnclosure stiffness{};                   ///< K^0 with the rows of rollers and loads
  std::vector<std::vector<std::size_t>> seen{};  ///< d displacements of each candidate
  std::vector<std::size_t> loads{};              ///< rows of the loads, d or none
  std::vector<long> load_scales{};               ///< forces are multiplied by 2^this
  /// Displacements of candidates at nodes with several contact normals, already in their frames.
  CandidateNumbers shared{};
};

/// @param loads at most d
/// @param springs stiffness added along every displacement of a candidate, except supported ones
CandidateRows candidate_rows(const Structure& structure, std::span<const ForceList> loads,
                             double springs);

}  // namespace kusabi::verify
