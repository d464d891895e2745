// A piece is enclosed by half-planes, which multipliers of infeasible points prove, until all
// vertices have a state.
#include "nodes/wedged/hold/diagram_piece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace kusabi::wedged {
namespace {

/// Doublings and halvings of a distance, as of a load factor.
constexpr int max_extensions = 60;
constexpr int first_directions = 8;
/// Maximum number of half-planes of a piece: enough for the friction cones in space.
constexpr std::size_t max_planes = 96;
/// Distance of a vertex from a held point on the line to it, relative to that from a point inside.
constexpr double piece_width = 1e-5;
/// Distance of two vertices that are one, relative to that from a point inside.
constexpr double same_vertex = 1e-4;
/// Turn of a direction towards the inside for a direction without end at a limit.
constexpr double small_turn = 1e-6;

/// The factors of one leaf, in units of the loads.
class PieceSearch {
 public:
  PieceSearch(const LoadedProblem& block, double mu, Precision precision, LoadedPattern pattern,
              Eigen::Vector2d unit)
      : block_(block),
        mu_(mu),
        precision_(precision),
        pattern_(std::move(pattern)),
        unit_(std::move(unit)) {}

  /// @param from a point with a state
  DiagramPiece around(const Eigen::Vector2d& from);

 private:
  struct Shot {
    bool unbounded = false;
    double held = 0;  ///< distance from the point inside
  };

  [[nodiscard]] LoadShare share(double dead, const Eigen::Vector2d& at) const {
    return {dead, at.x() * unit_.x(), at.y() * unit_.y()};
  }
  HoldResult solve(LoadShare share);
  bool is_unbounded(const Eigen::Vector2d& along);
  Shot shoot(const Eigen::Vector2d& along);
  Shot shot_at(const Eigen::Vector2d& along);
  Polygon sampled();
  Polygon held_part(const Polygon& sample, bool& fine);
  void approach_origin();
  std::optional<Eigen::Vector2d> nearest_unbounded(const Eigen::Vector2d& ray,
                                                   const std::vector<Eigen::Vector2d>& unbounded);
  void enclose();

  const LoadedProblem& block_;
  double mu_;
  Precision precision_;
  LoadedPattern pattern_;
  Eigen::Vector2d unit_;
  Eigen::Vector2d inside_;
  std::array<double, 3> works_{};  // of the loads, by the multipliers of the last infeasible point
  std::vector<HalfPlane> planes_;  // about `inside_`
  std::vector<std::pair<Eigen::Vector2d, Shot>> shots_;
};

HoldResult PieceSearch::solve(LoadShare share) {
  HoldNodes nodes(block_, std::array{share}, mu_, precision_);
  const HoldResult result = nodes.solve(pattern_);
  if (result == HoldResult::infeasible) works_ = nodes.works();
  return result;
}

// A direction at a limit counts if directions beside it on one side have no end.
bool PieceSearch::is_unbounded(const Eigen::Vector2d& along) {
  const auto at = solve(share(0, along));
  if (at == HoldResult::feasible) return true;
  if (at == HoldResult::infeasible) return false;
  const Eigen::Vector2d across(-along.y(), along.x());
  return solve(share(0, along + small_turn * across)) == HoldResult::feasible ||
         solve(share(0, along - small_turn * across)) == HoldResult::feasible ||
         at == HoldResult::at_limit || at == HoldResult::face;
}

PieceSearch::Shot PieceSearch::shoot(const Eigen::Vector2d& along) {
  if (is_unbounded(along)) return {.unbounded = true};
  const auto feasible = [&](double distance) {
    return solve(share(1, inside_ + distance * along)) == HoldResult::feasible;
  };
  double held = 0;
  double out = std::max(1.0, inside_.norm());
  int doubling = 0;
  for (; doubling < max_extensions && feasible(out); ++doubling) {
    held = out;
    out *= 2;
  }
  if (doubling == max_extensions) return {.unbounded = true};
  for (int step = 0; step < max_extensions && out - held > diagram_width / 8 * out; ++step) {
    const double middle = held + (out - held) / 2;
    (feasible(middle) ? held : out) = middle;
  }
  for (double beyond = diagram_width / 8; beyond < 1; beyond *= 4) {  // degenerate at the boundary
    if (solve(share(1, inside_ + out * along)) == HoldResult::infeasible) {
      enclose();
      break;
    }
    out *= 1 + beyond;
  }
  return {.unbounded = false, .held = held};
}

// works_ . (1, factors) >= 0 for all states of the pattern.
void PieceSearch::enclose() {
  const Eigen::Vector2d rise(works_[1] * unit_.x(), works_[2] * unit_.y());
  if (rise.norm() == 0) return;
  const HalfPlane plane{-rise.normalized(), (works_[0] + rise.dot(inside_)) / rise.norm()};
  if (plane.maximum >= 0) planes_.push_back(plane);
}

// Distances are known relative to themselves: a point inside that is not much farther from the
// nearest boundary than this is from the origin.
void PieceSearch::approach_origin() {
  const double size = inside_.norm();
  if (size <= 1) return;
  const auto [unbounded, held] = shoot(-inside_ / size);
  planes_.clear();
  const double there = unbounded ? size : std::min(held, size);
  const double apart = std::min(there, size - there + 1) / 2;
  inside_ *= (size - there + apart) / size;
}

// The last direction without end between a given one and one with an end; nothing if none is given
// within a right angle.
std::optional<Eigen::Vector2d> PieceSearch::nearest_unbounded(
    const Eigen::Vector2d& ray, const std::vector<Eigen::Vector2d>& unbounded) {
  if (unbounded.empty()) return {};
  Eigen::Vector2d inner =
      *std::ranges::max_element(unbounded, {}, [&](const auto& along) { return along.dot(ray); });
  if (inner.dot(ray) <= 0) return {};
  Eigen::Vector2d outer = ray;
  while ((outer - inner).norm() > diagram_width) {
    const Eigen::Vector2d middle = (outer + inner).normalized();
    (solve(share(0, middle)) == HoldResult::feasible ? inner : outer) = middle;
  }
  return inner;
}

PieceSearch::Shot PieceSearch::shot_at(const Eigen::Vector2d& along) {
  for (const auto& [direction, shot] : shots_)
    if ((direction - along).norm() <= diagram_width / 8) return shot;
  shots_.emplace_back(along, shoot(along));
  return shots_.back().second;
}

// Held points and directions without end, of a few directions.
Polygon PieceSearch::sampled() {
  Polygon hull;
  for (int k = 0; k < first_directions; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.3) / first_directions;
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    const auto shot = shot_at(along);
    if (shot.unbounded)
      hull.rays.push_back(along);
    else
      hull.vertices.emplace_back(inside_ + shot.held * along);
  }
  return hull;
}

// The part of the enclosing polygon that is held, with further half-planes where it is smaller.
// @param sample of a few directions, for a half-plane or a strip
// @param fine set: nothing is missing
Polygon PieceSearch::held_part(const Polygon& sample, bool& fine) {
  fine = true;
  const auto outer = intersection(planes_);
  const bool pointed = !outer.vertices.empty();  // otherwise a half-plane or a strip
  Polygon hull = pointed ? Polygon{} : sample;
  for (const auto& vertex : outer.vertices) {
    const auto [unbounded, held] = shot_at(vertex.normalized());
    const double distance = unbounded ? vertex.norm() : std::min(held, vertex.norm());
    hull.vertices.emplace_back(inside_ + distance * vertex.normalized());
    fine = fine && vertex.norm() - distance <= piece_width * vertex.norm();
  }
  auto unbounded = sample.rays;
  if (pointed && outer.rays.size() == 2) {
    const Eigen::Vector2d middle = (outer.rays[0] + outer.rays[1]).normalized();
    if (is_unbounded(middle)) unbounded.push_back(middle);
  }
  for (const auto& ray : outer.rays) {
    const auto inner = nearest_unbounded(ray, unbounded);
    const bool unbounded_here = shot_at(ray).unbounded;
    if (unbounded_here || inner) hull.rays.push_back(unbounded_here ? ray : *inner);
    fine = fine && (unbounded_here || (inner && (ray - *inner).norm() <= piece_width));
  }
  return hull;
}

DiagramPiece PieceSearch::around(const Eigen::Vector2d& from) {
  DiagramPiece piece{.pattern = pattern_};
  inside_ = from;
  approach_origin();
  const Polygon sample = sampled();
  piece.hull = sample;
  piece.is_whole_plane = sample.vertices.empty();
  piece.fine = piece.is_whole_plane;
  for (std::size_t before = 0;
       !piece.fine && planes_.size() > before && planes_.size() < max_planes;) {
    before = planes_.size();
    piece.hull = held_part(sample, piece.fine);
  }
  piece.hull = with_corners_only(std::move(piece.hull), inside_, same_vertex, piece_width);
  return piece;
}

}  // namespace

DiagramPiece piece_around(const LoadedProblem& block, double mu, Precision precision,
                          const LoadedPattern& pattern, const Eigen::Vector2d& unit,
                          const Eigen::Vector2d& from) {
  return PieceSearch(block, mu, precision, pattern, unit).around(from);
}

}  // namespace kusabi::wedged
