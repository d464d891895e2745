// Double description: one cut after another, cheapest first, with bit patterns instead of rank
// tests.
#include "solvers/rays/double_description.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include "solvers/rays/adjacent_pairs.hpp"

namespace kusabi::rays {
namespace {

/// Result of a cut by u_ni.
enum class Keep {
  zero,           ///< u_ni = 0
  nonnegative,    ///< u_ni >= 0
  complementary,  ///< u_ni >= 0, and u_ni = 0 where r_ni > 0
};

/// Number of rays whose displacements are computed at a time: their coordinates fit in the cache.
constexpr Eigen::Index block_size = 256;

/// A ray between two others is a sum weighted by their displacements, and has as many correct
/// digits as these. If one displacement is smaller than this, relative to the terms that cancel in
/// it, the ray is computed from its zero set instead; otherwise errors would accumulate from step
/// to step, and fill the gap between zero and nonzero values.
constexpr double exact_enough = 1e-2;

/// Number of pairs, adjacent or not, below which a step is not shared: it takes some milliseconds.
constexpr std::uint64_t pairs_worth_sharing = 1'000'000;

/// Approximate number of pieces of a shared step: enough to balance the load.
constexpr std::uint64_t pieces_of_cut = 512;

/// The candidate at which a list is divided: the cost of a part is about cubic in its length.
std::optional<int> division(const RayList& list) {
  std::optional<int> best;
  double minimum = std::numeric_limits<double>::infinity();
  for (Candidates rest = list.done.gaps & ~(list.contact | list.separated); rest != 0;
       rest &= rest - 1) {
    const Candidates here = rest & (~rest + 1);
    double contact = 0;
    double separated = 0;
    for (const ZeroSet& zero : list.zeros) {
      if ((zero.u & here) != 0) ++contact;
      if ((zero.p & zero.q & here) != 0) ++separated;
    }
    const double longer = std::max(contact, separated);
    const double cubes = contact * contact * contact + separated * separated * separated;
    if (longer < static_cast<double>(list.zeros.size()) && cubes < minimum) {
      best = std::countr_zero(here);
      minimum = cubes;
    }
  }
  return best;
}

/// The rays of a list whose zero sets satisfy `within`.
template <class Within>
RayList part_of(const RayList& list, const Within& within) {
  RayList part{list.done, list.contact, list.separated, {}, {}};
  const auto width = static_cast<std::ptrdiff_t>(list.coordinates.size() / list.zeros.size());
  auto ray = list.coordinates.begin();
  for (const ZeroSet& zero : list.zeros) {
    if (within(zero)) {
      part.zeros.push_back(zero);
      part.coordinates.insert(part.coordinates.end(), ray, ray + width);
    }
    ray += width;
  }
  return part;
}

class DoubleDescription {
 public:
  /// Starts with the cone x >= 0 of the candidates `active`; all others have no reaction. Modes
  /// with a normal part are first fixed at their pivots.
  /// @param touching candidates at which u_n = 0 is required
  DoubleDescription(const ReactionCone& cone, Candidates active, Candidates touching,
                    EnumerationOptions options = {});

  /// Resumes with a list of rays that may have a reaction anywhere.
  DoubleDescription(const ReactionCone& cone, RayList list, EnumerationOptions options);

  /// Cuts by all rows of `rows`, and by the equations of equilibrium, in the order that gives the
  /// fewest pairs.
  /// @return false if it was stopped, or there are too many rays; after `give_up` or too many rays
  ///   it can be resumed
  bool cut_by(Candidates rows, Keep keep);
  const Cost& cost() const { return cost_; }
  StepsResult steps() const { return {cost_, health_, stopped_}; }

  RayList list() && { return std::move(list_); }
  Enumeration result() &&;

 private:
  struct Sides {
    std::uint64_t plus = 0;
    std::uint64_t minus = 0;
  };

  DoubleDescription(const ReactionCone& cone, std::vector<int> columns, EnumerationOptions options);

  Eigen::Index count() const { return static_cast<Eigen::Index>(list_.zeros.size()); }
  /// Adds the mode that displaces candidate `row`, and not those before it, to every ray such that
  /// u_n = 0 there.
  void hold(int row, Eigen::Index motion, bool touches);
  bool is_gap(int row) const { return row < cone_.candidates(); }
  /// Stage after a cut by this row.
  ReactionCone::Stage after(int row) const {
    auto stage = list_.done;
    if (is_gap(row)) {
      stage.gaps |= bit(row);
    } else {
      stage.balanced |= bit(row - cone_.candidates());
    }
    return stage;
  }
  /// Minimum number of equalities shared by two adjacent rays.
  int enough() const {
    return static_cast<int>(cone_.unknowns()) - std::popcount(list_.done.balanced) - 2;
  }
  int cheapest(const std::vector<int>& rows);
  /// u of every ray at one row; relative values go to `relative_`.
  void displacements(int row);
  void cut(int row, Keep keep);
  void add_between(int row, const std::vector<int>& plus, const std::vector<int>& minus);
  void append(const NewRays& rays);
  void combine(const AdjacentPair& pair, const ZeroSet& zero, const ReactionCone::Stage& stage,
               NewRays& into) const;

  const ReactionCone& cone_;
  std::vector<int> columns_;    // of the active candidates, and of modes
  Eigen::Index reactions_ = 0;  // number of columns of reactions
  Eigen::MatrixXd gaps_;        // these columns of (A H) over (E 0)
  Eigen::MatrixXd magnitudes_;  // absolute values of gaps_
  RayList list_;
  Eigen::VectorXd values_;    // of the current row, one per ray
  Eigen::VectorXd relative_;  // relative displacements
  NewRays next_;              // the list after the cut
  Cost cost_;
  Health health_;
  bool stopped_ = false;
  EnumerationOptions options_;
};

/// The unknowns of these candidates, and of modes.
std::vector<int> columns_of(const ReactionCone& cone, Candidates active) {
  std::vector<int> columns;
  for (Candidates rest = active; rest != 0; rest &= rest - 1) {
    const int k = std::countr_zero(rest);
    columns.push_back(2 * k);
    if (!cone.slips(k)) columns.push_back(2 * k + 1);
  }
  for (int column = 2 * cone.candidates(); column < cone.unknowns(); ++column)
    columns.push_back(column);
  return columns;
}

DoubleDescription::DoubleDescription(const ReactionCone& cone, std::vector<int> columns,
                                     EnumerationOptions options)
    : cone_(cone),
      columns_(std::move(columns)),
      reactions_(std::count_if(columns_.begin(), columns_.end(),
                               [&](int column) { return column < 2 * cone.candidates(); })),
      gaps_(cone.gaps()(Eigen::all, columns_).cast<double>()),
      magnitudes_(gaps_.cwiseAbs()),
      options_(std::move(options)) {}

DoubleDescription::DoubleDescription(const ReactionCone& cone, RayList list,
                                     EnumerationOptions options)
    : DoubleDescription(cone, columns_of(cone, cone.all()), std::move(options)) {
  list_ = std::move(list);
}

DoubleDescription::DoubleDescription(const ReactionCone& cone, Candidates active,
                                     Candidates touching, EnumerationOptions options)
    : DoubleDescription(cone, columns_of(cone, active), std::move(options)) {
  const auto size = static_cast<std::size_t>(gaps_.cols());
  const auto count = static_cast<std::size_t>(reactions_);
  list_.coordinates.assign(size * count, 0);
  for (std::size_t ray = 0; ray < count; ++ray) {
    const int column = columns_[ray];
    ZeroSet zero{cone.all(), cone.all(), 0};
    (column % 2 == 0 ? zero.p : zero.q) &= ~bit(column / 2);
    list_.zeros.push_back(zero);
    list_.coordinates[ray * size + ray] = 1;
  }
  Eigen::Index motion = 0;
  for (const int row : cone.pivots()) hold(row, motion++, (touching & bit(row)) != 0);
}

void DoubleDescription::hold(int row, Eigen::Index motion, bool touches) {
  const Eigen::Index column = reactions_ + motion;
  const double lift = gaps_(row, column);
  Eigen::Map<Eigen::MatrixXd> rays(list_.coordinates.data(), gaps_.cols(), count());
  rays.row(column) = -gaps_.row(row) * rays / lift;
  for (auto& zero : list_.zeros) zero.u |= bit(row);
  if (!touches) {
    list_.zeros.push_back({cone_.all(), cone_.all(), list_.done.gaps});
    list_.coordinates.resize(list_.coordinates.size() + static_cast<std::size_t>(gaps_.cols()), 0);
    list_.coordinates[list_.coordinates.size() - static_cast<std::size_t>(gaps_.cols() - column)] =
        lift > 0 ? 1 : -1;
  }
  list_.done.gaps |= bit(row);
}

bool DoubleDescription::cut_by(Candidates rows, Keep keep) {
  std::vector<int> left;
  for (rows &= ~list_.done.gaps; rows != 0; rows &= rows - 1)
    left.push_back(std::countr_zero(rows));
  for (int k = 0; k < cone_.equations(); ++k) {
    if ((list_.done.balanced & bit(k)) == 0) left.push_back(cone_.candidates() + k);
  }
  while (!left.empty()) {
    const int row = cheapest(left);
    left.erase(std::find(left.begin(), left.end(), row));
    cut(row, is_gap(row) ? keep : Keep::zero);
    const bool stop_asked = next_.stopped || (options_.stop && options_.stop());
    stopped_ = options_.agree ? options_.agree(stop_asked) : stop_asked;
    if (stopped_) return false;
    cost_ += std::exchange(next_.cost, {});
    if (list_.zeros.size() > options_.max_rays && division(list_)) return false;
    if (left.empty() || !options_.give_up) continue;
    stopped_ = options_.give_up(cost_);
    if (stopped_) return false;
  }
  return true;
}

int DoubleDescription::cheapest(const std::vector<int>& rows) {
  if (rows.size() == 1) return rows.front();
  std::vector<Sides> sides(rows.size());
  const Eigen::MatrixXd gaps = gaps_(rows, Eigen::all);
  const Eigen::MatrixXd magnitudes = magnitudes_(rows, Eigen::all);
  const Eigen::Map<const Eigen::MatrixXd> rays(list_.coordinates.data(), gaps_.cols(), count());
  Eigen::MatrixXd value;
  Eigen::MatrixXd scale;
  for (Eigen::Index first = 0; first < count(); first += block_size) {
    const auto block = rays.middleCols(first, std::min(block_size, count() - first));
    value.noalias() = gaps * block;
    scale.noalias() = magnitudes * block.cwiseAbs();
    for (Eigen::Index ray = 0; ray < block.cols(); ++ray) {
      for (std::size_t place = 0; place < rows.size(); ++place) {
        const auto row = static_cast<Eigen::Index>(place);
        const double minimum = zero_tolerance * scale(row, ray);
        if (value(row, ray) > minimum) ++sides[place].plus;
        if (value(row, ray) < -minimum) ++sides[place].minus;
      }
    }
  }
  const auto pairs = [](const Sides& side) { return side.plus * side.minus; };
  const auto best = std::min_element(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
    return pairs(a) < pairs(b);
  });
  return rows[static_cast<std::size_t>(best - sides.begin())];
}

void DoubleDescription::displacements(int row) {
  const Eigen::Map<const Eigen::MatrixXd> rays(list_.coordinates.data(), gaps_.cols(), count());
  values_ = (gaps_.row(row) * rays).transpose();
  relative_ = (magnitudes_.row(row) * rays.cwiseAbs()).transpose();
  relative_ = (relative_.array() > 0).select(values_.array() / relative_.array(), 0.0);
}

void DoubleDescription::cut(int row, Keep keep) {
  displacements(row);
  std::vector<int> plus;
  std::vector<int> minus;
  next_.zeros.clear();
  next_.coordinates.clear();
  const auto width = static_cast<std::ptrdiff_t>(gaps_.cols());
  const auto retain = [&](int ray, const ZeroSet& zero) {
    next_.zeros.push_back(zero);
    const auto from = list_.coordinates.begin() + width * ray;
    next_.coordinates.insert(next_.coordinates.end(), from, from + width);
  };
  for (int ray = 0; ray < static_cast<int>(count()); ++ray) {
    ZeroSet zero = list_.zeros[static_cast<std::size_t>(ray)];
    const int sign = health_.sign(relative_(ray));
    if (sign > 0) {
      plus.push_back(ray);
      if (keep == Keep::nonnegative ||
          (keep == Keep::complementary && (zero.p & zero.q & bit(row)) != 0))
        retain(ray, zero);
    } else if (sign < 0) {
      minus.push_back(ray);
    } else {
      if (is_gap(row)) zero.u |= bit(row);
      retain(ray, zero);
    }
  }
  if (!plus.empty() && !minus.empty()) add_between(row, plus, minus);
  list_.done = after(row);
  std::swap(list_.zeros, next_.zeros);
  std::swap(list_.coordinates, next_.coordinates);
  cost_.peak_rays = std::max(cost_.peak_rays, static_cast<std::uint64_t>(list_.zeros.size()));
}

void DoubleDescription::add_between(int row, const std::vector<int>& plus,
                                    const std::vector<int>& minus) {
  const AdjacentPairs pairs(list_.zeros, plus, minus, list_.done.gaps, enough());
  const auto stage = after(row);
  const auto add = [&](const AdjacentPairs::Part& part, NewRays& into, const auto& stop) {
    const auto found = [&](const AdjacentPair& pair) {
      ZeroSet zero = pair.common;
      if (is_gap(row)) zero.u |= bit(row);
      combine(pair, zero, stage, into);
      ++into.cost.adjacent;
    };
    into.stopped = !pairs.search(part, found, stop, into.cost.pairs);
  };
  const auto many = static_cast<std::uint64_t>(plus.size()) * minus.size();
  if (!options_.share) return add(pairs.whole(), next_, options_.stop);
  // A step that all ranks repeat must end alike on all of them.
  if (many < pairs_worth_sharing) return add(pairs.whole(), next_, std::function<bool()>());
  const auto parts = pairs.parts(many / pieces_of_cut);
  if (parts.empty()) return;
  for (const NewRays& rays : options_.share(parts.size(), [&](std::uint64_t piece) {
         NewRays own;
         add(parts[piece], own, options_.stop);
         return own;
       })) {
    append(rays);
  }
}

void DoubleDescription::append(const NewRays& rays) {
  next_.zeros.insert(next_.zeros.end(), rays.zeros.begin(), rays.zeros.end());
  next_.coordinates.insert(next_.coordinates.end(), rays.coordinates.begin(),
                           rays.coordinates.end());
  next_.cost += rays.cost;
  next_.stopped = next_.stopped || rays.stopped;
}

void DoubleDescription::combine(const AdjacentPair& pair, const ZeroSet& zero,
                                const ReactionCone::Stage& stage, NewRays& into) const {
  const auto& [plus, minus, common] = pair;
  const auto width = gaps_.cols();
  const auto filled = into.coordinates.size();
  into.coordinates.resize(filled + static_cast<std::size_t>(width));
  Eigen::Map<Eigen::VectorXd> between(into.coordinates.data() + filled, width);
  if (std::min(relative_(plus), -relative_(minus)) < exact_enough) {
    between = cone_.rounded_coordinates(zero, stage)(columns_);
  } else {
    const Eigen::Map<const Eigen::VectorXd> above(list_.coordinates.data() + width * plus, width);
    const Eigen::Map<const Eigen::VectorXd> below(list_.coordinates.data() + width * minus, width);
    between = -values_(minus) * above + values_(plus) * below;
    const double load = between.head(reactions_).sum();
    // the combination of two modes is a mode
    between /= load > 0 ? load : between.cwiseAbs().maxCoeff();
  }
  into.zeros.push_back(zero);
}

Enumeration DoubleDescription::result() && {
  return {std::move(list_.zeros), cost_, health_};
}

}  // namespace

Cost& Cost::operator+=(const Cost& other) {
  peak_rays = std::max(peak_rays, other.peak_rays);
  pairs += other.pairs;
  adjacent += other.adjacent;
  return *this;
}

RayList first_list(const ReactionCone& cone) {
  return DoubleDescription(cone, cone.all(), 0).list();
}

StepsResult resume(RayList& list, const ReactionCone& cone, const EnumerationOptions& options) {
  DoubleDescription description(cone, std::move(list), options);
  description.cut_by(cone.all(), Keep::complementary);
  const StepsResult steps = description.steps();
  list = std::move(description).list();
  return steps;
}

bool has_ended(const RayList& list, const ReactionCone& cone) {
  return list.done.gaps == cone.all() && list.done.balanced == first_candidates(cone.equations());
}

std::optional<std::array<RayList, 2>> divided(const RayList& list) {
  const auto candidate = division(list);
  if (!candidate) return std::nullopt;
  const Candidates here = bit(*candidate);
  auto contact = part_of(list, [&](const ZeroSet& zero) { return (zero.u & here) != 0; });
  auto separated =
      part_of(list, [&](const ZeroSet& zero) { return (zero.p & zero.q & here) != 0; });
  contact.contact |= here;
  separated.separated |= here;
  return std::array{std::move(contact), std::move(separated)};
}

std::optional<Enumeration> complementary_rays(const ReactionCone& cone,
                                              const EnumerationOptions& options) {
  auto list = first_list(cone);
  const auto steps = resume(list, cone, options);
  if (steps.stopped || !has_ended(list, cone)) return std::nullopt;
  return Enumeration{std::move(list.zeros), steps.cost, steps.health};
}

Enumeration complementary_rays(const ReactionCone& cone) {
  return *complementary_rays(cone, EnumerationOptions{});
}

std::uint64_t bytes_for(std::uint64_t rays, int candidates) {
  // Rays before and after a cut, in vectors that grow by doubling, and the trees of the pairing:
  // ten times the ray itself, measured on a million.
  const auto ray = sizeof(ZeroSet) + 2 * sizeof(double) * static_cast<std::uint64_t>(candidates);
  return 10 * ray * rays;
}

struct PatternRaysByTurns::State {
  State(const ReactionCone& cone, Candidates in_contact, std::function<bool()> stop)
      : contact(in_contact),
        separated(cone.all() & ~in_contact),
        description(cone, in_contact, in_contact,
                    {.stop = std::move(stop),
                     .give_up = [this](const Cost& cost) { return cost.pairs > max_pairs; }}) {}

  std::uint64_t max_pairs = 0;
  Candidates contact;
  Candidates separated;
  DoubleDescription description;
};

PatternRaysByTurns::PatternRaysByTurns(const ReactionCone& cone, Candidates contact,
                                       std::function<bool()> stop)
    : state_(std::make_unique<State>(cone, contact, std::move(stop))) {}
PatternRaysByTurns::PatternRaysByTurns(PatternRaysByTurns&&) noexcept = default;
PatternRaysByTurns& PatternRaysByTurns::operator=(PatternRaysByTurns&&) noexcept = default;
PatternRaysByTurns::~PatternRaysByTurns() = default;

bool PatternRaysByTurns::resume(std::uint64_t max_pairs) {
  if (state_->description.cost().pairs > max_pairs) return false;
  state_->max_pairs = max_pairs;
  auto& description = state_->description;
  return description.cut_by(state_->contact, Keep::zero) &&
         description.cut_by(state_->separated, Keep::nonnegative);
}

Enumeration PatternRaysByTurns::result() && {
  return std::move(state_->description).result();
}

Enumeration rays_of_pattern(const ReactionCone& cone, Candidates contact) {
  return *rays_of_pattern(cone, contact, {});
}

std::optional<Enumeration> rays_of_pattern(const ReactionCone& cone, Candidates contact,
                                           std::function<bool()> stop) {
  PatternRaysByTurns turns(cone, contact, std::move(stop));
  if (!turns.resume(std::numeric_limits<std::uint64_t>::max())) return std::nullopt;
  return std::move(turns).result();
}

}  // namespace kusabi::rays
