// Sorted entries, so that duplicates and transposed entries are found.
#include "problems/files/matrices/matrix_data.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

/// Significant digits; 0 for an integer, which is exact.
int digits_of(std::string_view text) {
  if (text.find_first_of(".eEdD") == std::string_view::npos) return 0;
  const auto mantissa = text.substr(0, text.find_first_of("eEdD"));
  int digits = 0;
  for (const char character : mantissa) {
    const bool is_digit = character >= '0' && character <= '9';
    if (is_digit && (digits > 0 || character != '0')) ++digits;
  }
  return digits;
}

double rounding(int digits) {
  if (digits <= max_exact_digits || digits > max_rounded_digits) return 0;
  return 0.5 * std::pow(10.0, 1 - digits);
}

class SymmetryCheck {
 public:
  explicit SymmetryCheck(MatrixData data) : data_(std::move(data)) {}

  SymmetricMatrix result();

 private:
  using Triplets = std::vector<Eigen::Triplet<double>>;

  void sort_entries();
  void set_diagonal();
  void add_pair(const MatrixEntry& entry, Triplets& entries);
  const MatrixEntry* find(int row, int column) const;
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw support::InputError(data_.file, {line, 1}, message);
  }

  MatrixData data_;
  std::vector<double> roots_;  // square roots of the diagonal
  double max_asymmetry_ = 0;
};

bool before(const MatrixEntry& one, const MatrixEntry& other) {
  return std::tie(one.column, one.row, one.line) < std::tie(other.column, other.row, other.line);
}

void SymmetryCheck::sort_entries() {
  auto& entries = data_.entries;
  for (MatrixEntry& entry : entries) {
    if (data_.one_triangle && entry.row < entry.column) std::swap(entry.row, entry.column);
  }
  std::ranges::sort(entries, before);
  const auto twice = std::ranges::adjacent_find(entries, [](const auto& one, const auto& other) {
    return one.row == other.row && one.column == other.column;
  });
  if (twice == entries.end()) return;
  const auto& second = *(twice + 1);
  fail(second.line, fmt::format("entry ({}, {}) is given twice, first on line {}; expected once{}",
                                second.row + 1, second.column + 1, twice->line,
                                data_.one_triangle ? ", in one of the two triangles" : ""));
}

const MatrixEntry* SymmetryCheck::find(int row, int column) const {
  const auto found = std::ranges::lower_bound(
      data_.entries, std::pair(column, row), {},
      [](const MatrixEntry& entry) { return std::pair(entry.column, entry.row); });
  const bool is_there =
      found != data_.entries.end() && found->row == row && found->column == column;
  return is_there ? &*found : nullptr;
}

void SymmetryCheck::set_diagonal() {
  for (int row = 0; row < data_.size; ++row) {
    const MatrixEntry* own = find(row, row);
    const double value = own == nullptr ? 0 : own->value;
    if (!(value > 0)) {
      fail(own == nullptr ? data_.size_line : own->line,
           fmt::format("entry ({0}, {0}), on the diagonal, is {1}; expected a positive stiffness",
                       row + 1, own == nullptr ? "missing" : fmt::format("{:g}", value)));
    }
    roots_.push_back(std::sqrt(value));
  }
}

// The first stored entry of a transposed pair adds both.
void SymmetryCheck::add_pair(const MatrixEntry& entry, Triplets& entries) {
  const int row = entry.row;
  const int column = entry.column;
  const double value = entry.value;
  const auto add = [&](double both) {
    entries.emplace_back(row, column, both);
    if (row != column) entries.emplace_back(column, row, both);
  };
  if (data_.one_triangle || row == column) return add(value);
  const MatrixEntry* other = find(column, row);
  if (other != nullptr && row < column) return;
  const double across = other == nullptr ? 0 : other->value;
  const double root =
      roots_[static_cast<std::size_t>(row)] * roots_[static_cast<std::size_t>(column)];
  const double off = std::abs(value - across) / root;
  if (!(off <= largest_asymmetry)) {
    fail(entry.line,
         fmt::format("entry ({}, {}) is {:.10g}, but ({}, {}) is {:.10g}, which is {:.2g} of "
                     "the root of their diagonal entries' product off; expected a symmetric "
                     "matrix",
                     row + 1, column + 1, value, column + 1, row + 1, across, off));
  }
  max_asymmetry_ = std::max(max_asymmetry_, off);
  add(value == across ? value : value / 2 + across / 2);
}

SymmetricMatrix SymmetryCheck::result() {
  sort_entries();
  set_diagonal();
  Triplets entries;
  entries.reserve(data_.entries.size() * (data_.one_triangle ? 2 : 1));
  for (const MatrixEntry& entry : data_.entries) add_pair(entry, entries);
  SymmetricMatrix result;
  result.matrix.resize(data_.size, data_.size);
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  result.rounding = rounding(data_.digits);
  if (max_asymmetry_ > 0) {
    result.warning =
        support::InputError(data_.file, {},
                            fmt::format("the matrix deviates from symmetry by {:.2g} of its "
                                        "diagonal; the means of entries ij and ji are used",
                                        max_asymmetry_))
            .what();
  }
  return result;
}

}  // namespace

void MatrixData::add(MatrixEntry entry, std::string_view text) {
  if (entry.value != 0) digits = std::max(digits, digits_of(text));
  entries.push_back(entry);
}

SymmetricMatrix symmetric_matrix(MatrixData data) {
  return SymmetryCheck(std::move(data)).result();
}

}  // namespace kusabi::problems
