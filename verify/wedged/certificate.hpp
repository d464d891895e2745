// Certificate of a list of sign patterns: the problem, and evidence for every closed node of the
// tree. docs/certificates.md describes the file; verify/wedged/proof.hpp and
// verify/wedged/cover.hpp prove its claims.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/index_set.hpp"

namespace kusabi::verify {

/// Statement of a certificate on a node.
enum class Claim {
  infeasible,  ///< no wedged configuration below it
  feasible,    ///< a leaf: a configuration satisfies all inequalities strictly
  none,        ///< no statement; "marginal" in the file
  form,        ///< nothing is wedged in the block: a quadratic form is negative definite
  cut,         ///< infeasible by the cuts that follow from bounds of candidates
};

/// The keyword in the file: "dead", "alive", "marginal", "form" or "cut".
const char* claim_name(Claim claim);

/// State of a candidate.
enum class Side {
  contact,    ///< u_n = 0
  separated,  ///< r = 0
};

/// The keyword in the file: "contact" or "separated".
const char* side_name(Side side);

/// Bound of a candidate in all wedged configurations, in units of s, the sum of the normal
/// reactions of its block.
struct CandidateBound {
  std::size_t line = 0;   ///< of the file
  std::size_t block = 0;  ///< the first being 0
  int candidate = 0;      ///< its number in the whole problem, the first being 0
  Side side = Side::contact;
  /// Positive. Contact: r_n <= maximum s. Separated: u_n <= maximum s (length / force). Nothing: no
  /// wedged configuration has the candidate on this side.
  std::optional<double> maximum{};
  /// Multipliers of the normal displacements, one for each candidate of the block; coefficients of
  /// its rigid-body modes in the mean motion of w; multipliers of cuts, one for each candidate, >=
  /// 0; and, if there is `maximum`, the multiplier of its opposite, > 0.
  std::vector<double> numbers{};
};

/// A closed node: one line of the file.
struct Record {
  std::size_t line = 0;  ///< of the file, the first being 1
  Claim claim = Claim::none;
  std::size_t block = 0;        ///< block of the node, counted from 0
  support::IndexSet contact;    ///< U: u_n = 0
  support::IndexSet separated;  ///< R: r = 0
  /// infeasible: multipliers of the normal displacements, one for each candidate of the block.
  /// feasible: tangential reactions of the candidates in U, in their order, d - 1 each. Both:
  /// coefficients of the block's rigid-body modes in the mean motion of w (infeasible) or u
  /// (feasible). cut: the numbers of infeasible, then multipliers of cuts, one for each candidate,
  /// >= 0. form: those of products of u_ni and r_nj, by rows; for each pair (j, k) the d - 1
  /// components of that of r_nj and r_tk; one for the square of each candidate's friction
  /// cone; with modes, those of products of u_ni and u_nj, by rows.
  std::vector<double> numbers;
};

/// The content of a file; all numbers are finite.
struct Certificate {
  std::size_t dimension = 0;       ///< d: 2 or 3
  std::vector<std::string> names;  ///< of the m candidates, m >= 1, all distinct
  std::vector<double> friction;    ///< m, each >= 0
  /// A partition of the candidates; K is zero between blocks.
  std::vector<support::IndexSet> blocks;
  std::vector<double> stiffness;      ///< K, dm x dm, by rows, symmetric
  std::size_t motions = 0;            ///< p, number of rigid-body modes of unconstrained bodies
  std::vector<double> motion_values;  ///< G, dm x p, by rows; each column belongs to one block
  /// True if the file states only that a pattern exists. Its nodes then need not cover all sign
  /// patterns.
  bool one_pattern = false;
  std::vector<CandidateBound> bounds;  ///< in the order of their proofs
  std::vector<Record> records;         ///< in the order of the file, without repetitions

  [[nodiscard]] std::size_t candidates() const { return names.size(); }
  [[nodiscard]] std::size_t displacements() const { return dimension * names.size(); }
  [[nodiscard]] support::IndexSet all_candidates() const {
    return support::IndexSet::below(static_cast<int>(names.size()));
  }
  /// The columns of G of a block.
  [[nodiscard]] std::vector<std::size_t> motions_of(const support::IndexSet& block) const;
  /// The names of a set of candidates in braces.
  [[nodiscard]] std::string names_of(const support::IndexSet& set) const;
};

/// A fault of the file itself: "LINE: found, expected", or "was altered: …".
class CertificateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the text of a file. Of several lines with the same statement on a node the first is kept;
/// contradicting lines of a node are all kept, and verify/wedged/cover.hpp refuses them.
/// @param file for messages
/// @throws CertificateError
Certificate read_certificate(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
