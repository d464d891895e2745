// Certificates of trusses: the truss in coordinates, its loads in each load case, and theorems on
// load factors with their evidence. docs/certificates.md describes the file;
// verify/limit/truss_proof.hpp proves each theorem.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verify/limit/limit_truss.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// The first line.
inline constexpr std::string_view truss_first_line = "kusabi certificate 5 truss";

/// A collapse, for an upper bound.
struct CollapseMotion {
  std::vector<std::size_t> lost{};  ///< members, ascending
  std::vector<double> load;         ///< zeta, m
  std::vector<double> motion;       ///< u, by free displacement
};

/// A static cut: B y - k f_R = d up to rounding.
struct LimitCut {
  std::size_t column = 0;  ///< of T, which determines d
  double factor = 0;       ///< k
  Sparse forces;           ///< y
};

/// A state for all loads with some signs. All members of the truss have forces.
struct LimitNode {
  std::size_t line = 0;
  std::vector<int> signs;           ///< m: -1, 1, or 0 if undecided
  double factor = 0;                ///< lambda
  std::vector<double> forces;       ///< q
  Sparse shares;                    ///< mu, by cut, >= 0
  std::vector<double> one_sided{};  ///< nu, m, >= 0, zero for undecided signs
};

/// Forces and factor of one load, in equilibrium up to rounding.
struct StressColumn {
  double factor = 0;
  Sparse forces;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& factor& forces;
  }
};

/// A state that carries every admissible load: for the load coefficients zeta, forces and factor
/// are those of the dead load plus sum_j (zeta_j / alpha_j) times response j.
struct StressState {
  std::vector<std::size_t> support;   ///< members that may have forces, ascending
  std::vector<StressColumn> columns;  ///< of the dead load, then of each uncertain load

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& support& columns;
  }
};

/// The quantity that is bounded, over all admissible loads and losses.
enum class LimitClaim {
  largest,  ///< the minimum of the largest factor
  /// The maximum of the least factor: minus the minimum for the opposite reference load. Without
  /// nodes only its lower bound is claimed.
  minimum,
  none,  ///< the recorded load has no admissible factor
};

/// The word for a claim in a file: "largest", "least" or "none".
std::string_view claim_word(LimitClaim claim);

/// A theorem on one load case, and its evidence. All numbers are finite, all indices within range.
struct TrussTheorem {
  std::string load_case{};  ///< empty: the problem file has no load cases
  /// Places, supports, bars and loads; without uncertain loads, the dead load as given is meant.
  Structure truss{};
  LimitClaim claim = LimitClaim::largest;
  bool residual = false;              ///< all struts are at their residual strength
  std::size_t losses = 0;             ///< K, the largest number of lost members
  double sudden = 1;                  ///< dynamic factor, which divides the yield forces
  std::vector<std::size_t> kept{};    ///< members that are not lost, ascending
  CollapseMotion collapse{};          ///< of the upper bound
  std::vector<LimitCut> cuts{};       ///< K = 0: of the lower bound, with the nodes
  std::vector<LimitNode> nodes{};     ///< K = 0
  double lower = 0;                   ///< K > 0: the lower bound; without states, none is claimed
  std::vector<StressState> states{};  ///< K > 0: enough for all losses
};

/// The text of a file.
/// @param theorems of one truss, at least one; those of a load case are adjacent and have the same
///        loads; those at residual strength are the last of a load case
std::string truss_certificate_text(std::span<const TrussTheorem> theorems);

/// The theorems of a file, of the same losses. A load case has the claim `none` alone, or `largest`
///        and optionally `minimum`; then, optionally, the same at residual strength.
/// @param file for messages
/// @throws CertificateError
std::vector<TrussTheorem> read_truss_certificate(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
