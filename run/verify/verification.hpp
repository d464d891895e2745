// Verification: proofs of a certificate as a tree whose nodes the engine shares among ranks. A node
// is a range of records, bisected until it is small; solutions are refused records.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>

#include "engine/counts.hpp"
#include "engine/expansion.hpp"
#include "engine/index_range.hpp"
#include "run/verify/proof_words.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::run {

/// Problem type of engine::search.
class Verification {
 public:
  using Node = engine::IndexRange;  ///< of records

  /// A record whose claim is refused.
  struct Solution {
    std::uint64_t record = 0;
    std::string reason;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& record& reason;
    }
  };

  /// Numbers of nodes by proved claim.
  struct Tally : engine::Counts<Tally> {
    std::uint64_t infeasible = 0;  ///< with cuts or without
    std::uint64_t feasible = 0;
    std::uint64_t marginal = 0;  ///< without a claim
    /// Infeasible nodes, proved only for displacements up to `displacement_ratio` times the
    /// strains.
    std::uint64_t except_large_displacements = 0;
    /// Undecided nodes with a proof that some candidate in contact stays unloaded.
    std::uint64_t unloaded = 0;

    [[nodiscard]] std::uint64_t open() const { return marginal - unloaded; }

    static constexpr auto fields() {
      return std::tuple{field("dead", &Tally::infeasible), field("alive", &Tally::feasible),
                        field("marginal", &Tally::marginal),
                        field(large_displacements_column, &Tally::except_large_displacements),
                        field("unloaded", &Tally::unloaded)};
    }
  };

  /// Both must outlive this.
  Verification(const verify::Certificate& certificate, const verify::Proof& proof)
      : certificate_(certificate), proof_(proof) {}

  Node root() const { return {0, certificate_.records.size()}; }
  void expand(Node&& node, engine::Expansion<Verification>& out);
  Tally tally() const { return tally_; }

 private:
  const verify::Certificate& certificate_;
  const verify::Proof& proof_;
  Tally tally_;
};

}  // namespace kusabi::run
