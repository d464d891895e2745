// Nodes ring by ring, bars layer by layer.
#include "problems/families/dome.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "problems/families/rounded_place.hpp"

namespace kusabi::problems {
namespace {

constexpr YieldForces bar_yield{240, 120};  // kN
constexpr double snow_force = 10;           // kN a node
constexpr double dead_force = 1;
constexpr double gust_force = 0.3;
constexpr double layer_distance = 1;  // m, between both layers
constexpr double lantern_height = 0.5;

class Dome {
 public:
  explicit Dome(const DomeSize& size) : size_(size) {}

  Structure build();

 private:
  [[nodiscard]] double height(double distance) const;
  [[nodiscard]] double ring_radius(double ring) const { return size_.radius * ring / size_.rings; }
  void check() const;
  void add_nodes();
  void add_ring(const std::string& prefix, double ring, double shift, double below);
  void join(int first, int second);
  [[nodiscard]] int next(int sector) const { return (sector + 1) % size_.sectors; }
  // Node of the upper layer; ring 1 is the innermost one.
  [[nodiscard]] int upper(int ring, int sector) const {
    return first_ + (ring - 1) * size_.sectors + sector;
  }
  // Node of the ring below the lantern, or of the lower layer.
  [[nodiscard]] int lower(int ring, int sector) const { return upper(size_.rings + ring, sector); }
  void join_rings();
  void join_single_layer();
  void join_double_layer();
  void add_loads();

  DomeSize size_;
  Structure truss_;
  int first_ = 0;  // number of the first node of a ring
};

double Dome::height(double distance) const {
  const double share = distance / size_.radius;
  return size_.rise * (1 - share * share);
}

void Dome::check() const {
  const auto fail = [](const std::string& text) { throw std::invalid_argument(text); };
  if (size_.rings < 2 || size_.rings > max_rings)
    fail(fmt::format("a dome of {} rings; expected 2 to {}", size_.rings, max_rings));
  if (size_.sectors < 3 || size_.sectors > max_sectors)
    fail(fmt::format("a dome of {} sectors; expected 3 to {}", size_.sectors, max_sectors));
  if (!(size_.radius > 0) || !(size_.rise > 0))
    fail(fmt::format("a dome of radius {} and rise {}; expected positive lengths", size_.radius,
                     size_.rise));
}

// @param shift in sectors  @param below the paraboloid
void Dome::add_ring(const std::string& prefix, double ring, double shift, double below) {
  const double distance = ring_radius(ring);
  for (int k = 0; k < size_.sectors; ++k) {
    const double angle = 2 * std::numbers::pi * (k + shift) / size_.sectors;
    const auto column = static_cast<Eigen::Index>(truss_.node_names.size());
    truss_.coordinates.col(column) << rounded_place(distance * std::cos(angle)),
        rounded_place(distance * std::sin(angle)), rounded_place(height(distance) - below);
    truss_.node_names.push_back(fmt::format("{}{}", prefix, k));
    const bool fixed = below == 0 && ring == size_.rings;
    truss_.fixed.push_back({fixed, fixed, fixed});
  }
}

void Dome::add_nodes() {
  const int lower_rings = size_.kind == DomeKind::ring           ? 0
                          : size_.kind == DomeKind::double_layer ? size_.rings - 1
                                                                 : 1;
  first_ = size_.kind == DomeKind::ring ? 1 : 0;
  truss_.coordinates.resize(3, first_ + (size_.rings + lower_rings) * size_.sectors);
  if (size_.kind == DomeKind::ring) {
    truss_.coordinates.col(0) << 0, 0, size_.rise;
    truss_.node_names.emplace_back("c");
    truss_.fixed.push_back({false, false, false});
  }
  for (int ring = 1; ring <= size_.rings; ++ring) add_ring(fmt::format("{}.", ring), ring, 0, 0);
  if (size_.kind == DomeKind::lantern) add_ring("h.", 1, 0, lantern_height);
  if (size_.kind != DomeKind::double_layer) return;
  for (int ring = 1; ring < size_.rings; ++ring)
    add_ring(fmt::format("l{}.", ring), ring + 0.5, 0.5, layer_distance);
}

void Dome::join(int first, int second) {
  truss_.members.push_back({.first = first, .second = second, .yield = bar_yield});
}

// Rings and meridians of the upper layer; no bars between supports.
void Dome::join_rings() {
  for (int ring = 1; ring < size_.rings; ++ring) {
    for (int k = 0; k < size_.sectors; ++k) {
      join(upper(ring, k), upper(ring, next(k)));
      join(upper(ring, k), upper(ring + 1, k));
    }
  }
}

void Dome::join_single_layer() {
  for (int k = 0; k < size_.sectors; ++k) {
    for (int ring = 1; ring < size_.rings; ++ring) join(upper(ring, next(k)), upper(ring + 1, k));
    if (size_.kind == DomeKind::ring) {
      join(0, upper(1, k));
      continue;
    }
    join(lower(1, k), lower(1, next(k)));
    join(lower(1, k), upper(1, k));
    join(lower(1, k), upper(1, next(k)));
    join(lower(1, k), upper(2, k));
  }
}

void Dome::join_double_layer() {
  for (int ring = 1; ring < size_.rings; ++ring) {
    for (int k = 0; k < size_.sectors; ++k) {
      join(lower(ring, k), lower(ring, next(k)));
      if (ring + 1 < size_.rings) join(lower(ring, k), lower(ring + 1, k));
      for (const int above : {ring, ring + 1}) {
        join(lower(ring, k), upper(above, k));
        join(lower(ring, k), upper(above, next(k)));
      }
    }
  }
}

void Dome::add_loads() {
  truss_.uncertain.emplace();
  for (const char* const name : {"wind x", "wind y", "suction", "drift"})
    truss_.uncertain->push_back({.name = name, .components = {}});
  auto& uncertain = *truss_.uncertain;
  const int loaded = first_ + (size_.rings - 1) * size_.sectors;
  for (int node = 0; node < loaded; ++node) {
    truss_.loads.push_back({Load::Kind::reference, node, Eigen::Vector3d(0, 0, -snow_force)});
    truss_.loads.push_back({Load::Kind::dead, node, Eigen::Vector3d(0, 0, -dead_force)});
    uncertain[0].components.push_back({node, 0, gust_force});
    uncertain[1].components.push_back({node, 1, gust_force});
    const bool windward = truss_.coordinates(0, node) < 0;
    uncertain[windward ? 2 : 3].components.push_back(
        {node, 2, windward ? gust_force : -gust_force});
  }
}

Structure Dome::build() {
  check();
  const char* const kind = size_.kind == DomeKind::ring      ? "ring"
                           : size_.kind == DomeKind::lantern ? "lantern"
                                                             : "double-layer";
  truss_.name = fmt::format("{} dome of {} rings and {} sectors", kind, size_.rings, size_.sectors);
  truss_.dimension = 3;
  truss_.units = {"m", "kN"};
  add_nodes();
  join_rings();
  if (size_.kind == DomeKind::double_layer) {
    join_double_layer();
  } else {
    join_single_layer();
  }
  add_loads();
  return std::move(truss_);
}

}  // namespace

Structure dome(const DomeSize& size) {
  return Dome(size).build();
}

}  // namespace kusabi::problems
