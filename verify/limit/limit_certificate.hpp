// Certificates of worst-case limit loads as they are read: the problem, a dead load and a motion
// for the upper bound, static cuts and, for every closed node of the tree of signs, a static proof
// of the lower bound. docs/certificates.md describes the file. Nothing that is read is believed:
// verify/limit/limit_proof.hpp checks it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

/// The first line begins so, and ends with the version.
inline constexpr std::string_view limit_first_words = "kusabi limit certificate ";

/// Places and the numbers there; all others are zero.
using Sparse = std::vector<std::pair<std::size_t, double>>;

/// A column of T as weight times direction, t = w d, exactly: of a single component w is its size
/// and d is +1 or -1 there; otherwise w is 1.
struct LimitColumn {
  double weight = 1;
  Sparse direction;

  explicit LimitColumn(const Sparse& load);
};

/// B y - k f_R = d, roughly.
struct LimitCut {
  std::size_t column = 0;  ///< of T, which says what d is
  double factor = 0;       ///< k
  Sparse forces;           ///< y
};

struct LimitNode {
  std::size_t line = 0;
  std::vector<int> signs;           ///< m: -1, 1, or 0 if not decided
  double factor = 0;                ///< lambda
  std::vector<double> forces;       ///< q
  Sparse shares;                    ///< mu, by cut, >= 0
  std::vector<double> one_sided{};  ///< nu, m, >= 0, zero where no sign is decided
};

/// The evidence of one statement; all numbers are finite, all places within range.
struct LimitCertificate {
  std::size_t displacements = 0;
  std::vector<double> tension;      ///< q^t, >= 0, a member each
  std::vector<double> compression;  ///< q^c, >= 0
  std::vector<Sparse> columns;      ///< of B
  std::vector<double> dead;         ///< f_D
  std::vector<double> reference;    ///< f_R
  std::vector<Sparse> uncertain;    ///< T, by column; none is empty, no component zero
  std::vector<double> alpha;        ///< m: |zeta_j| <= alpha_j, >= 0
  std::vector<double> load;         ///< zeta
  std::vector<double> motion;       ///< u
  std::vector<LimitCut> cuts;
  std::vector<LimitNode> nodes;
  /// m: the name of each column's load or group, empty if it has none; no names at all: none has.
  std::vector<std::string> names{};

  [[nodiscard]] std::size_t members() const { return columns.size(); }
};

/// The subject of a statement, over all admissible loads.
enum class LimitClaim {
  largest,  ///< the minimum of the largest factor
  least,    ///< the maximum of the least factor: minus the same with the reference load reversed
  none,     ///< the recorded load is carried at no factor
};

/// A claim and its evidence, whose reference load is the reversed one if the claim is `least`.
struct LimitStatement {
  std::string load_case;  ///< empty: the problem file has none
  LimitClaim claim = LimitClaim::largest;
  LimitCertificate evidence;
};

/// A name as a file has it, in one line: control characters as \x0a.
std::string in_one_line(std::string_view name);

/// The word of a claim in a file.
std::string_view claim_word(LimitClaim claim);

/// The text of a file. @param statements of one truss, at least one; those of a load case are
///        neighbours, of the same loads but for the sign of the reference load
std::string limit_certificate_text(std::span<const LimitStatement> statements);

/// The statements of a file; of a case `none` alone, or `largest`, and then `least` if it is there.
/// @param file for messages
/// @throws CertificateError
std::vector<LimitStatement> read_limit_certificate(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
