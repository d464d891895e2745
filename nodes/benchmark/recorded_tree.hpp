// RecordedTree: the tree of a search as recorded with the time of each node
// (engine::Options::record), to be searched again in virtual time.
//
// Each line of the file is a node, "DEPTH NANOSECONDS", in depth-first order; lines that begin with
// # are comments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "engine/search_declaration.hpp"

namespace kusabi::benchmark {

/// The tree as a problem of engine::simulate. Copies share the recording.
class RecordedTree {
 public:
  struct Node {
    std::uint32_t place = 0;  ///< number of nodes before it in depth-first order

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& place;
    }
  };

  /// There are no solutions.
  struct Solution {
    template <class Archive>
    void serialize(Archive& /*archive*/, unsigned /*version*/) {}
  };

  /// @param name for error messages
  /// @throws std::invalid_argument with one line if the stream is not such a recording
  static RecordedTree read(std::istream& stream, const std::string& name);

  [[nodiscard]] std::uint64_t size() const { return recording_->nodes.size(); }
  /// Time of all nodes, in seconds.
  [[nodiscard]] double total_seconds() const { return recording_->total_seconds; }

  /// False if the recorded search ended early.
  [[nodiscard]] bool complete() const { return recording_->complete; }

  /// Greatest sum of times on a path from the root, in seconds: no number of ranks is faster.
  [[nodiscard]] double longest_path() const { return recording_->longest_path; }

  [[nodiscard]] Node root() const { return {}; }

  /// @param out engine::Expansion of this type
  template <class Expansion>
  void expand(Node&& node, Expansion& out) {
    const auto& nodes = recording_->nodes;
    const auto& [subtree, seconds] = nodes[node.place];
    seconds_ += seconds;
    for (auto child = node.place + 1; child < node.place + subtree; child += nodes[child].subtree) {
      out.branch({child});
    }
  }

  /// Virtual time of the nodes that this object has expanded, and the least of one node.
  [[nodiscard]] double seconds() const { return seconds_; }
  [[nodiscard]] double least_seconds() const { return recording_->least_seconds; }

 private:
  struct Entry {
    std::uint32_t subtree = 1;  // number of nodes, itself included
    double seconds = 0;
  };
  struct Recording {
    std::vector<Entry> nodes;  // in depth-first order
    double total_seconds = 0;
    double least_seconds = 0;
    double longest_path = 0;
    bool complete = true;
  };

  explicit RecordedTree(std::shared_ptr<const Recording> recording)
      : recording_(std::move(recording)) {}

  std::shared_ptr<const Recording> recording_;
  double seconds_ = 0;
};

}  // namespace kusabi::benchmark

extern template kusabi::engine::OutcomeOf<kusabi::benchmark::RecordedTree> kusabi::engine::search(
    kusabi::benchmark::RecordedTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
