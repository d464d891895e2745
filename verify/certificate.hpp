// A certificate as it is read: the problem and, for every node of the tree that was closed, why.
// docs/certificates.md describes the file. Nothing that is read is believed: verify/proof.hpp and
// verify/cover.hpp check it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace kusabi::verify {

/// What a certificate says of a node.
enum class Claim {
  dead,      ///< no wedged configuration below it
  alive,     ///< a leaf that has one, with all inequalities strict
  marginal,  ///< nothing is claimed
};

/// "dead", "alive" or "marginal", as in the file.
const char* claim_name(Claim claim);

/// A closed node: one line of the file.
struct Record {
  std::size_t line = 0;  ///< of the file, the first being 1
  Claim claim = Claim::marginal;
  std::size_t block = 0;        ///< which block's node it is, the first being 0
  std::uint64_t contact = 0;    ///< U, bit i for candidate i: u_n = 0
  std::uint64_t separated = 0;  ///< R: r = 0
  /// dead: multipliers of the normal displacements, one a candidate of the block. alive: the
  /// tangential reactions of the candidates in U, in their order, d - 1 each.
  std::vector<double> numbers;
};

/// What a file holds; all numbers are finite.
struct Certificate {
  std::size_t dimension = 0;          ///< d: 2 or 3
  std::vector<std::string> names;     ///< of the m candidates, 1 <= m <= 64; all different
  std::vector<double> friction;       ///< m, each >= 0
  std::vector<std::uint64_t> blocks;  ///< a partition of the candidates; K is zero between two
  std::vector<double> stiffness;      ///< K, dm x dm, row by row, symmetric
  std::vector<Record> records;        ///< in the order of the file, repeated ones left out

  [[nodiscard]] std::size_t candidates() const { return names.size(); }
  [[nodiscard]] std::size_t displacements() const { return dimension * names.size(); }
  [[nodiscard]] std::uint64_t all_candidates() const {  ///< a bit for each
    return ~std::uint64_t{0} >> (64 - names.size());
  }
  /// The names of a set of candidates in braces.
  [[nodiscard]] std::string names_of(std::uint64_t set) const;
};

/// Something is wrong with the file itself: "LINE: what, expected what", or "was altered: …".
class CertificateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the text of a file. Of lines that say the same of the same node the first is kept; lines
/// of one node that contradict each other all are (verify/cover.hpp refuses them).
/// @param file for messages
/// @throws CertificateError
Certificate read_certificate(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
