// The order of unknowns is chosen for a small profile.
#include "verify/limit/gram.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "verify/arithmetic/reverse_cuthill_mckee.hpp"

namespace kusabi::verify {
namespace {

// Memory for the factor of one truss: 400 MB.
constexpr std::size_t largest_profile = 50'000'000;

}  // namespace

Gram::Gram(const std::vector<Sparse>& columns, const std::vector<std::size_t>& members,
           const std::vector<double>& weight, const std::vector<std::size_t>& displacements,
           std::size_t count, double shift) {
  const auto n = displacements.size();
  place_.resize(count);
  std::vector<std::size_t> local(count);
  for (std::size_t k = 0; k < n; ++k) local[displacements[k]] = k;
  std::vector<std::map<std::size_t, double>> entries(n);
  for (const auto i : members) {
    for (const auto& [row, a] : columns[i]) {
      for (const auto& [other, b] : columns[i]) {
        entries[local[row]][local[other]] += weight[i] * a * b;
      }
    }
  }
  std::vector<std::vector<std::size_t>> neighbours(n);
  for (std::size_t row = 0; row < n; ++row) {
    for (const auto& [other, value] : entries[row]) {
      if (other != row) neighbours[row].push_back(other);
    }
  }
  const auto order = reverse_cuthill_mckee(neighbours);
  std::vector<std::size_t> place(n);
  for (std::size_t at = 0; at < n; ++at) place[order[at]] = at;
  for (std::size_t k = 0; k < n; ++k) place_[displacements[k]] = place[k];
  std::vector<std::size_t> first(n);
  for (std::size_t at = 0; at < n; ++at) {
    first[at] = at;
    for (const auto& [other, value] : entries[order[at]]) {
      first[at] = std::min(first[at], place[other]);
    }
  }
  const Profile profile(std::move(first));
  if (profile.entries() > largest_profile) return;
  std::vector<double> matrix(profile.entries(), 0.0);
  diagonal_.resize(n);
  for (std::size_t at = 0; at < n; ++at) {
    for (const auto& [other, value] : entries[order[at]]) {
      if (place[other] < at) matrix[profile.at(at, place[other])] = value;
      if (place[other] != at) continue;
      diagonal_[at] = value;
      matrix[profile.at(at, at)] = value * (1 + shift);
    }
  }
  factor_ = Cholesky::of(profile, matrix);
}

}  // namespace kusabi::verify
