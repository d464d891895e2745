// A basis of a linear program, small enough to travel with a node of a tree: two bits a row or
// column. It says which rows and columns are basic and at which bound the others lie; all else the
// simplex method finds again from the program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <boost/serialization/vector.hpp>

namespace kusabi::linear {

/// Where a row or column lies. One without the bound in question lies at the other, or at zero.
enum class Place : std::uint8_t { basic = 0, lower = 1, upper = 2 };

class Basis {
 public:
  Basis() = default;  ///< of no program: stands for "none known"
  Basis(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), bits_((rows + columns + 3) / 4) {}

  [[nodiscard]] bool empty() const { return bits_.empty(); }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }

  [[nodiscard]] Place row(std::size_t i) const { return at(i); }
  [[nodiscard]] Place column(std::size_t j) const { return at(rows_ + j); }
  void set_row(std::size_t i, Place place) { set(i, place); }
  void set_column(std::size_t j, Place place) { set(rows_ + j, place); }

  friend bool operator==(const Basis&, const Basis&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& rows_& columns_& bits_;
  }

 private:
  [[nodiscard]] Place at(std::size_t k) const {
    return static_cast<Place>((bits_[k / 4] >> (2 * (k % 4))) & 3U);
  }
  void set(std::size_t k, Place place) {
    const auto shift = static_cast<unsigned>(2 * (k % 4));
    const auto rest = static_cast<unsigned>(bits_[k / 4]) & ~(3U << shift);
    bits_[k / 4] = static_cast<std::uint8_t>(rest | (static_cast<unsigned>(place) << shift));
  }

  std::uint64_t rows_ = 0;
  std::uint64_t columns_ = 0;
  std::vector<std::uint8_t> bits_;
};

}  // namespace kusabi::linear
