// A certificate as it is read: the problem and, for every node of the tree that was closed, why.
// docs/certificates.md describes the file. Nothing that is read is believed:
// verify/wedged/proof.hpp and verify/wedged/cover.hpp check it.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/index_set.hpp"

namespace kusabi::verify {

/// What a certificate says of a node.
enum class Claim {
  dead,      ///< no wedged configuration below it
  alive,     ///< a leaf that has one, with all inequalities strict
  marginal,  ///< nothing is claimed
  cut,       ///< dead, but for the cuts that follow from bounds of candidates
};

/// "dead", "alive", "marginal" or "cut", as in the file.
const char* claim_name(Claim claim);

/// What a candidate does.
enum class Side {
  contact,    ///< u_n = 0
  separated,  ///< r = 0
};

/// "contact" or "separated", as in the file.
const char* side_name(Side side);

/// How much a candidate takes part in any wedged configuration, in units of s, the sum of the
/// normal reactions of its block.
struct Bound {
  std::size_t line = 0;   ///< of the file
  std::size_t block = 0;  ///< the first being 0
  int candidate = 0;      ///< its number in the whole problem, the first being 0
  Side side = Side::contact;
  /// In contact r_n <= most s, separated u_n <= most s (length / force); nothing: no wedged
  /// configuration has it on this side. > 0.
  std::optional<double> most{};
  /// Multipliers of the normal displacements, one a candidate of the block; the parts of its
  /// motions in the mean motion of w; multipliers of cuts, one a candidate, >= 0; unless `most` is
  /// nothing, that of its opposite, > 0.
  std::vector<double> numbers{};
};

/// A closed node: one line of the file.
struct Record {
  std::size_t line = 0;  ///< of the file, the first being 1
  Claim claim = Claim::marginal;
  std::size_t block = 0;        ///< which block's node it is, the first being 0
  support::IndexSet contact;    ///< U: u_n = 0
  support::IndexSet separated;  ///< R: r = 0
  /// dead: multipliers of the normal displacements, one a candidate of the block. alive: the
  /// tangential reactions of the candidates in U, in their order, d - 1 each. After them, for each
  /// motion of the block, its part in the mean motion of w (dead), of u (alive). cut: all that dead
  /// has, then multipliers of the cuts, one a candidate each, >= 0.
  std::vector<double> numbers;
};

/// What a file holds; all numbers are finite.
struct Certificate {
  std::size_t dimension = 0;              ///< d: 2 or 3
  std::vector<std::string> names;         ///< of the m candidates, m >= 1; all different
  std::vector<double> friction;           ///< m, each >= 0
  std::vector<support::IndexSet> blocks;  ///< a partition of the candidates; K is zero between two
  std::vector<double> stiffness;          ///< K, dm x dm, row by row, symmetric
  std::size_t motions = 0;                ///< p, of bodies that nothing holds
  std::vector<double> motion_values;      ///< G, dm x p, row by row; each column of one block
  /// Whether it shows that there is a pattern, and says nothing of others: its nodes then need not
  /// cover all sign patterns.
  bool one_pattern = false;
  std::vector<Bound> bounds;    ///< in the order in which they are to be proved
  std::vector<Record> records;  ///< in the order of the file, repeated ones left out

  [[nodiscard]] std::size_t candidates() const { return names.size(); }
  [[nodiscard]] std::size_t displacements() const { return dimension * names.size(); }
  [[nodiscard]] support::IndexSet all_candidates() const {
    return support::IndexSet::below(static_cast<int>(names.size()));
  }
  /// Which columns of G belong to a block.
  [[nodiscard]] std::vector<std::size_t> motions_of(const support::IndexSet& block) const;
  /// The names of a set of candidates in braces.
  [[nodiscard]] std::string names_of(const support::IndexSet& set) const;
};

/// Something is wrong with the file itself: "LINE: what, expected what", or "was altered: …".
class CertificateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the text of a file. Of lines that say the same of the same node the first is kept; lines
/// of one node that contradict each other all are (verify/wedged/cover.hpp refuses them).
/// @param file for messages
/// @throws CertificateError
Certificate read_certificate(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
