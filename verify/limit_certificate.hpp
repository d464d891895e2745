// A certificate of a worst-case limit load as it is read: the problem, a dead load and a motion for
// the upper end, static cuts and, for every closed node of the tree of signs, a static proof of the
// lower end. docs/certificates.md describes the file. Nothing that is read is believed:
// verify/limit_proof.hpp checks it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/certificate.hpp"

namespace kusabi::verify {

inline constexpr std::string_view limit_first_line = "kusabi limit certificate 1";

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

/// What a file holds; all numbers are finite, all places within range.
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

  [[nodiscard]] std::size_t members() const { return columns.size(); }
};

/// The text of a file.
std::string limit_certificate_text(const LimitCertificate& certificate);

/// @param file for messages
/// @throws CertificateError
LimitCertificate read_limit_certificate(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
