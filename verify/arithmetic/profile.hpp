// Profile (skyline) storage of the lower triangle of a symmetric matrix: each row from its first
// nonzero entry to the diagonal. A Cholesky factor has the same profile.
#pragma once

#include <cstddef>
#include <vector>

namespace kusabi::verify {

class Profile {
 public:
  Profile() = default;

  /// @param first column of each row; first[i] <= i
  explicit Profile(std::vector<std::size_t> first) : first_(std::move(first)) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < first_.size(); ++i) {
      start_.push_back(next);
      next += i + 1 - first_[i];
    }
    entries_ = next;
  }

  /// The profile of a full lower triangle.
  static Profile full(std::size_t size) { return Profile(std::vector<std::size_t>(size, 0)); }

  [[nodiscard]] std::size_t size() const { return first_.size(); }
  [[nodiscard]] std::size_t entries() const { return entries_; }
  [[nodiscard]] std::size_t first(std::size_t row) const { return first_[row]; }

  /// Index of an entry in the list of all. @pre first(row) <= column <= row
  [[nodiscard]] std::size_t at(std::size_t row, std::size_t column) const {
    return start_[row] + column - first_[row];
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::size_t> start_;
  std::size_t entries_ = 0;
};

}  // namespace kusabi::verify
