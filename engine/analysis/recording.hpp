// Recording: finished parts of an analysis, in a journal shared by all ranks, that a resumed run
// does not repeat.
//
// An analysis is deterministic: repeated, it runs the same searches and shared work in the same
// order, and their results determine the next part. A resumed run therefore starts from the
// beginning, and each part whose number is in the journal (engine/journal.hpp) returns its recorded
// result at once. The interrupted part, if it is a search, resumes from its own checkpoint beside
// the journal.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "engine/journal.hpp"
#include "engine/options.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// Journal and checkpoints of an analysis.
struct JournalOptions {
  Journal* journal = nullptr;   ///< on rank 0, null elsewhere; must outlive the analysis
  std::string file;             ///< name of the journal, on every rank
  double interval = 600;        ///< seconds between two checkpoints of a search
  bool on_improvement = false;  ///< adds a checkpoint whenever the incumbent improves
  /// of the problem and the options that the results depend on
  std::uint64_t facts_fingerprint = 0;
};

/// Checkpoint of the search that is part `number` of the analysis with journal `file`.
std::string checkpoint_of_part(const std::string& file, std::uint64_t number);

/// Kind of a search's record. @param problem mangled name of the problem type
std::string kind_of_search(const std::string& problem);

/// True if the journal has a finished search.
bool has_searched(const Journal& journal);

/// True if a search of the analysis has a checkpoint.
bool is_searching(const Journal& journal);

/// Records of all ranks. Every rank makes the same calls in the same order.
class Recording {
 public:
  /// @param warn called on rank 0 with faults that do not end the run; may be empty
  Recording(Transport& transport, JournalOptions journal_options,
            std::function<void(const std::string&)> warn);

  /// Recorded result of the next part; nothing if the part has to be computed.
  /// @param kind type of the result @param spent as of sound()
  /// @param for_all true if every rank needs the result; otherwise ranks other than 0 get no bytes
  /// @throws CheckpointError if the record is of another kind
  std::optional<Bytes> known(const std::string& kind, bool spent, bool for_all);

  /// True if all parts so far are complete on all ranks. After a stop request a part may be
  /// incomplete, and its result would differ from that of an uninterrupted run; nothing is recorded
  /// from then on.
  /// @param spent true if the budget of this rank is spent
  bool sound(bool spent);

  /// Checkpoint options of the search that is the next part.
  CheckpointOptions checkpoint();

  /// Records the next part as finished. @pre sound() @param content used on rank 0
  void keep(const std::string& kind, const Bytes& content);

 private:
  [[nodiscard]] bool is_first() const { return transport_.rank() == 0; }

  Transport& transport_;
  JournalOptions journal_options_;
  std::function<void(const std::string&)> warn_;
  std::uint64_t next_ = 0;  // number of the next part
  bool replaying_ = true;   // the next part may be in the journal
  bool sound_ = true;
  bool writable_ = true;  // used on rank 0
};

}  // namespace kusabi::engine
