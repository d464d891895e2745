// FoundList: solutions with the paths of their nodes, in few bytes.
//
// A path is stored as the number of steps that it has in common with the one before, the number of
// the others, and these, in groups of seven bits. In depth-first order most steps are common.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

#include "engine/expansion.hpp"
#include "engine/path.hpp"

namespace kusabi::engine {

template <class P>
class FoundList {
 public:
  using Solution = typename P::Solution;

  /// An earlier state of a list.
  struct Position {
    std::size_t solutions = 0;
    std::size_t bytes = 0;
    Path last;
  };

  [[nodiscard]] std::size_t size() const { return solutions_.size(); }

  void push_back(FoundSolution<P>&& found) {
    const auto& path = found.path;
    const auto differs = std::mismatch(path.begin(), path.end(), last_.begin(), last_.end()).first;
    put(static_cast<std::uint64_t>(differs - path.begin()));
    put(static_cast<std::uint64_t>(path.end() - differs));
    std::for_each(differs, path.end(), [this](std::uint32_t step) { put(step); });
    last_ = std::move(found.path);
    solutions_.push_back(std::move(found.solution));
  }

  /// Calls `look(found)` for each.
  template <class Look>
  void for_each(Look look) const {
    FoundSolution<P> found;
    auto byte = paths_.begin();
    for (const auto& solution : solutions_) {
      advance(found.path, [&] { return *byte++; });
      found.solution = solution;
      look(std::as_const(found));
    }
  }

  /// Removes them one by one, and calls `take(std::move(found))` for each.
  template <class Take>
  void take_each(Take take) {
    Path path;
    for (; !solutions_.empty(); solutions_.pop_front()) {
      advance(path, [this] {
        const auto byte = paths_.front();
        paths_.pop_front();
        return byte;
      });
      take(FoundSolution<P>{path, std::move(solutions_.front())});
    }
    last_.clear();
  }

  [[nodiscard]] Position position() const { return {solutions_.size(), paths_.size(), last_}; }

  /// Removes what was added since.
  void return_to(const Position& position) {
    solutions_.erase(solutions_.begin() + static_cast<std::ptrdiff_t>(position.solutions),
                     solutions_.end());
    paths_.resize(position.bytes);
    last_ = position.last;
  }

 private:
  static constexpr unsigned group = 7;
  static constexpr std::uint8_t more = 0x80;  // bit of all groups but the last

  void put(std::uint64_t number) {
    for (; number >= more; number >>= group) {
      paths_.push_back(static_cast<std::uint8_t>(number | more));
    }
    paths_.push_back(static_cast<std::uint8_t>(number));
  }

  template <class NextByte>
  static std::uint64_t get(NextByte& next) {
    std::uint64_t number = 0;
    for (unsigned shift = 0;; shift += group) {
      const std::uint64_t byte = next();
      number |= (byte & (more - 1U)) << shift;
      if (byte < more) return number;
    }
  }

  // Changes a path into the next one.
  template <class NextByte>
  static void advance(Path& path, NextByte next) {
    path.resize(get(next));
    for (auto steps = get(next); steps > 0; --steps) {
      path.push_back(static_cast<std::uint32_t>(get(next)));
    }
  }

  std::deque<std::uint8_t> paths_;
  std::deque<Solution> solutions_;
  Path last_;
};

}  // namespace kusabi::engine
