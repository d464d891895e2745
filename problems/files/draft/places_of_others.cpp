// Opposite places by edges or groups, by nodes, and by weights.
#include "problems/files/draft/places_of_others.hpp"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "problems/structure/geometry/surface_place.hpp"

namespace kusabi::problems {
namespace {

class PlacesOfOthers {
 public:
  PlacesOfOthers(const ProblemDraft& draft, const TomlTable& group, std::string_view key)
      : draft_(draft), reader_(draft.reader()), key_(key), entry_(*group.table->get(key)) {
    const toml::node* gap = group.table->get("gap");
    if (gap == nullptr) return;
    gap_ = reader_.number(*gap, "gap");
    if (*gap_ < 0) {
      reader_.fail(*gap, fmt::format("gap is {:g}; expected a length of 0 or more", *gap_));
    }
  }

  std::vector<std::vector<WeightedNode>> of(const std::vector<ListedNode>& nodes) const {
    if (entry_.is_string()) return on_surface(nodes);
    const auto entries = reader_.elements(entry_, key_);
    return entries.front()->is_table() ? as_given(nodes, entries) : on_nodes(nodes);
  }

 private:
  auto places() const { return draft_.structure().coordinates.leftCols(draft_.node_count()); }

  std::vector<std::vector<WeightedNode>> on_surface(const std::vector<ListedNode>& nodes) const {
    const TomlText name = reader_.text(entry_, key_);
    const auto group = draft_.nodes_named(name);
    const auto faces = faces_within(draft_.structure(), group);
    if (faces.empty()) {
      reader_.fail(entry_,
                   fmt::format("{} is not a surface: no element has an edge or face within it; "
                               "expected the name of an edge or group, or a list of nodes",
                               support::in_quotes(name.text)));
    }
    std::vector<std::vector<WeightedNode>> result;
    for (const ListedNode& node : nodes) {
      auto place = *nearest_place(places(), faces, places().col(node.node));
      require_touch(node, place.distance, place.size, support::in_quotes(name.text));
      result.push_back(std::move(place.shares));
    }
    return result;
  }

  std::vector<std::vector<WeightedNode>> on_nodes(const std::vector<ListedNode>& nodes) const {
    std::vector<int> others;
    for (const TomlText& name : reader_.texts(entry_, key_)) {
      for (const int node : draft_.nodes_named(name)) others.push_back(node);
    }
    const double size = (places().rowwise().maxCoeff() - places().rowwise().minCoeff()).maxCoeff();
    std::vector<std::vector<WeightedNode>> result;
    for (const ListedNode& node : nodes) {
      const auto distance = [&](int other) {
        return (places().col(other) - places().col(node.node)).norm();
      };
      int nearest = others.front();
      for (const int other : others) {
        if (distance(other) < distance(nearest)) nearest = other;
      }
      require_touch(node, distance(nearest), size, draft_.node_name(nearest));
      for (const int other : others) {
        if (other != nearest && distance(other) == distance(nearest))
          refuse_choice(node, nearest, other);
      }
      result.push_back({{nearest, 1.0}});
    }
    return result;
  }

  std::vector<std::vector<WeightedNode>> as_given(
      const std::vector<ListedNode>& nodes, const std::vector<const toml::node*>& entries) const {
    if (entries.size() != nodes.size()) {
      reader_.fail(entry_, fmt::format("{} has {} places for {} nodes; expected one each", key_,
                                       entries.size(), nodes.size()));
    }
    std::vector<std::vector<WeightedNode>> result;
    for (const toml::node* entry : entries) {
      const TomlTable place = reader_.table(*entry, fmt::format("a place of {}", key_));
      reader_.allow_only(place, {"nodes", "weights"});
      const auto names =
          reader_.texts(reader_.require(place, "nodes", "nodes = [\"a\", ...]"), "nodes");
      const auto weights = reader_.vector(
          reader_.require(place, "weights", "weights = [...], a number for each node"), "weights",
          static_cast<int>(names.size()));
      auto& shares = result.emplace_back();
      for (std::size_t i = 0; i < names.size(); ++i)
        shares.push_back({draft_.node(names[i]), weights(static_cast<Eigen::Index>(i))});
    }
    return result;
  }

  void require_touch(const ListedNode& node, double distance, double size,
                     const std::string& what) const {
    const double maximum = gap_.value_or(place_tolerance * size);
    if (distance <= maximum) return;
    reader_.fail(node.position,
                 fmt::format("node {} is {:.6g} away from {}; expected at most {:.6g}, or gap = a "
                             "length that counts as touching",
                             draft_.node_name(node.node), distance, what, maximum));
  }

  [[noreturn]] void refuse_choice(const ListedNode& node, int one, int other) const {
    reader_.fail(
        entry_,
        fmt::format("node {} is as near to {} as to {}; expected one node where it "
                    "is, or the name of an edge",
                    draft_.node_name(node.node), draft_.node_name(one), draft_.node_name(other)));
  }

  const ProblemDraft& draft_;
  const TomlReader& reader_;
  std::string_view key_;
  const toml::node& entry_;
  std::optional<double> gap_;
};

}  // namespace

std::vector<std::vector<WeightedNode>> places_of_others(const ProblemDraft& draft,
                                                        const TomlTable& group,
                                                        std::string_view key,
                                                        const std::vector<ListedNode>& nodes) {
  return PlacesOfOthers(draft, group, key).of(nodes);
}

}  // namespace kusabi::problems
