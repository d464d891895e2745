// Interruption of the solvers of a tree within a node, by the search that opens it or by other
// callers.
#pragma once

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "engine/expansion.hpp"
#include "support/stop.hpp"

namespace kusabi::wedged {

/// The stop condition of the solvers of a tree. Trees may be moved; the condition keeps its
/// address.
class NodeInterruption {
 public:
  /// The condition for the solvers.
  [[nodiscard]] support::Stop stop() const {
    return [asked = asked_] { return support::is_requested(*asked); };
  }

  void end_when(support::Stop stop) { *asked_ = std::move(stop); }

  /// Does a node's work, during which the search is polled.
  /// @return nothing if the search is about to end; the node is then put back
  template <class Tree, class Work>
  std::optional<std::invoke_result_t<Work>> within(engine::Expansion<Tree>& out,
                                                   const typename Tree::Node& node, Work work) {
    *asked_ = [&out] { return out.poll(); };
    std::optional<std::invoke_result_t<Work>> done;
    try {
      done.emplace(work());
    } catch (const support::Stopped&) {
      out.put_back(node);
    }
    *asked_ = {};
    return done;
  }

  /// The same for work without a result.
  template <class Tree, class Work>
  void run(engine::Expansion<Tree>& out, const typename Tree::Node& node, Work work) {
    within(out, node, [&] {
      work();
      return true;
    });
  }

 private:
  std::shared_ptr<support::Stop> asked_ = std::make_shared<support::Stop>();
};

}  // namespace kusabi::wedged
