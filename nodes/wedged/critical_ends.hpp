// The proof of both ends of a bracket of the critical friction coefficient, put to the verifier's
// own test. At the lower end the tree of sign patterns decides every node; at the upper end one
// leaf that is feasible is enough. An end that cannot be verified is moved outwards until it can.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_bracket.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/tree/enclosure.hpp"
#include "nodes/wedged/tree/evidence_check.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

enum class CriticalEnd { lower, upper };

/// Which patterns a record is about: all, or one that is feasible.
enum class EndClaim { all_patterns, one_pattern };

/// Records the evidence of one end while it is searched, on one rank.
class EndRecord {
 public:
  EndRecord() = default;
  EndRecord(const EndRecord&) = delete;
  EndRecord& operator=(const EndRecord&) = delete;
  virtual ~EndRecord() = default;

  virtual void add(const Evidence& evidence) = 0;

  /// When the search is done, on every rank alike. @param bounds that the evidence uses
  /// @param holds whether it shows what was wanted; else the end moves on, and there will be
  /// another record
  virtual void end(std::span<const ProvedBound> bounds, EndClaim claim, bool holds) = 0;
};

/// Begins a record, on every rank alike. @param factor the friction coefficient @param friction
/// that of each candidate @return null: this end is not to be recorded
using EndRecorder = std::function<std::unique_ptr<EndRecord>(CriticalEnd end, double factor,
                                                             std::span<const double> friction)>;

/// What the ends are moved by, and what is asked at the upper one.
struct EndsQuestion {
  CriticalGrid grid;
  Tightening tightening = Tightening::automatic;
  bool list = false;             ///< whether all patterns are asked for
  std::uint64_t list_nodes = 0;  ///< as of CriticalQuestion
};

/// What lives at one coefficient.
struct DecidedEnd;

/// Every rank makes the same calls. All must outlive it.
class CriticalEnds {
 public:
  CriticalEnds(engine::Analysis& analysis, const problems::Structure& structure,
               const problems::WedgedProblem& problem, const EndsQuestion& question,
               const EndRecorder& recorder, CriticalBracket& bracket,
               std::vector<CriticalCost>& costs);

  /// Puts both ends to the test as they are, and moves none: the lower one by the roots alone, the
  /// upper one by its leaf.
  void prove_at_once();

  /// Proves the ends, or widens the bracket. Says what stays open and where it was stopped; the
  /// patterns are told on rank 0.
  void prove(CriticalFindings& findings);

 private:
  struct DecidedLeaf;
  /// Whether evidence proves what it claims.
  using Test = std::function<bool(const Evidence&)>;

  bool enclose();
  void know(std::vector<Configuration> found);
  bool roots_are_dead(double factor);
  DecidedLeaf decide_leaf(const PatternNode& leaf, double factor, bool recorded);
  /// Whether the search may be wrong by more than an end can be moved, and all can be put to the
  /// verifier's test.
  [[nodiscard]] bool is_to_bisect() const {
    return far_apart_ && question_.grid.precision == Precision::escalating &&
           std::holds_alternative<verify::EnclosedProblem>(*stiffness_);
  }
  [[nodiscard]] Test test(std::span<const double> friction,
                          std::span<const ProvedBound> bounds = {}) const;
  [[nodiscard]] conic::Tolerances tolerances() const;
  template <class Wanted>
  DecidedEnd decide(CriticalEnd end, double factor, CriticalPhase phase,
                    const EndRecorder& recorder, Wanted wanted, std::uint64_t nodes);
  engine::Status bisect();
  engine::Status prove_lower();
  engine::Status prove_upper();
  engine::Status prove_by_any(double factor);
  /// True if the upper bound is `factor` and a configuration of its pattern is known.
  [[nodiscard]] bool known_at(double factor) const {
    return !known_.empty() && bracket_.upper() == factor && known_leaf_ == bracket_.leaf();
  }
  engine::Status list(CriticalFindings& findings);
  void note_patterns(CriticalFindings& findings) const;
  void note_what_is_open(CriticalFindings& findings) const;

  engine::Analysis& analysis_;
  const problems::Structure& structure_;
  const problems::WedgedProblem& problem_;
  EndsQuestion question_;
  const EndRecorder& recorder_;
  CriticalBracket& bracket_;
  std::vector<CriticalCost>& costs_;
  /// Or why the ends cannot be put to the verifier's test; nothing before it is computed.
  std::optional<Enclosure> stiffness_;
  bool far_apart_;  ///< scales of unconstrained bodies: what the solver finds may be wrong
  double proved_lower_ = 0;
  std::vector<Configuration> known_;       ///< feasible at the upper end, and
  std::optional<PatternNode> known_leaf_;  ///< the leaf that the bracket had then
};

}  // namespace kusabi::wedged
