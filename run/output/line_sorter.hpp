// LineSorter: external merge sort of lines that need not fit in memory.
#pragma once

#include <cstddef>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kusabi::run {

/// Lines are sorted in memory, a block at a time. If there are several blocks, they are written to
/// files without a name, which disappear with the process, and merged.
class LineSorter {
 public:
  /// True if the first line comes before the second.
  using Before = std::function<bool(std::string_view, std::string_view)>;

  /// @param beside a file name: the blocks are in its folder @param block memory in bytes
  LineSorter(std::string beside, Before before, std::size_t block = std::size_t{64} << 20U)
      : beside_(std::move(beside)), before_(std::move(before)), block_(block) {}

  /// @param line without a line end @throws std::runtime_error if the disk is full
  void add(std::string_view line);

  /// Calls `take` with each line in order; with one only of several lines that are equal in this
  /// order. Ends the sorter. @throws std::runtime_error if a block cannot be read
  void each(const std::function<void(std::string_view)>& take);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;

  class Block;  // reader of one file

  void sort();
  void write_block();
  [[nodiscard]] std::string_view line(const std::pair<std::size_t, std::size_t>& place) const {
    return std::string_view(text_).substr(place.first, place.second);
  }

  std::string beside_;
  Before before_;
  std::size_t block_;
  std::string text_;                                         // lines of the present block
  std::vector<std::pair<std::size_t, std::size_t>> places_;  // of each, offset and length
  std::vector<File> files_;                                  // earlier blocks
};

}  // namespace kusabi::run
