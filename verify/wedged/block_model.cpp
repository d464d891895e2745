// Springs, coefficients of modes, and combinations of loads.
#include "verify/wedged/block_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/arithmetic/least_squares.hpp"

namespace kusabi::verify {

using support::IndexSet;

namespace {

// Maximum number of regularised stiffnesses in the cache; each is as large as K.
constexpr std::size_t max_kept = 6;

// A rigid-body mode slides along U if its normal displacements on U are below this share of its
// others. An example is the rotation of a conical plug about its axis with rounded normals.
constexpr double nearly_sliding = 0x1p-40;

DyadicList times(const DyadicList& list, const Dyadic& factor) {
  DyadicList result(list.size());
  result.exponent = list.exponent + factor.exponent();
  const mpz_class own = factor.multiples(factor.exponent());
  for (std::size_t k = 0; k < list.size(); ++k) result.mantissas[k] = list.mantissas[k] * own;
  return result;
}

}  // namespace

BlockModel::BlockModel(ContactBlock block) : block_(std::move(block)) {
  Dyadic steepest(1.0);
  for (const double mu : block_.friction) {
    friction_.emplace_back(mu);
    steepest = larger(steepest, Dyadic(1.0) + square(friction_.back()));
  }
  steepest_ = sqrt_above(steepest);
  near_motions_ = block_.motions.nearest();
  const auto p = motions();
  const auto [springs, sliding] = grounding({});
  if (springs.size() != p) return;  // the modes are dependent
  // Column by column: the recorded mode as a combination of the block's modes.
  own_of_recorded_.resize(p * p);
  for (std::size_t column = 0; column < p; ++column) {
    std::vector<double> motion;
    for (std::size_t at = column; at < block_.recorded_motions.size(); at += p)
      motion.push_back(block_.recorded_motions[at]);
    const auto own = least_squares(near_motions_, motion);
    if (!own) return;
    for (std::size_t k = 0; k < p; ++k) own_of_recorded_[p * k + column] = (*own)[k];
  }
  minimum_ = regularised(springs).min_eigenvalue();
}

void BlockModel::add_largest_rows(const std::vector<std::size_t>& rows, double negligible,
                                  Elimination& rest, std::vector<std::size_t>& chosen) const {
  std::optional<double> first;
  while (!rest.basis().empty()) {
    std::optional<double> maximum;
    std::size_t best = 0;
    for (const auto row : rows) {
      for (const auto& product : rest.products(block_.motions.rows[row])) {
        const double size = std::abs(product.get_d()) / block_.motions.lengths[row].nearest();
        if (sgn(product) == 0 || (maximum && size <= *maximum)) continue;
        maximum = size;
        best = row;
      }
    }
    if (!maximum || (first && *maximum <= negligible * *first)) return;
    if (!first) first = maximum;
    rest.add_equation(block_.motions.rows[best]);
    chosen.push_back(best);
  }
}

Grounding BlockModel::grounding(const IndexSet& contact) const {
  const auto d = block_.dimension;
  Grounding result;
  if (motions() == 0) return result;
  std::vector<std::size_t> normals;
  std::vector<std::size_t> others;
  for (std::size_t row = 0; row < d * candidates(); ++row) {
    auto& list = row % d == 0 && contains(contact, row / d) ? normals : others;
    list.push_back(row);
  }
  Elimination rest(motions());
  add_largest_rows(normals, nearly_sliding, rest, result.springs);
  result.sliding = rest.basis();
  add_largest_rows(others, 0, rest, result.springs);
  std::sort(result.springs.begin(), result.springs.end());
  return result;
}

const RegularisedStiffness& BlockModel::regularised(const std::vector<std::size_t>& springs) const {
  for (const auto& each : regularised_) {
    if (each.springs() == springs) return each;
  }
  if (regularised_.size() == max_kept) regularised_.pop_back();
  regularised_.emplace_back(block_.stiffness, springs);
  return regularised_.back();
}

// The springs act on normal displacements of U: no rigid-body mode leaves all of these zero.
const RegularisedStiffness* BlockModel::regularised_at_normals(const IndexSet& contact) const {
  const auto d = block_.dimension;
  for (const auto& each : regularised_) {
    const bool all = std::all_of(each.springs().begin(), each.springs().end(), [&](auto row) {
      return row % d == 0 && contains(contact, row / d);
    });
    if (all) return &each;
  }
  return nullptr;
}

Dyadic BlockModel::tangential_square(const DyadicList& vector, std::size_t candidate) const {
  const auto d = block_.dimension;
  Dyadic sum;
  for (std::size_t k = 1; k < d; ++k) sum = sum + square(vector[d * candidate + k]);
  return sum;
}

std::vector<double> BlockModel::own_coefficients(std::span<const double> recorded) const {
  const auto p = motions();
  std::vector<double> own(p, 0);
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < p; ++j) own[i] += own_of_recorded_[p * i + j] * recorded[j];
  }
  return own;
}

Rationals BlockModel::missing_motion(const std::vector<double>& mean, const DyadicList& x,
                                     const std::vector<Rationals>& among) const {
  const auto p = motions();
  const auto rows = block_.motions.rows.size();
  std::vector<double> moves;  // displacements by the given modes, by rows
  std::vector<double> rest(rows, 0);
  for (std::size_t row = 0; row < rows; ++row) {
    const auto own = std::span(near_motions_).subspan(p * row, p);
    rest[row] = -x[row].nearest();
    for (std::size_t k = 0; k < p; ++k) rest[row] += own[k] * mean[k];
    for (const auto& motion : among) {
      double sum = 0;
      for (std::size_t k = 0; k < p; ++k) sum += own[k] * motion[k].get_d();
      moves.push_back(sum);
    }
  }
  const auto shares = least_squares(moves, rest);
  Rationals result(p);
  for (std::size_t j = 0; shares && j < among.size(); ++j) {
    if (!std::isfinite((*shares)[j])) continue;
    for (std::size_t k = 0; k < p; ++k) result[k] += mpq_class((*shares)[j]) * among[j][k];
  }
  return result;
}

Dyadic BlockModel::slip_above(const DyadicList& w, std::size_t candidate,
                              const Dyadic& error) const {
  const auto& mu = friction_[candidate];
  const auto off =
      error * (Dyadic(1.0) + mu.scaled(1));  // bound of |w_t| for at most two components
  return sqrt_above(square(mu) * tangential_square(w, candidate)) + off;
}

ActingLoad BlockModel::acting(LoadShare share) const {
  const Dyadic dead(share.dead);
  const Dyadic reference(share.reference);
  ActingLoad load{times(block_.loads[0].forces, dead), {}, dead, {}, {}};
  load.forces += times(block_.loads[1].forces, reference);
  load.error = absolute(dead) * block_.loads[0].error + absolute(reference) * block_.loads[1].error;
  load.gaps = times(DyadicList(block_.clearance), dead);
  for (std::size_t mode = 0; mode < motions(); ++mode) {
    load.work.emplace_back(mpq_class(share.dead) * block_.loads[0].work[mode] +
                           mpq_class(share.reference) * block_.loads[1].work[mode]);
  }
  return load;
}

std::vector<double> BlockModel::displacements_by(const std::vector<double>& motion) const {
  std::vector<double> displacements(block_.dimension * candidates(), 0);
  for (std::size_t row = 0; row < displacements.size(); ++row)
    for (std::size_t mode = 0; mode < motions(); ++mode)
      displacements[row] += near_motions_[motions() * row + mode] * motion[mode];
  return displacements;
}

bool BlockModel::resists_all_motions(const IndexSet& contact) const {
  const auto d = block_.dimension;
  Elimination free(motions());
  for (const int i : contact) {
    const auto own = static_cast<std::size_t>(i);
    const std::size_t directions = block_.friction[own] == 0 ? 1 : d;
    for (std::size_t k = 0; k < directions; ++k)
      free.add_equation(block_.motions.rows[d * own + k]);
  }
  return free.basis().empty();
}

}  // namespace kusabi::verify
