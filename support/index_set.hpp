// IndexSet: a set of small non-negative integers, such as contact candidates. While all of them are
// below 64 it is one word without allocation, which covers most searches; larger numbers are
// permitted.
#pragma once

#include <algorithm>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

namespace kusabi::support {

class IndexSet {
 public:
  using Word = std::uint64_t;

  IndexSet() = default;

  /// The positions of the bits that are one: 0b101 is {0, 2}.
  IndexSet(Word ones) : first_(ones) {}  // NOLINT(google-explicit-constructor): a way to write them

  static IndexSet single(int index) {
    IndexSet set;
    set.insert(index);
    return set;
  }

  /// {0, ..., count - 1}
  static IndexSet below(int count) {
    IndexSet set;
    const auto full = static_cast<std::size_t>(count) / bits;
    for (std::size_t k = 0; k < full; ++k) set.grow_to(k) = ~Word{0};
    if (count % bits != 0) set.grow_to(full) = ~Word{0} >> (bits - count % bits);
    return set;
  }

  [[nodiscard]] bool empty() const { return first_ == 0 && rest_.empty(); }

  [[nodiscard]] int size() const {
    int count = std::popcount(first_);
    for (const Word word : rest_) count += std::popcount(word);
    return count;
  }

  [[nodiscard]] bool contains(int index) const { return (word(at(index)) & bit(index)) != 0; }

  /// @pre not empty
  [[nodiscard]] int lowest() const { return *begin(); }

  /// True if `part` is a subset.
  [[nodiscard]] bool includes(const IndexSet& part) const { return (part - *this).empty(); }

  /// True if the intersection is not empty.
  [[nodiscard]] bool meets(const IndexSet& other) const {
    if ((first_ & other.first_) != 0) return true;
    const auto common = std::min(rest_.size(), other.rest_.size());
    for (std::size_t k = 0; k < common; ++k) {
      if ((rest_[k] & other.rest_[k]) != 0) return true;
    }
    return false;
  }

  void insert(int index) { grow_to(at(index)) |= bit(index); }

  IndexSet& operator|=(const IndexSet& other) {
    first_ |= other.first_;
    if (rest_.size() < other.rest_.size()) rest_.resize(other.rest_.size());
    for (std::size_t k = 0; k < other.rest_.size(); ++k) rest_[k] |= other.rest_[k];
    return *this;
  }

  IndexSet& operator&=(const IndexSet& other) {
    first_ &= other.first_;
    if (rest_.size() > other.rest_.size()) rest_.resize(other.rest_.size());
    for (std::size_t k = 0; k < rest_.size(); ++k) rest_[k] &= other.rest_[k];
    return trim();
  }

  IndexSet& operator-=(const IndexSet& other) {
    first_ &= ~other.first_;
    const auto common = std::min(rest_.size(), other.rest_.size());
    for (std::size_t k = 0; k < common; ++k) rest_[k] &= ~other.rest_[k];
    return trim();
  }

  friend IndexSet operator|(IndexSet a, const IndexSet& b) { return a |= b; }
  friend IndexSet operator&(IndexSet a, const IndexSet& b) { return a &= b; }
  friend IndexSet operator-(IndexSet a, const IndexSet& b) { return a -= b; }
  friend bool operator==(const IndexSet&, const IndexSet&) = default;
  /// A total order for maps and for the removal of duplicates: `first_` as a number, then the
  /// further words.
  friend auto operator<=>(const IndexSet&, const IndexSet&) = default;

  /// Iterates over the numbers in increasing order: `for (const int index : set)`.
  class Iterator {
   public:
    using value_type = int;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::input_iterator_tag;
    using pointer = const int*;
    using reference = int;

    Iterator() = default;
    Iterator(const IndexSet& set, std::size_t at) : set_(&set), at_(at), left_(set.word(at)) {
      skip();
    }

    int operator*() const { return static_cast<int>(bits * at_) + std::countr_zero(left_); }
    Iterator& operator++() {
      left_ &= left_ - 1;
      skip();
      return *this;
    }
    Iterator operator++(int) {
      Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) {
      return a.at_ == b.at_ && a.left_ == b.left_;
    }

   private:
    void skip() {
      while (left_ == 0 && at_ < set_->words()) left_ = set_->word(++at_);
    }

    const IndexSet* set_ = nullptr;
    std::size_t at_ = 0;
    Word left_ = 0;  // remaining bits of the word
  };

  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, words()}; }

  /// Number of words; words beyond the last are zero.
  [[nodiscard]] std::size_t words() const { return 1 + rest_.size(); }
  [[nodiscard]] Word word(std::size_t k) const {
    return k == 0 ? first_ : k <= rest_.size() ? rest_[k - 1] : 0;
  }
  void set_word(std::size_t k, Word value) {
    if (value == 0 && k >= words()) return;  // leading zeros
    grow_to(k) = value;
    trim();
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& first_& rest_;
    trim();  // also after an error of reading
  }

 private:
  static constexpr int bits = 64;
  static std::size_t at(int index) { return static_cast<std::size_t>(index) / bits; }
  static Word bit(int index) { return Word{1} << static_cast<unsigned>(index % bits); }

  Word& grow_to(std::size_t k) {
    if (k == 0) return first_;
    if (rest_.size() < k) rest_.resize(k);
    return rest_[k - 1];
  }

  // Removes zero words at the end, so that equal sets have equal words.
  IndexSet& trim() {
    while (!rest_.empty() && rest_.back() == 0) rest_.pop_back();
    return *this;
  }

  Word first_ = 0;
  std::vector<Word> rest_;  // the numbers from 64 on; its last word is not zero
};

/// The set as a hexadecimal number with a one bit for each element; "0" if it is empty.
std::string hexadecimal(const IndexSet& set);

}  // namespace kusabi::support
