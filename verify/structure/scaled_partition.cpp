// Powers of two on both sides make the diagonal about one, and the order of the unknowns makes the
// factor narrow.
#include "verify/structure/scaled_partition.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "verify/arithmetic/reverse_cuthill_mckee.hpp"

namespace kusabi::verify {
namespace {

// Half of the exponent of a diagonal entry: scaling with 2^-this on both sides makes it about 1.
long half_exponent(const Dyadic& value) {
  return static_cast<long>(std::floor(static_cast<double>(value.magnitude()) / 2));
}

// Position of each free displacement in C or N.
struct Places {
  std::vector<std::size_t> place;
  std::vector<bool> is_contact;
};

Places order_unknowns(const CandidateRows& rows, PartitionedStiffness& parts) {
  const auto count = rows.freedom.count;
  Places places{std::vector<std::size_t>(count), std::vector<bool>(count)};
  auto& [place, is_contact] = places;
  for (const auto& numbers : rows.seen) {
    for (const auto number : numbers) {
      is_contact[number] = true;
      place[number] = parts.contact++;
    }
  }
  std::vector<std::size_t> rest;
  for (std::size_t number = 0; number < count; ++number) {
    if (is_contact[number]) continue;
    place[number] = rest.size();
    rest.push_back(number);
  }
  std::vector<std::vector<std::size_t>> neighbours(rest.size());
  for (std::size_t at = 0; at < rest.size(); ++at) {
    for (const auto& [column, value] : rows.stiffness[rest[at]]) {
      if (!is_contact[column] && column != rest[at]) neighbours[at].push_back(place[column]);
    }
  }
  std::size_t next = 0;
  for (const auto at : reverse_cuthill_mckee(neighbours)) place[rest[at]] = next++;
  parts.rest = rest.size();
  return places;
}

}  // namespace

std::variant<PartitionedStiffness, std::string> scaled_partition(const CandidateRows& rows) {
  const auto& stiffness = rows.stiffness;
  for (std::size_t row = 0; row < stiffness.size(); ++row) {
    const auto diagonal = stiffness[row].find(row);
    if (diagonal == stiffness[row].end()) return too_ill_conditioned;
    for (const auto& [column, value] : stiffness[row]) {
      if (!value.finite()) return std::string("a bar has no length, or an element no area");
    }
    if (diagonal->second.lower().sign() <= 0) return too_ill_conditioned;
  }
  PartitionedStiffness parts;
  const auto [place, is_contact] = order_unknowns(rows, parts);
  // N: each displacement has its own scale. C: all have the same, so that the error bound needs
  // no weighted norm.
  std::vector<long> scale(rows.freedom.count);
  std::optional<long> largest;
  for (std::size_t row = 0; row < rows.freedom.count; ++row) {
    scale[row] = half_exponent(stiffness[row].at(row).lower());
    if (is_contact[row]) largest = std::max(largest.value_or(scale[row]), scale[row]);
  }
  parts.contact_scale = *largest;
  for (std::size_t row = 0; row < rows.freedom.count; ++row) {
    if (is_contact[row]) scale[row] = *largest;
  }
  parts.contact_contact.resize(parts.contact);
  parts.rest_contact.resize(parts.rest);
  parts.rest_rest.resize(parts.rest);
  for (std::size_t row = 0; row < rows.freedom.count; ++row) {
    for (const auto& [column, value] : stiffness[row]) {
      const long shift = -scale[row] - scale[column];
      GridEntry entry{place[column], value.lower().scaled(shift).multiples(stiffness_grid)};
      const auto error = value.upper().scaled(shift) - Dyadic(entry.value, stiffness_grid);
      parts.error_square = parts.error_square + square(error);
      if (is_contact[row] && !is_contact[column]) continue;  // its transpose
      auto& part = is_contact[row]      ? parts.contact_contact
                   : is_contact[column] ? parts.rest_contact
                                        : parts.rest_rest;
      part[place[row]].push_back(std::move(entry));
    }
  }
  return parts;
}

}  // namespace kusabi::verify
