// Components of rational rigid-body modes along the directions of candidates: only the division of
// directions by their lengths is irrational.
#include "verify/structure/contact_motions.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "verify/arithmetic/enclosure.hpp"
#include "verify/structure/unconstrained_bodies.hpp"

namespace kusabi::verify {
namespace {

// The directions n, t1[, t2] before normalisation, and their lengths.
struct Directions {
  std::vector<Rationals> vectors;
  std::vector<Enclosure> lengths;
};

template <class Number>
std::vector<std::vector<Number>> directions(const ContactPoint& point, std::size_t d) {
  using Components = std::vector<Number>;
  Components n;
  Vector axis{};
  axis[point.tangent_axis] = 1;
  const Vector unprojected = point.tangent.value_or(axis);
  Number square(0.0);
  Number along(0.0);
  for (std::size_t k = 0; k < d; ++k) {
    n.emplace_back(point.normal[k]);
    square = Number(square + n[k] * n[k]);
    along = Number(along + n[k] * Number(unprojected[k]));
  }
  if (d == 2 && !point.tangent) return {n, {n[1], Number(-n[0])}};
  Components t;
  for (std::size_t k = 0; k < d; ++k)
    t.push_back(Number(square * Number(unprojected[k]) - along * n[k]));
  if (d == 2) return {n, t};
  Components last;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = (k + 1) % 3;
    const auto j = (k + 2) % 3;
    last.push_back(Number(n[i] * t[j] - n[j] * t[i]));
  }
  return {n, t, last};
}

Directions directions_of(const ContactPoint& point, std::size_t d) {
  Directions result{directions<mpq_class>(point, d), {}};
  for (const auto& vector : directions<Enclosure>(point, d)) {
    Enclosure square;
    for (const auto& component : vector) square += component * component;
    result.lengths.push_back(sqrt(square));
  }
  return result;
}

mpq_class times_power(mpq_class number, int exponent) {
  auto* const own = number.get_mpq_t();
  if (exponent >= 0) {
    mpq_mul_2exp(own, own, static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(own, own, static_cast<mp_bitcnt_t>(-exponent));
  }
  return number;
}

// Scales each column by a power of two such that its largest entry is about 1.
std::vector<int> scale_columns(ContactMotions& motions) {
  std::vector<int> shifts(motions.count, 0);
  for (std::size_t k = 0; k < motions.count; ++k) {
    double largest = 0;
    for (std::size_t row = 0; row < motions.rows.size(); ++row) {
      const auto size = std::abs(motions.rows[row][k].get_d());
      largest = std::max(largest, size / motions.lengths[row].nearest());
    }
    if (!(largest > 0) || !std::isfinite(largest)) continue;
    shifts[k] = -std::ilogb(largest);
    for (auto& row : motions.rows) row[k] = times_power(row[k], shifts[k]);
  }
  return shifts;
}

}  // namespace

std::vector<double> ContactMotions::nearest() const {
  std::vector<double> result;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const auto& value : rows[row]) result.push_back(value.get_d() / lengths[row].nearest());
  }
  return result;
}

namespace {

// The numbers, each with an error relative to its size, rounded to a grid far below the largest.
ApproximateList on_a_grid(const Rationals& numbers, const Dyadic& share) {
  constexpr long digits = 256;
  long largest = 0;
  bool any = false;
  for (const auto& number : numbers) {
    if (sgn(number) == 0) continue;
    const long magnitude = static_cast<long>(mpz_sizeinbase(number.get_num_mpz_t(), 2)) -
                           static_cast<long>(mpz_sizeinbase(number.get_den_mpz_t(), 2)) + 1;
    largest = any ? std::max(largest, magnitude) : magnitude;
    any = true;
  }
  ApproximateList result{DyadicList(numbers.size()), {}};
  if (!any) return result;
  const long grid = largest - digits;
  result.values.exponent = grid;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    mpq_class scaled = numbers[k];
    if (grid >= 0) {
      mpq_div_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(grid));
    } else {
      mpq_mul_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(-grid));
    }
    mpz_fdiv_q(result.values.mantissas[k].get_mpz_t(), scaled.get_num_mpz_t(),
               scaled.get_den_mpz_t());
  }
  // Twice the share, since it is relative to the approximate number instead of the exact one.
  result.error = Dyadic(mpz_class(1), grid) + share.scaled(1) * Dyadic(mpz_class(1), largest);
  return result;
}

}  // namespace

ApproximateList times_lengths(const ContactMotions& motions, const Rationals& numbers) {
  Rationals products(numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (sgn(numbers[k]) != 0) products[k] = numbers[k] * motions.lengths[k].rational();
  }
  return on_a_grid(products, motions.spread);
}

ApproximateList restricted_to_candidates(const ContactMotions& motions,
                                         const Rationals& coefficients) {
  Rationals quotients(motions.rows.size());
  for (std::size_t k = 0; k < motions.rows.size(); ++k) {
    quotients[k] = dot(motions.rows[k], coefficients);
    if (sgn(quotients[k]) != 0) quotients[k] /= motions.lengths[k].rational();
  }
  return on_a_grid(quotients, motions.spread);
}

namespace {

// Modes that displace candidates, and the others; the scales of the former are those of
// scale_columns().
struct SplitModes {
  std::vector<Rationals> of_candidates;
  std::vector<Rationals> others;
};

SplitModes split_modes(const Structure& structure, const UnconstrainedBodies& bodies,
                       std::vector<Rationals>& seen_rows) {
  for (const auto& point : structure.contact) {
    for (std::size_t axis = 0; axis < structure.dimension; ++axis)
      seen_rows.push_back(bodies.at(point, axis));
  }
  // Their doubles are compared with the modes of a certificate, so modes of long levers must not be
  // nearly equal.
  Elimination visible(bodies.motions());
  visible.add_equations_largest_first(seen_rows);
  return {visible.removed(), visible.basis()};
}

// Sum of the magnitudes of force times those of the displacement by a mode, over the nodes: of work
// that cancels, too, since positions and directions have sixteen digits.
double size_of_work(const Structure& structure, const UnconstrainedBodies& bodies,
                    const std::vector<Force>& load, const Rationals& mode) {
  double size = 0;
  for (const auto& [node, components] : load) {
    double force = 0;
    double displacement = 0;
    for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
      force = std::hypot(force, components[axis]);
      displacement = std::hypot(displacement, dot(bodies.at(node, axis), mode).get_d());
    }
    size += force * displacement;
  }
  return size;
}

}  // namespace

UnconstrainedModes unconstrained_modes(const Structure& structure) {
  const auto d = structure.dimension;
  UnconstrainedModes result;
  auto& seen = result.of_candidates;
  std::vector<Directions> frames;
  for (const auto& point : structure.contact) {
    frames.push_back(directions_of(point, d));
    for (const auto& length : frames.back().lengths) {
      seen.lengths.push_back(length.lower());
      seen.spread =
          larger(seen.spread, quotient_above(length.upper() - length.lower(), length.lower()));
    }
  }
  seen.rows.resize(seen.lengths.size());
  const UnconstrainedBodies bodies(structure);
  if (bodies.motions().empty()) return result;
  std::vector<Rationals> seen_rows;
  const auto [columns, unseen] = split_modes(structure, bodies, seen_rows);
  result.others = bodies.grounding_springs(Elimination(unseen));
  seen.count = columns.size();
  for (auto& row : seen.rows) row.resize(seen.count);
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const std::span rows(seen_rows.data() + d * i, d);
    for (std::size_t column = 0; column < columns.size(); ++column) {
      Rationals moves;
      for (const auto& row : rows) moves.push_back(dot(row, columns[column]));
      for (std::size_t k = 0; k < d; ++k)
        seen.rows[d * i + k][column] = dot(frames[i].vectors[k], moves);
    }
  }
  seen.shifts = scale_columns(seen);
  return result;
}

bool LoadWork::is_unbalanced() const {
  return std::ranges::any_of(others, [](const auto& work) { return sgn(work) != 0; });
}

std::vector<LoadWork> works_of(const Structure& structure, const ContactMotions& seen,
                               const std::vector<std::vector<Force>>& loads) {
  const UnconstrainedBodies bodies(structure);
  std::vector<LoadWork> result(loads.size());
  if (bodies.motions().empty()) return result;
  std::vector<Rationals> seen_rows;
  const auto modes = split_modes(structure, bodies, seen_rows);
  for (std::size_t load = 0; load < loads.size(); ++load) {
    Rationals moved(bodies.motions().front().size());  // sum of force times displacement
    for (const auto& [node, components] : loads[load]) {
      for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
        const auto row = bodies.at(node, axis);
        for (std::size_t k = 0; k < row.size(); ++k)
          if (sgn(row[k]) != 0) moved[k] += mpq_class(components[axis]) * row[k];
      }
    }
    for (std::size_t k = 0; k < modes.of_candidates.size(); ++k)
      result[load].of_candidates.push_back(
          times_power(dot(moved, modes.of_candidates[k]), seen.shifts[k]));
    for (const auto& mode : modes.others) {
      result[load].others.push_back(dot(moved, mode));
      result[load].sizes_of_others.push_back(size_of_work(structure, bodies, loads[load], mode));
    }
  }
  return result;
}

ContactMotions recorded_motions(const std::vector<double>& values, std::size_t count) {
  ContactMotions motions;
  motions.count = count;
  if (count == 0) return motions;
  for (std::size_t at = 0; at < values.size(); at += count) {
    auto& row = motions.rows.emplace_back();
    for (std::size_t k = 0; k < count; ++k) row.emplace_back(values[at + k]);
    motions.lengths.emplace_back(1.0);
  }
  return motions;
}

std::vector<std::size_t> columns_of(const ContactMotions& motions,
                                    const std::vector<std::size_t>& rows) {
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < motions.count; ++k) {
    const bool moves = std::any_of(rows.begin(), rows.end(),
                                   [&](auto row) { return sgn(motions.rows[row][k]) != 0; });
    if (moves) columns.push_back(k);
  }
  return columns;
}

ContactMotions part_of(const ContactMotions& motions, const std::vector<std::size_t>& rows) {
  ContactMotions part;
  part.spread = motions.spread;
  if (motions.count == 0) return part;
  const auto columns = columns_of(motions, rows);
  part.count = columns.size();
  for (const auto row : rows) {
    auto& own = part.rows.emplace_back();
    for (const auto k : columns) own.push_back(motions.rows[row][k]);
    part.lengths.push_back(motions.lengths[row]);
  }
  return part;
}

}  // namespace kusabi::verify
