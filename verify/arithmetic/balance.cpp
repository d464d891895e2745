// With D = diag(room) the result is c + D^2 R z, where R'D^2 R z = -R'c: the smallest change in the
// sum of squares relative to the room. The approximate variant adds a small number to the diagonal
// of R'D^2 R, which excludes directions with smaller diagonal entries.
#include "verify/arithmetic/balance.hpp"

#include <cstddef>
#include <utility>

namespace kusabi::verify {
namespace {

std::optional<Rationals> changed(const std::vector<Rationals>& rows, Rationals numbers,
                                 const std::vector<double>& room, const mpq_class& added_share) {
  if (rows.empty() || rows.front().empty()) return numbers;
  const auto q = rows.front().size();
  std::vector<Rationals> products(q, Rationals(q));
  Rationals right(q);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& row = rows[k];
    const mpq_class weight = mpq_class(room[k]) * mpq_class(room[k]);
    for (std::size_t i = 0; i < q; ++i) {
      if (sgn(row[i]) == 0) continue;
      right[i] -= numbers[k] * row[i];
      const mpq_class weighted = weight * row[i];
      for (std::size_t j = 0; j <= i; ++j) products[i][j] += weighted * row[j];
    }
  }
  for (std::size_t i = 0; i < q; ++i) {
    for (std::size_t j = i + 1; j < q; ++j) products[i][j] = products[j][i];
  }
  mpq_class largest;
  for (std::size_t i = 0; i < q; ++i) {
    if (products[i][i] > largest) largest = products[i][i];
  }
  for (std::size_t i = 0; i < q; ++i) products[i][i] += added_share * largest;
  const auto multipliers = solution(std::move(products), right);
  if (!multipliers) return {};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (room[k] != 0)
      numbers[k] += mpq_class(room[k]) * mpq_class(room[k]) * verify::dot(rows[k], *multipliers);
  }
  return numbers;
}

}  // namespace

std::optional<Rationals> balanced(const std::vector<Rationals>& rows, Rationals numbers,
                                  const std::vector<double>& room) {
  return changed(rows, std::move(numbers), room, 0);
}

std::optional<Rationals> nearly_balanced(const std::vector<Rationals>& rows, Rationals numbers,
                                         const std::vector<double>& room) {
  constexpr double hardly = 0x1p-64;  // share of the largest diagonal entry
  return changed(rows, std::move(numbers), room, hardly);
}

}  // namespace kusabi::verify
