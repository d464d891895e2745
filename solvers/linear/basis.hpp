// Basis: a basis of a linear program with two bits per row or column, small enough to be sent with
// a node of a tree. It states which rows and columns are basic and at which bound the others are;
// the simplex method recomputes the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <boost/serialization/vector.hpp>

namespace kusabi::linear {

/// Status of a row or column. A nonbasic one without the bound in question is at its other bound,
/// or at zero.
enum class BasisStatus : std::uint8_t { basic = 0, lower = 1, upper = 2 };

class Basis {
 public:
  Basis() = default;  ///< the basis of no program: unknown
  Basis(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), bits_((rows + columns + 3) / 4) {}

  [[nodiscard]] bool empty() const { return bits_.empty(); }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }

  [[nodiscard]] BasisStatus row(std::size_t i) const { return at(i); }
  [[nodiscard]] BasisStatus column(std::size_t j) const { return at(rows_ + j); }
  void set_row(std::size_t i, BasisStatus place) { set(i, place); }
  void set_column(std::size_t j, BasisStatus place) { set(rows_ + j, place); }

  friend bool operator==(const Basis&, const Basis&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& rows_& columns_& bits_;
  }

 private:
  [[nodiscard]] BasisStatus at(std::size_t k) const {
    return static_cast<BasisStatus>((bits_[k / 4] >> (2 * (k % 4))) & 3U);
  }
  void set(std::size_t k, BasisStatus place) {
    const auto shift = static_cast<unsigned>(2 * (k % 4));
    const auto rest = static_cast<unsigned>(bits_[k / 4]) & ~(3U << shift);
    bits_[k / 4] = static_cast<std::uint8_t>(rest | (static_cast<unsigned>(place) << shift));
  }

  std::uint64_t rows_ = 0;
  std::uint64_t columns_ = 0;
  std::vector<std::uint8_t> bits_;
};

}  // namespace kusabi::linear
