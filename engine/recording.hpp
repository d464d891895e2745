// The finished parts of a question, kept by all ranks together: what a run that goes on with it
// need not do again.
//
// A question is deterministic: asked again, it takes the same searches and shared works in the same
// order, and the results decide what comes next. So a run that goes on asks it from the beginning,
// and each part whose number is in the journal (engine/journal.hpp) returns at once what it came
// to. The part that was under way, if it is a search, goes on from its own checkpoint beside the
// journal.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "engine/journal.hpp"
#include "engine/options.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// Where a question is kept.
struct Keeping {
  Journal* journal = nullptr;   ///< on rank 0, null elsewhere; must outlive the question
  std::string file;             ///< its name, on every rank
  double interval = 600;        ///< seconds between two checkpoints of a search
  bool on_improvement = false;  ///< and one whenever its incumbent is improved
  std::uint64_t question = 0;   ///< fingerprint of the facts
};

/// The checkpoint of the search that is part `number` of the question kept in `file`.
std::string checkpoint_of_part(const std::string& file, std::uint64_t number);

/// What a journal calls the outcome of a search. @param problem what the compiler calls its type
std::string kind_of_search(const std::string& problem);

/// Whether a search is finished of the question that a journal is of.
bool has_searched(const Journal& journal);

/// Whether there is a checkpoint of one.
bool is_searching(const Journal& journal);

/// Every rank makes the same calls in the same order.
class Recording {
 public:
  /// @param warn told on rank 0 of what goes wrong without ending the run; may be empty
  Recording(Transport& transport, Keeping keeping, std::function<void(const std::string&)> warn);

  /// What the next part came to in an earlier run; nothing if it has to be done.
  /// @param kind what it yields @param spent as of sound()
  /// @param for_all whether every rank needs it; otherwise rank 0 alone gets more than no bytes
  /// @throws CheckpointError if the record is of something else
  std::optional<Bytes> known(const std::string& kind, bool spent, bool for_all);

  /// Whether all that was done so far is whole, on all ranks. Where an end has been asked for, work
  /// is cut short, and what comes of it is not what an unbroken run would have; from then on
  /// nothing is kept.
  /// @param spent whether the budget of this rank is
  bool sound(bool spent);

  /// What the engine is to keep and to go on from in the search that is the next part.
  CheckpointOptions checkpoint();

  /// The next part is done. Call only if sound. @param content counts on rank 0
  void keep(const std::string& kind, const Bytes& content);

 private:
  [[nodiscard]] bool is_first() const { return transport_.rank() == 0; }

  Transport& transport_;
  Keeping keeping_;
  std::function<void(const std::string&)> warn_;
  std::uint64_t next_ = 0;  // number of the next part
  bool replaying_ = true;   // it may be in the journal
  bool sound_ = true;
  bool writable_ = true;  // on rank 0
};

}  // namespace kusabi::engine
