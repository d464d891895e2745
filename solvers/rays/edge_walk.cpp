// Dictionaries of the inequalities of D(Y), and the walk from ray to ray.
#include "solvers/rays/edge_walk.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <unordered_set>
#include <utility>

#include "solvers/rays/health.hpp"

namespace kusabi::rays {
namespace {

/// A set of variables of D(Y), one bit each: p and q on `contact`, then u_n elsewhere.
using Variables = std::uint64_t;
constexpr int max_variables = 64;

Variables variable(int number) {
  return Variables{1} << static_cast<unsigned>(number);
}

/// Number of rays between two calls of `stop`: about a millisecond.
constexpr std::uint64_t rays_between_stops = 256;

/// Share of the largest unknown of a ray up to which another one may be rounding, and share of its
/// terms up to which a displacement may be. A ray with such a number has more equalities, or this is
/// numerically undecided.
constexpr double smallest_share = 1e-9;
constexpr double smallest_extended_share = 1e-11;

template <class Scalar>
constexpr double share() {
  return std::is_same_v<Scalar, double> ? smallest_share : smallest_extended_share;
}

template <class Scalar>
using Entries = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
template <class Scalar>
using Values = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

/// The basic variables, one a row, as linear functions of the others, one a column.
template <class Scalar>
struct Dictionary {
  Entries<Scalar> entries;
  std::vector<int> rows;     // variable of each row
  std::vector<int> columns;  // variable of each column

  /// Exchanges the variable of a row and that of a column.
  void pivot(Eigen::Index row, Eigen::Index column) {
    const Scalar inverse = 1 / entries(row, column);
    for (Eigen::Index j = 0; j < entries.cols(); ++j) {
      if (j == column) continue;
      const Scalar factor = -entries(row, j) * inverse;
      entries.col(j) += factor * entries.col(column);
      entries(row, j) = factor;
    }
    entries.col(column) *= inverse;
    entries(row, column) = inverse;
    std::swap(rows[static_cast<std::size_t>(row)], columns[static_cast<std::size_t>(column)]);
  }

  template <class Other>
  Dictionary<Other> cast() const {
    return {entries.template cast<Other>(), rows, columns};
  }
};

/// A hash of a set (SplitMix64). That of the empty set, the only edge of a cone of two dimensions, is
/// not zero.
std::uint64_t mixed(Variables set) {
  set += 0x9e3779b97f4a7c15U;
  set = (set ^ (set >> 30U)) * 0xbf58476d1ce4e5b9U;
  set = (set ^ (set >> 27U)) * 0x94d049bb133111ebU;
  return set ^ (set >> 31U);
}

/// The variables of D(Y) and the equations between them.
class Face {
 public:
  Face(const ReactionCone& cone, Candidates contact) : cone_(cone), contact_(contact) {
    for (int k = 0; k < cone.candidates(); ++k) {
      if ((contact & bit(k)) == 0) {
        gaps_.push_back(k);
        continue;
      }
      unknowns_.push_back(2 * k);
      if (!cone.slips(k)) unknowns_.push_back(2 * k + 1);
    }
  }

  int variables() const { return unknown_count() + static_cast<int>(gaps_.size()); }
  int unknown_count() const { return static_cast<int>(unknowns_.size()); }
  /// Columns of ReactionCone::gaps(), by variable.
  const std::vector<int>& unknowns() const { return unknowns_; }

  /// Solves the equations u_n = 0 on `contact` for some of the unknowns, by elimination with full
  /// pivoting. Nothing if they leave no unknown free.
  std::optional<Dictionary<long double>> dictionary() const {
    std::vector<int> equations;
    for (Candidates rest = contact_; rest != 0; rest &= rest - 1)
      equations.push_back(std::countr_zero(rest));
    const auto count = static_cast<Eigen::Index>(equations.size());
    if (count >= unknown_count()) return std::nullopt;
    // The free unknowns are the columns; each pivot makes one of them the variable of a row.
    Dictionary<long double> all;
    all.entries.resize(count + std::ssize(gaps_), unknown_count());
    all.entries.topRows(count) = cone_.gaps()(equations, unknowns_);
    all.entries.bottomRows(std::ssize(gaps_)) = cone_.gaps()(gaps_, unknowns_);
    all.rows.assign(static_cast<std::size_t>(count), solved);
    for (int number = unknown_count(); number < variables(); ++number) all.rows.push_back(number);
    for (int number = 0; number < unknown_count(); ++number) all.columns.push_back(number);
    for (Eigen::Index i = 0; i < count; ++i)
      all.entries.row(i) /= all.entries.row(i).template lpNorm<Eigen::Infinity>();
    for (Eigen::Index done = 0; done < count; ++done) {
      Eigen::Index row = 0;
      Eigen::Index column = 0;
      long double largest = 0;
      for (Eigen::Index j = 0; j < all.entries.cols(); ++j) {
        if (all.columns[static_cast<std::size_t>(j)] == solved) continue;
        for (Eigen::Index i = 0; i < count; ++i) {
          if (all.rows[static_cast<std::size_t>(i)] != solved) continue;
          if (std::abs(all.entries(i, j)) > largest) {
            largest = std::abs(all.entries(i, j));
            row = i;
            column = j;
          }
        }
      }
      if (!(largest > 0)) return std::nullopt;
      all.pivot(row, column);
    }
    std::vector<Eigen::Index> free;
    Dictionary<long double> left;
    for (Eigen::Index j = 0; j < all.entries.cols(); ++j) {
      if (all.columns[static_cast<std::size_t>(j)] == solved) continue;
      free.push_back(j);
      left.columns.push_back(all.columns[static_cast<std::size_t>(j)]);
    }
    left.entries = all.entries(Eigen::all, free);
    left.rows = std::move(all.rows);
    return left;
  }

  /// A, restricted to the unknowns.
  template <class Scalar>
  Entries<Scalar> gaps() const {
    return cone_.gaps()(Eigen::all, unknowns_).template cast<Scalar>();
  }

  /// Candidates without a gap at a ray.
  Candidates touching(Variables zero) const {
    Candidates none = contact_;
    for (std::size_t at = 0; at < gaps_.size(); ++at) {
      if ((zero & variable(unknown_count() + static_cast<int>(at))) != 0) none |= bit(gaps_[at]);
    }
    return none;
  }

  /// The zero set of a ray from those of its variables that are zero.
  ZeroSet zero_set(Variables zero) const {
    ZeroSet set{cone_.all(), cone_.all(), touching(zero)};
    for (int number = 0; number < unknown_count(); ++number) {
      if ((zero & variable(number)) != 0) continue;
      const int column = unknowns_[static_cast<std::size_t>(number)];
      (column % 2 == 0 ? set.p : set.q) &= ~bit(column / 2);
    }
    return set;
  }

 private:
  static constexpr int solved = -1;  // an equation, which is no variable

  const ReactionCone& cone_;
  Candidates contact_;
  std::vector<int> unknowns_;
  std::vector<int> gaps_;  // rows of ReactionCone::gaps(), by variable after the unknowns
};

/// The variables that are zero at a ray of D(Y), reached from a point inside: one after another of
/// the variables of columns is decreased until it, or first that of a row, is zero.
std::optional<Variables> ray_near(Dictionary<long double> dictionary, LongVector columns) {
  Variables zero = 0;
  LongVector rows = dictionary.entries * columns;
  if (!(columns.minCoeff() > 0) || !(rows.minCoeff() > 0)) return std::nullopt;
  for (Eigen::Index j = 0; j + 1 < columns.size(); ++j) {
    Eigen::Index blocking = -1;
    long double step = columns(j);
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
      const auto slope = dictionary.entries(i, j);
      if (slope > 0 && rows(i) < step * slope) {
        step = rows(i) / slope;
        blocking = i;
      }
    }
    rows -= step * dictionary.entries.col(j);
    columns(j) -= step;
    if (blocking >= 0) {
      dictionary.pivot(blocking, j);
      std::swap(rows(blocking), columns(j));
    }
    columns(j) = 0;
    zero |= variable(dictionary.columns[static_cast<std::size_t>(j)]);
  }
  return zero;
}

template <class Scalar>
class WalkOnRays {
 public:
  WalkOnRays(const Face& face, const Dictionary<long double>& first)
      : face_(face),
        first_(first.cast<Scalar>()),
        gaps_(face.gaps<Scalar>()),
        magnitudes_(gaps_.cwiseAbs()),
        unknowns_(face.unknown_count()) {}

  /// From a ray, by its zero variables, to all others.
  WalkEnd from(Variables start, const std::function<bool()>& stop) {
    known_.insert(start);
    open_.push_back(start);
    while (!open_.empty()) {
      if (stop && visited_++ % rays_between_stops == 0 && stop()) return WalkEnd::stopped;
      const Variables zero = open_.back();
      open_.pop_back();
      if (!arrive(zero) || !is_simple(zero)) return WalkEnd::not_simple;
      for (Eigen::Index j = 0; j < here_.entries.cols(); ++j) {
        if (j != scale_) follow(zero, j);
      }
    }
    return edges_ == 0 ? WalkEnd::complete : WalkEnd::not_simple;
  }

  const std::unordered_set<Variables>& known() const { return known_; }

 private:
  /// Makes `here_` the dictionary of a ray: the columns are its zero variables and one more, the
  /// scale.
  bool arrive(Variables zero) {
    here_ = first_;
    for (Eigen::Index i = 0; i < here_.entries.rows(); ++i) {
      if ((zero & variable(here_.rows[static_cast<std::size_t>(i)])) == 0) continue;
      Eigen::Index column = -1;
      Scalar largest = 0;
      for (Eigen::Index j = 0; j < here_.entries.cols(); ++j) {
        const bool stays = (zero & variable(here_.columns[static_cast<std::size_t>(j)])) != 0;
        if (stays || std::abs(here_.entries(i, j)) <= largest) continue;
        largest = std::abs(here_.entries(i, j));
        column = j;
      }
      if (column < 0) return false;
      here_.pivot(i, column);
    }
    scale_ = 0;
    while ((zero & variable(here_.columns[static_cast<std::size_t>(scale_)])) != 0) ++scale_;
    return true;
  }

  /// True if all other variables of the ray are positive, clear of rounding, and those of `zero`
  /// are zero.
  bool is_simple(Variables zero) {
    const auto values = here_.entries.col(scale_);
    unknowns_.setZero();
    if (const int own = here_.columns[static_cast<std::size_t>(scale_)];
        own < face_.unknown_count())
      unknowns_(own) = 1;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const int number = here_.rows[static_cast<std::size_t>(i)];
      if (number < face_.unknown_count()) unknowns_(number) = values(i);
    }
    const Scalar least = static_cast<Scalar>(share<Scalar>()) * unknowns_.maxCoeff();
    for (int number = 0; number < face_.unknown_count(); ++number) {
      if ((zero & variable(number)) == 0 && !(unknowns_(number) > least)) return false;
    }
    const Candidates touching = face_.touching(zero);
    displacements_.noalias() = gaps_ * unknowns_;
    terms_.noalias() = magnitudes_ * unknowns_;
    for (Eigen::Index i = 0; i < displacements_.size(); ++i) {
      const bool vanishes = (touching & bit(static_cast<int>(i))) != 0;
      const double least_gap = std::max(zero_tolerance * undecided_factor, share<Scalar>());
      const Scalar border =
          static_cast<Scalar>(vanishes ? zero_tolerance / undecided_factor : least_gap) * terms_(i);
      if (vanishes ? std::abs(displacements_(i)) > border : displacements_(i) < border)
        return false;
    }
    return true;
  }

  /// Follows the edge on which the variable of a column is positive to its other end, the sum of
  /// this column and the least multiple of the ray that has no negative variable.
  void follow(Variables zero, Eigen::Index column) {
    const auto ray = here_.entries.col(scale_);
    const auto edge = here_.entries.col(column);
    Scalar multiple = 0;
    int next = here_.columns[static_cast<std::size_t>(scale_)];
    for (Eigen::Index i = 0; i < edge.size(); ++i) {
      if (edge(i) < -multiple * ray(i)) {
        multiple = -edge(i) / ray(i);
        next = here_.rows[static_cast<std::size_t>(i)];
      }
    }
    const Variables common = zero & ~variable(here_.columns[static_cast<std::size_t>(column)]);
    const Variables end = common | variable(next);
    // Every edge is followed from both of its ends, unless rounding has led to a wrong one.
    edges_ ^= mixed(common);
    if (known_.insert(end).second) open_.push_back(end);
  }

  const Face& face_;
  Dictionary<Scalar> first_;
  Dictionary<Scalar> here_;
  Eigen::Index scale_ = 0;
  Entries<Scalar> gaps_;
  Entries<Scalar> magnitudes_;
  Values<Scalar> unknowns_;
  Values<Scalar> displacements_;
  Values<Scalar> terms_;
  std::unordered_set<Variables> known_;
  std::vector<Variables> open_;
  std::uint64_t visited_ = 0;
  std::uint64_t edges_ = 0;  // sum of hashes modulo 2 in each bit
};

template <class Scalar>
EdgeWalk walked(const Face& face, const Dictionary<long double>& first, Variables start,
                const std::function<bool()>& stop) {
  WalkOnRays<Scalar> walk(face, first);
  EdgeWalk result{.end = walk.from(start, stop), .rays = {}};
  if (result.end != WalkEnd::complete) return result;
  result.rays.reserve(walk.known().size());
  for (const Variables zero : walk.known()) result.rays.push_back(face.zero_set(zero));
  return result;
}

}  // namespace

EdgeWalk walk_along_edges(const ReactionCone& cone, Candidates contact, const LongVector& inside,
                          const std::function<bool()>& stop) {
  const Face face(cone, contact);
  if (cone.equations() > 0 || face.variables() > max_variables) return {};
  const auto first = face.dictionary();
  if (!first) return {};
  LongVector free(std::ssize(first->columns));
  for (Eigen::Index j = 0; j < free.size(); ++j) {
    const auto number = static_cast<std::size_t>(first->columns[static_cast<std::size_t>(j)]);
    free(j) = inside(face.unknowns()[number]);
  }
  const auto start = ray_near(*first, free);
  if (!start) return {};
  auto walk = walked<double>(face, *first, *start, stop);
  if (walk.end != WalkEnd::not_simple) return walk;
  return walked<long double>(face, *first, *start, stop);
}

}  // namespace kusabi::rays
