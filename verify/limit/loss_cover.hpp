// Cover of all losses of up to K members by stress states: after a loss without any member of its
// support, the truss still has the state.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "support/index_set.hpp"

namespace kusabi::verify {

/// Decides if every loss of up to `maximum` members misses the support of one of some states.
class LossCover {
 public:
  /// @param kept members that are not lost @pre supports outlive this object
  LossCover(const std::vector<support::IndexSet>& supports, const support::IndexSet& kept,
            int maximum);

  /// A loss that has a member of every support; nothing if there is none.
  [[nodiscard]] const std::optional<support::IndexSet>& flaw() const { return flaw_; }

  /// Without a flaw: states that are enough, by number, ascending.
  [[nodiscard]] std::vector<std::size_t> needed() const;

 private:
  using Numbers = std::vector<std::size_t>;

  bool covers(const support::IndexSet& lost, const support::IndexSet& kept, int left,
              const Numbers& states);
  bool covers_one(const support::IndexSet& lost, const support::IndexSet& kept,
                  const Numbers& states);
  bool is_packed(const support::IndexSet& kept, int left, const Numbers& states);

  const std::vector<support::IndexSet>& supports_;
  std::vector<bool> needed_;
  std::optional<support::IndexSet> flaw_;
};

}  // namespace kusabi::verify
