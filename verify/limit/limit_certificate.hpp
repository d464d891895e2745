// Certificates of worst-case limit loads: the problem, a dead load and a motion for the upper
// bound, static cuts and, for every closed node of the tree of signs, a static proof of the lower
// bound. docs/certificates.md describes the file; verify/limit/limit_proof.hpp proves each claim.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/wedged/certificate.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {

/// The first line.
inline constexpr std::string_view limit_first_line = "kusabi certificate 5 limit";

/// Indices and numbers; all others are zero.
using Sparse = std::vector<std::pair<std::size_t, double>>;

/// A column of T as weight times direction, t = w d, exactly: for a single component w is its
/// absolute value and d is +1 or -1; otherwise w is 1.
struct LimitColumn {
  double weight = 1;
  Sparse direction;

  explicit LimitColumn(const Sparse& load);
};

/// A static cut: B y - k f_R = d up to rounding.
struct LimitCut {
  std::size_t column = 0;  ///< of T, which determines d
  double factor = 0;       ///< k
  Sparse forces;           ///< y
};

struct LimitNode {
  std::size_t line = 0;
  std::vector<int> signs;           ///< m: -1, 1, or 0 if undecided
  double factor = 0;                ///< lambda
  std::vector<double> forces;       ///< q
  Sparse shares;                    ///< mu, by cut, >= 0
  std::vector<double> one_sided{};  ///< nu, m, >= 0, zero for undecided signs
};

/// The evidence of one statement. All numbers are finite and all indices within range.
struct LimitCertificate {
  std::size_t displacements = 0;
  std::vector<double> tension;      ///< q^t, >= 0, one for each member
  std::vector<double> compression;  ///< q^c, >= 0
  std::vector<Sparse> columns;      ///< of B
  std::vector<double> dead;         ///< f_D
  std::vector<double> reference;    ///< f_R
  std::vector<Sparse> uncertain;    ///< T, by column; no column is empty, no component zero
  std::vector<double> alpha;        ///< m: |zeta_j| <= alpha_j, >= 0
  std::vector<double> load;         ///< zeta
  std::vector<double> motion;       ///< u
  std::vector<LimitCut> cuts;
  std::vector<LimitNode> nodes;
  /// m: the name of each column's load or group, empty without name. Empty vector: no names.
  std::vector<std::string> names{};

  [[nodiscard]] std::size_t members() const { return columns.size(); }
};

/// The quantity that is bounded, over all admissible loads.
enum class LimitClaim {
  largest,  ///< the minimum of the largest factor
  /// The maximum of the least factor: minus the minimum for the opposite reference load. Without
  /// nodes only its lower bound is claimed.
  minimum,
  none,  ///< the recorded load has no admissible factor
};

/// A claim and its evidence. For the claim `minimum` the reference load is the opposite one.
struct LimitStatement {
  std::string load_case;  ///< empty: the problem file has no load cases
  LimitClaim claim = LimitClaim::largest;
  LimitCertificate evidence;
  /// True if the compression strengths are those of the struts after buckling.
  bool residual = false;
};

/// The numbers of a line 'residual', one for each member: compression strengths after buckling.
/// @param strengths those before, which are not exceeded @throws CertificateError
std::vector<double> read_residual_strengths(Lines& lines, const std::vector<double>& strengths);

/// The keyword of a claim in a file.
std::string_view claim_word(LimitClaim claim);

/// The text of a file.
/// @param statements of one truss, at least one; those of a load case are adjacent and have the
///   same loads up to the sign of the reference load; those at residual strength come last
std::string limit_certificate_text(std::span<const LimitStatement> statements);

/// The statements of a file. A load case has the claim `none` alone, or `largest` and optionally
///        `minimum`; then, optionally, the same at residual strength.
/// @param file for messages
/// @throws CertificateError
std::vector<LimitStatement> read_limit_certificate(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
