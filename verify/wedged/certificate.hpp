// Certificate about a contact problem: the problem, theorems that no state has parameters of a
// certain kind, with the closed nodes of their trees, and states. docs/certificates.md describes
// the file; verify/wedged/proof.hpp and verify/wedged/cover.hpp prove its claims,
// verify/wedged/conclusion.hpp draws the conclusions.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/index_set.hpp"

namespace kusabi::verify {

/// The first line.
inline constexpr std::string_view contact_first_line = "kusabi certificate 5 contact";

/// A combination of the loads of a block: `dead` times the dead load and the clearances, plus
/// `reference` times the reference load.
struct LoadShare {
  double dead = 0;  ///< 0 or 1 in a file
  double reference = 0;

  friend bool operator==(const LoadShare&, const LoadShare&) = default;
  friend auto operator<=>(const LoadShare&, const LoadShare&) = default;
};

/// Restriction of a theorem to states whose normal reactions add up to a given sum.
struct GripBound {
  enum class Kind { above, below, equal };  ///< at least, at most, exactly
  Kind kind = Kind::equal;
  double total = 0;  ///< force; of the block

  friend bool operator==(const GripBound&, const GripBound&) = default;
};

/// A theorem about a block: except at the nodes without a claim and in the patterns of recorded
/// wedged configurations, no sign pattern has a state under a load of the cone of the shares.
struct Theorem {
  std::size_t line = 0;             ///< of the file
  std::size_t block = 0;            ///< the first being 0
  std::vector<LoadShare> shares{};  ///< none: wedged configurations
  /// c_j > 0 of each share, to which its bounds of candidates refer; empty: it has no bounds.
  std::vector<double> weights{};
  std::optional<GripBound> grip{};  ///< restricts the states; with shares
  /// States under the dead load alone do not count; the other shares have factors of one sign.
  bool except_dead = false;

  [[nodiscard]] bool about_wedged() const { return shares.empty(); }
  /// True if bounds and cuts may refer to it.
  [[nodiscard]] bool may_have_bounds() const { return weights.size() == shares.size(); }
};

/// Statement of a certificate on a node.
enum class Claim {
  infeasible,  ///< no state below it
  cut,         ///< infeasible by the cuts that follow from bounds of candidates
  form,        ///< nothing is wedged in the block: a quadratic form is negative definite
  none,        ///< no statement; "marginal" in the file
};

/// The keyword in the file: "infeasible", "cut", "form" or "marginal".
const char* claim_name(Claim claim);

/// State of a candidate.
enum class Side {
  contact,    ///< u_n = 0
  separated,  ///< r = 0
};

/// The keyword in the file: "contact" or "separated".
const char* side_name(Side side);

/// Bound of a candidate in all states of a theorem, in units of s, the sum of the normal reactions
/// of the block and of the amounts of the loads, each times its weight.
struct CandidateBound {
  std::size_t line = 0;     ///< of the file
  std::size_t theorem = 0;  ///< the first being 0
  int candidate = 0;        ///< its number in the whole problem, the first being 0
  Side side = Side::contact;
  /// Positive. Contact: r_n <= maximum s. Separated: u_n, with the clearance, <= maximum s (length /
  /// force). Nothing: no state has the candidate on this side.
  std::optional<double> maximum{};
  /// Those of a node `cut`, and, if there is `maximum`, the multiplier of its opposite, > 0.
  std::vector<double> numbers{};
};

/// A closed node of a theorem: one line of the file.
struct Node {
  std::size_t line = 0;  ///< of the file, the first being 1
  Claim claim = Claim::none;
  std::size_t theorem = 0;        ///< the first being 0
  support::IndexSet contact{};    ///< U: u_n = 0
  support::IndexSet separated{};  ///< R: r = 0
  /// infeasible: multipliers of the normal displacements, one for each candidate of the block,
  /// coefficients of its rigid-body modes in the mean motion of w and, if the theorem restricts the
  /// sum of the normal reactions, its multiplier. cut: the same, then multipliers of cuts, one for
  /// each candidate, >= 0. form: those of products of u_ni and r_nj,
  /// by rows; for each pair (j, k) the d - 1 components of that of r_nj and r_tk; one for the
  /// square of each candidate's friction cone; with modes, those of products of u_ni and u_nj, by
  /// rows.
  std::vector<double> numbers{};
};

/// A state in the interior of the cone of a sign pattern.
struct State {
  std::size_t line = 0;  ///< of the file
  std::size_t block = 0;
  std::optional<LoadShare> share{};  ///< its load; nothing: a wedged configuration
  support::IndexSet contact{};
  support::IndexSet separated{};
  /// Tangential reactions of the candidates in U, in their order, d - 1 each, and coefficients of
  /// the block's rigid-body modes in the mean motion of u; under a load, of displacements that are
  /// zero along the normals of U.
  std::vector<double> numbers{};
};

/// Loads on the candidates, equivalent to those of the structure.
struct RecordedLoads {
  std::string load_case;          ///< of the problem file; empty: all loads of the file act
  std::vector<double> clearance;  ///< g, m, length
  std::vector<double> dead;       ///< dm, force
  std::vector<double> reference;  ///< dm, force
};

/// The content of a file; all numbers are finite.
struct Certificate {
  std::size_t dimension = 0;       ///< d: 2 or 3
  std::vector<std::string> names;  ///< of the m candidates, m >= 1, all distinct
  std::vector<double> friction;    ///< m, each >= 0
  /// A partition of the candidates; K is zero between blocks.
  std::vector<support::IndexSet> blocks;
  std::vector<double> stiffness;         ///< K, dm x dm, by rows, symmetric
  std::size_t motions = 0;               ///< p, number of rigid-body modes of unconstrained bodies
  std::vector<double> motion_values;     ///< G, dm x p, by rows; each column belongs to one block
  std::optional<RecordedLoads> loads{};  ///< nothing: about wedged configurations alone
  /// Sum of the normal reactions in all states that the conclusions are about, of the only block.
  std::optional<double> total{};
  std::vector<Theorem> theorems{};
  std::vector<CandidateBound> bounds{};  ///< in the order of their proofs
  std::vector<Node> nodes{};    ///< of all theorems, in the order of the file, without repetitions
  std::vector<State> states{};  ///< likewise

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

/// Reads the text of a file. Of several lines with the same statement on a node, or the same state,
/// the first is kept; contradicting lines of a node are all kept, and verify/wedged/cover.hpp
/// refuses them.
/// @param file for messages
/// @throws CertificateError
Certificate read_certificate(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
