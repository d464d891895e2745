// Selection of the nodes of each pair: those that are too far away, tied, or supported along their
// normal are left out.
#include "problems/files/decks/deck_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/files/decks/deck_touch.hpp"
#include "problems/files/toml/toml_text.hpp"

namespace kusabi::problems {
namespace {

/// Tolerance of ties without one in the deck, relative to the size of the face, as in Abaqus.
constexpr double usual_tie = 0.05;

/// Smaller components of a normal along a supported axis count as zero.
constexpr double along_axis = 1e-3;

/// Normals of one node belong to one surface if the cosine of the angle between them is larger.
constexpr double same_normal = 0.99;

class PairWriter {
 public:
  PairWriter(DeckDraft& draft, std::optional<double> gap)
      : draft_(draft), gap_(gap), largest_friction_(largest_friction(draft.mesh())) {
    for (const MeshSupport& support : draft.mesh().supports) {
      const auto last = support.fixed.begin() + draft.dimension();
      if (std::find(support.fixed.begin(), last, true) != last)
        fixed_[support.node] = support.fixed;
    }
  }

  void write(const MeshPair& pair);

 private:
  struct Sides {
    const MeshGroup* own;
    const MeshGroup* other;        // null: an analytical rigid surface
    std::vector<FaceNodes> faces;  // of the other
    bool rigid;
    /// Normal of the other surface, if that is plane and the nodes belong to no faces.
    std::optional<Eigen::VectorXd> plane;
  };

  std::optional<Sides> sides(const MeshPair& pair);
  /// Leaves out nodes beyond the tolerance. @return the largest distance of the others
  double keep_near(const MeshPair& pair, const Sides& sides, ChosenNodes& nodes);
  void leave_out(const MeshPair& pair, ChosenNodes& nodes, std::string_view why,
                 const std::function<bool(int)>& is_out);
  bool all_fixed(int node) const;
  void write_tie(const MeshPair& pair, const Sides& sides, ChosenNodes nodes);
  void write_contact(const MeshPair& pair, const Sides& sides, ChosenNodes nodes);
  void leave_out_by_normals(const MeshPair& pair, const Sides& sides, ChosenNodes& nodes);

  DeckDraft& draft_;
  std::optional<double> gap_;
  double largest_friction_;
  std::map<int, std::array<bool, 3>> fixed_;
  std::multimap<int, Eigen::VectorXd> normals_;  // of the candidates written so far
  std::set<std::pair<std::string, std::string>> written_;
};

std::optional<PairWriter::Sides> PairWriter::sides(const MeshPair& pair) {
  const MeshGroup* own = draft_.group(pair.nodes);
  const MeshGroup* other = draft_.group(pair.against);
  if (own == nullptr || draft_.nodes_of_surface(*own).all.empty()) {
    draft_.warn(pair.at, fmt::format("surface {} has no node of the body, and its pair is left out",
                                     pair.nodes));
    return std::nullopt;
  }
  if (written_.contains({pair.against, pair.nodes})) {
    draft_.warn(pair.at, "a pair that is given already with its surfaces exchanged is left out");
    return std::nullopt;
  }
  written_.emplace(pair.nodes, pair.against);
  Sides result{own, other, {}, true, {}};
  if (other != nullptr) {
    result.faces = faces_of_group(draft_, *other);
    result.rigid = std::ranges::none_of(result.faces, [&](const FaceNodes& face) {
      return std::ranges::all_of(face, [&](int node) { return draft_.is_used(node); });
    });
    if (own->faces.empty()) result.plane = normal_of_plane(draft_, *other);
    if (result.faces.empty()) {
      draft_.warn(pair.at,
                  fmt::format("surface {} has no faces, and its pair is left out", pair.against));
      return std::nullopt;
    }
  }
  return result;
}

void PairWriter::leave_out(const MeshPair& pair, ChosenNodes& nodes, std::string_view why,
                           const std::function<bool(int)>& is_out) {
  const auto count = std::erase_if(nodes.chosen, is_out);
  if (count == 0) return;
  draft_.warn(pair.at,
              fmt::format("{} of {} nodes of {} {}", count, nodes.all.size(), pair.nodes, why));
}

double PairWriter::keep_near(const MeshPair& pair, const Sides& sides, ChosenNodes& nodes) {
  if (sides.faces.empty()) return 0;
  const auto tolerance = gap_ ? gap_ : pair.tolerance;
  const auto distances = touches(draft_, nodes.chosen, sides.faces);
  std::vector<int> near;
  double largest = 0;
  double nearest_out = HUGE_VAL;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const auto [distance, size] = distances[i];
    const double usual = (pair.tied ? usual_tie : place_tolerance) * size;
    if (distance <= std::max(tolerance.value_or(usual), place_tolerance * size)) {
      near.push_back(nodes.chosen[i]);
      if (distance > place_tolerance * size) largest = std::max(largest, distance);
    } else {
      nearest_out = std::min(nearest_out, distance);
    }
  }
  if (near.size() < nodes.chosen.size()) {
    draft_.warn(pair.at,
                fmt::format("{} of {} nodes of {} do not touch {}, the nearest of them at {:.6g}; "
                            "--gap says which distance counts as touching",
                            nodes.chosen.size() - near.size(), nodes.all.size(), pair.nodes,
                            pair.against, nearest_out));
  }
  nodes.chosen = std::move(near);
  return largest;
}

bool PairWriter::all_fixed(int node) const {
  const auto found = fixed_.find(node);
  if (found == fixed_.end()) return false;
  const auto& axes = found->second;
  return std::all_of(axes.begin(), axes.begin() + draft_.dimension(),
                     [](bool fixed) { return fixed; });
}

void PairWriter::write_tie(const MeshPair& pair, const Sides& sides, ChosenNodes nodes) {
  if (sides.rigid) {
    draft_.warn(pair.at, fmt::format("a tie to {}, which is rigid, is left out: give its nodes as "
                                     "[[supports]]",
                                     pair.against));
    return;
  }
  const double largest = keep_near(pair, sides, nodes);
  leave_out(pair, nodes, "are supported and not tied",
            [&](int node) { return fixed_.contains(node); });
  if (nodes.chosen.empty()) return;
  draft_.tied.insert(nodes.chosen.begin(), nodes.chosen.end());
  draft_.write(fmt::format("\n[[ties]]                   # {}\n{}to = {}\n", draft_.line(pair.at),
                           draft_.lines(nodes), toml_text(draft_.name(pair.against))));
  if (largest > 0) draft_.write(fmt::format("gap = {}\n", std::nextafter(largest, HUGE_VAL)));
}

// Normals are compared where the surface of the nodes has faces.
void PairWriter::leave_out_by_normals(const MeshPair& pair, const Sides& sides,
                                      ChosenNodes& nodes) {
  auto normals = normals_at_nodes(draft_, faces_of_group(draft_, *sides.own));
  if (sides.plane)
    for (const int node : nodes.chosen) normals.insert_or_assign(node, *sides.plane);
  leave_out(pair, nodes, "are supported along their normal and no candidates", [&](int node) {
    const auto fixed = fixed_.find(node);
    const auto normal = normals.find(node);
    if (fixed == fixed_.end()) return false;
    if (normal == normals.end()) return all_fixed(node);
    for (int axis = 0; axis < draft_.dimension(); ++axis) {
      const bool held = fixed->second[static_cast<std::size_t>(axis)];
      if (held && std::abs(normal->second(axis)) > along_axis) return true;
    }
    return false;
  });
  leave_out(pair, nodes, "are candidates of an earlier pair with the same normal", [&](int node) {
    const auto normal = normals.find(node);
    const auto [first, last] = normals_.equal_range(node);
    return normal != normals.end() && std::any_of(first, last, [&](const auto& other) {
             return std::abs(other.second.dot(normal->second)) > same_normal;
           });
  });
  for (const int node : nodes.chosen) {
    const auto normal = normals.find(node);
    if (normal != normals.end()) normals_.emplace(node, normal->second);
  }
}

void PairWriter::write_contact(const MeshPair& pair, const Sides& sides, ChosenNodes nodes) {
  const double largest = keep_near(pair, sides, nodes);
  leave_out(pair, nodes, "are tied and no candidates",
            [&](int node) { return draft_.tied.contains(node); });
  leave_out_by_normals(pair, sides, nodes);
  if (sides.other == nullptr) {
    draft_.warn(pair.at,
                fmt::format("the rigid surface of this pair is not a mesh: all nodes of {} are "
                            "taken as touching it",
                            pair.nodes));
  }
  if (nodes.chosen.empty()) return;
  const std::string other = sides.other == nullptr ? "rigid surface" : pair.against;
  draft_.write(fmt::format(
      "\n[[contact]]                # {}, {} candidates{}\n{}name = {}\n", draft_.line(pair.at),
      nodes.chosen.size(),
      pair.friction ? fmt::format(", friction {}", *pair.friction) : std::string(", no *FRICTION"),
      draft_.lines(nodes), toml_text(other)));
  if (!sides.rigid) {
    draft_.write(fmt::format("against = {}\n", toml_text(draft_.name(pair.against))));
    if (largest > 0) draft_.write(fmt::format("gap = {}\n", std::nextafter(largest, HUGE_VAL)));
  }
  if (!sides.plane) {
    draft_.write("normal = \"surface\"\n");
  } else {
    const auto numbers =
        fmt::format("[{}]", fmt::join(sides.plane->begin(), sides.plane->end(), ", "));
    draft_.write(sides.rigid ? fmt::format("normal = {{ plane = {} }}\n", numbers)
                             : fmt::format("normal = {}\n", numbers));
  }
  const double factor = largest_friction_ > 0 ? pair.friction.value_or(0) / largest_friction_ : 1;
  if (factor != 1) draft_.write(fmt::format("friction_factor = {}\n", factor));
}

void PairWriter::write(const MeshPair& pair) {
  const auto found = sides(pair);
  if (!found) return;
  const ChosenNodes nodes = draft_.nodes_of_surface(*found->own);
  if (pair.tied) {
    write_tie(pair, *found, nodes);
  } else {
    write_contact(pair, *found, nodes);
  }
}

}  // namespace

double largest_friction(const MeshData& mesh) {
  double largest = 0;
  for (const MeshPair& pair : mesh.pairs)
    if (!pair.tied) largest = std::max(largest, pair.friction.value_or(0));
  return largest;
}

void write_pairs(DeckDraft& draft, std::optional<double> gap) {
  PairWriter writer(draft, gap);
  for (const bool tied : {true, false}) {
    for (const MeshPair& pair : draft.mesh().pairs)
      if (pair.tied == tied) writer.write(pair);
  }
}

}  // namespace kusabi::problems
