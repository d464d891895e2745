// Springs, coefficients of modes, and combinations of loads.
#include "verify/wedged/block_model.hpp"

#include <algorithm>
#include <array>
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

// Elimination of modes by the rows of G with the largest products, with complete pivoting. Doubles
// are too few digits for a body with a long lever, and rational numbers too many for a hundred
// bodies.
class LargestRows {
 public:
  explicit LargestRows(const ContactMotions& motions) {
    for (std::size_t k = 0; k < motions.count; ++k) {
      auto& mode = modes_.emplace_back();
      mode.coefficients.assign(motions.count, Number(0, digits));
      mode.coefficients[k] = 1;
      for (std::size_t row = 0; row < motions.rows.size(); ++row) {
        mode.displacements.emplace_back(motions.rows[row][k], digits);
        mode.displacements.back() /= Number(motions.lengths[row].rational(), digits);
      }
    }
  }

  /// Those of some rows that remove a mode, until the displacements of the others in these rows are
  /// at most a share of all that are left at first.
  std::vector<std::size_t> take(const std::vector<std::size_t>& rows, double negligible) {
    std::vector<std::size_t> taken;
    double largest = 0;
    for (const auto& mode : modes_)
      for (const auto& each : mode.displacements)
        largest = std::max(largest, std::abs(each.get_d()));
    while (!modes_.empty()) {
      double maximum = 0;
      std::size_t best = 0;
      auto pivot = modes_.end();
      for (auto mode = modes_.begin(); mode != modes_.end(); ++mode) {
        for (const auto row : rows) {
          const double size = std::abs(mode->displacements[row].get_d());
          if (!(size > maximum)) continue;
          maximum = size;
          best = row;
          pivot = mode;
        }
      }
      if (maximum <= negligible * largest) break;
      remove(pivot, best);
      taken.push_back(best);
    }
    return taken;
  }

  /// The modes that are left.
  [[nodiscard]] std::vector<Rationals> left() const {
    std::vector<Rationals> result;
    for (const auto& mode : modes_)
      result.emplace_back(mode.coefficients.begin(), mode.coefficients.end());
    return result;
  }

 private:
  using Number = mpf_class;
  static constexpr mp_bitcnt_t digits = 256;

  struct Mode {
    std::vector<Number> coefficients, displacements;
  };

  void remove(std::vector<Mode>::iterator pivot, std::size_t row) {
    const Mode removed = std::move(*pivot);
    modes_.erase(pivot);
    for (auto& mode : modes_) {
      if (sgn(mode.displacements[row]) == 0) continue;
      const Number factor = mode.displacements[row] / removed.displacements[row];
      const auto subtract = [&](auto& from, const auto& what) {
        for (std::size_t k = 0; k < from.size(); ++k)
          if (sgn(what[k]) != 0) from[k] -= factor * what[k];
      };
      subtract(mode.coefficients, removed.coefficients);
      subtract(mode.displacements, removed.displacements);
      mode.displacements[row] = 0;
    }
  }

  std::vector<Mode> modes_;
};

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
  const auto springs = grounding({}).springs;
  if (springs.size() != p) return;  // the modes are dependent
  // Column by column: the recorded mode as a combination of the block's modes.
  own_of_recorded_.resize(p * p);
  const LeastSquares of_own(near_motions_, block_.motions.rows.size());
  for (std::size_t column = 0; column < p; ++column) {
    std::vector<double> motion;
    for (std::size_t at = column; at < block_.recorded_motions.size(); at += p)
      motion.push_back(block_.recorded_motions[at]);
    const auto own = of_own.solve(motion);
    if (!own) return;
    for (std::size_t k = 0; k < p; ++k) own_of_recorded_[p * k + column] = (*own)[k];
  }
  minimum_ = regularised(springs).min_eigenvalue();
}

Grounding BlockModel::grounding(const IndexSet& contact) const {
  const auto d = block_.dimension;
  Grounding result;
  if (motions() == 0) return result;
  std::array<std::vector<std::size_t>, 3> rows;  // normals and tangents with reactions, others
  for (std::size_t row = 0; row < d * candidates(); ++row) {
    const auto own = row / d;
    const bool normal = row % d == 0;
    const bool reaction = contains(contact, own) && (normal || block_.friction[own] > 0);
    rows.at(!reaction ? 2 : normal ? 0 : 1).push_back(row);
  }
  LargestRows rest(block_.motions);
  result.springs = rest.take(rows[0], nearly_sliding);
  result.sliding = rest.left();
  result.held = rest.take(rows[1], nearly_sliding);
  result.unseen = rest.take(rows[2], 0);
  result.held.insert(result.held.end(), result.unseen.begin(), result.unseen.end());
  result.springs.insert(result.springs.end(), result.held.begin(), result.held.end());
  std::ranges::sort(result.springs);
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
  const auto shares = LeastSquares(moves, rows).solve(rest);
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
  ActingLoad load{times(block_.loads[0].forces, dead), {}, dead, {}, {}, false};
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

bool BlockModel::closes_gaps(const IndexSet& contact) const {
  Elimination free(motions());
  const auto fix = [&](int i) {
    return free.add_equation(block_.motions.rows[block_.dimension * static_cast<std::size_t>(i)]);
  };
  for (const int i : contact) fix(i);
  const auto others = IndexSet::below(static_cast<int>(candidates())) - contact;
  return std::all_of(others.begin(), others.end(), fix);
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
