// Reader of recorded trees: sizes of subtrees from the depths of nodes in depth-first order.
#include "nodes/benchmark/recorded_tree.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/node_record.hpp"
#include "engine/search.hpp"

namespace kusabi::benchmark {
namespace {

constexpr double nano = 1e-9;

[[noreturn]] void refuse(const std::string& name, std::size_t line, const std::string& expected) {
  throw std::invalid_argument(name + ", line " + std::to_string(line) + ": expected " + expected);
}

}  // namespace

RecordedTree RecordedTree::read(std::istream& stream, const std::string& name) {
  auto recording = std::make_shared<Recording>();
  auto& nodes = recording->nodes;
  std::vector<std::uint32_t> above;  // places of the ancestors of the next node
  std::vector<double> path;          // sums of times down to them
  const auto close_down_to = [&](std::size_t depth) {
    for (; above.size() > depth; above.pop_back()) {
      nodes[above.back()].subtree = static_cast<std::uint32_t>(nodes.size()) - above.back();
    }
  };
  std::string text;
  for (std::size_t line = 1; std::getline(stream, text); ++line) {
    if (text == engine::incomplete_record) recording->complete = false;
    if (text.empty() || text.front() == '#') continue;
    std::istringstream words(text);
    std::size_t depth = 0;
    double nanoseconds = 0;
    if (!(words >> depth >> nanoseconds) || !(words >> std::ws).eof() || !(nanoseconds >= 0)) {
      refuse(name, line, "a depth and a time in nanoseconds, such as \"3 1250\"");
    }
    if (nodes.empty() && depth != 0) refuse(name, line, "the root first, with depth 0");
    if (!nodes.empty() && (depth == 0 || depth > above.size())) {
      refuse(name, line, "a depth from 1 to " + std::to_string(above.size()));
    }
    if (nodes.size() == std::numeric_limits<std::uint32_t>::max()) {
      refuse(name, line, "fewer than 2^32 nodes");
    }
    close_down_to(depth);
    above.push_back(static_cast<std::uint32_t>(nodes.size()));
    nodes.push_back({1, nanoseconds * nano});
    path.resize(depth);
    path.push_back((path.empty() ? 0 : path.back()) + nodes.back().seconds);
    recording->longest_path = std::max(recording->longest_path, path.back());
  }
  if (nodes.empty()) throw std::invalid_argument(name + ": has no nodes; expected a recorded tree");
  close_down_to(0);
  recording->least_seconds = nodes.front().seconds;
  for (const auto& node : nodes) {
    recording->total_seconds += node.seconds;
    recording->least_seconds = std::min(recording->least_seconds, node.seconds);
  }
  return RecordedTree(std::move(recording));
}

}  // namespace kusabi::benchmark

template kusabi::engine::OutcomeOf<kusabi::benchmark::RecordedTree> kusabi::engine::search(
    kusabi::benchmark::RecordedTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
