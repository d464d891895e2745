// Vectors are drawn lengths: displacements and forces have the scales of the pictures.
#include "run/report/page/turning_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pictures/svg/friction_use.hpp"
#include "pictures/svg/scales.hpp"
#include "run/results/result_parser.hpp"

namespace kusabi::run {
namespace {

using pictures::Scene;

constexpr double units_of_half_size = 1e4;

/// Maximum number of faces and bars, which are drawn anew at each step of a turn.
constexpr std::size_t max_drawn = 20'000;

const char* name_of(pictures::ContactState state) {
  switch (state) {
    case pictures::ContactState::contact:
      return "in contact";
    case pictures::ContactState::separated:
      return "separated";
    case pictures::ContactState::inactive:
      return "inactive";
    case pictures::ContactState::none:
      break;
  }
  return "candidate";
}

class TurningData {
 public:
  explicit TurningData(const Scene& scene)
      : scene_(scene),
        scales_(scales_of(scene)),
        middle_((scene.positions.rowwise().maxCoeff() + scene.positions.rowwise().minCoeff()) / 2),
        unit_(2 * units_of_half_size / scales_.size),
        index_(static_cast<std::size_t>(scene.positions.cols()), -1) {}

  std::string text() {
    auto json = ResultJson::object();
    json["faces"] = ResultJson::array();
    for (const auto& face : scene_.faces) json["faces"].push_back(indices(face));
    json["bars"] = ResultJson::array();
    for (const auto& bar : scene_.bars) {
      json["bars"].push_back(
          {index(bar.nodes[0]), index(bar.nodes[1]), static_cast<int>(bar.state)});
    }
    json["supports"] = ResultJson::array();
    for (const auto& support : scene_.supports) json["supports"].push_back(index(support.node));
    json["arrows"] = arrows();
    json["candidates"] = candidates();
    json["places"] = places(false);
    if (scales_.displacement > 0) json["motions"] = places(true);
    return json.dump();
  }

 private:
  int index(int node) {
    auto& own = index_[static_cast<std::size_t>(node)];
    if (own < 0) {
      own = static_cast<int>(nodes_.size());
      nodes_.push_back(node);
    }
    return own;
  }
  ResultJson indices(const std::vector<int>& nodes) {
    auto list = ResultJson::array();
    for (const int node : nodes) list.push_back(index(node));
    return list;
  }
  [[nodiscard]] ResultJson whole(const Eigen::Vector3d& drawn) const {
    auto list = ResultJson::array();
    for (const double each : drawn) list.push_back(std::lround(unit_ * each));
    return list;
  }

  // Positions, or drawn displacements, of all nodes that are used.
  [[nodiscard]] ResultJson places(bool motions) const {
    auto list = ResultJson::array();
    for (const int node : nodes_) {
      Eigen::Vector3d place = scene_.positions.col(node) - middle_;
      if (motions) place = scales_.displacement * scene_.displacements.col(node);
      for (const double each : place) list.push_back(std::lround(unit_ * each));
    }
    return list;
  }

  ResultJson arrows() {
    auto list = ResultJson::array();
    const auto add = [&](const char* kind, int node, const Eigen::Vector3d& force, bool to) {
      if (force.norm() * unit_ < 1) return;
      list.push_back({{"kind", kind}, {"node", index(node)}, {"to", to}, {"force", whole(force)}});
    };
    for (const auto& load : scene_.loads) {
      const bool dead = load.kind == pictures::DrawnLoad::Kind::dead;
      add(dead ? "dead" : "reference", load.node, scales_.force * load.force, dead);
    }
    for (int node = 0; node < static_cast<int>(scene_.support_reactions.cols()); ++node)
      add("holding", node, scales_.force * scene_.support_reactions.col(node), true);
    return list;
  }

  ResultJson candidates() {
    auto list = ResultJson::array();
    for (const auto& each : scene_.candidates) {
      const double sense = sense_of(scene_, each);
      ResultJson json{{"name", each.name},
                      {"node", index(each.node)},
                      {"state", name_of(each.state)},
                      {"normal", whole(scales_.size / 2 * each.normal)},
                      {"sense", sense},
                      {"rigid", each.rigid}};
      if (is_loaded(each, scales_)) {
        json["force"] = whole(scales_.force * each.reaction);
        json["cone"] = std::lround(unit_ * scales_.cone);
        json["mu"] = each.friction;
        json["use"] = std::round(1e4 * friction_use(each)) / 1e4;
      }
      list.push_back(std::move(json));
    }
    return list;
  }

  const Scene& scene_;
  pictures::Scales scales_;
  Eigen::Vector3d middle_;
  double unit_;
  std::vector<int> index_;  // of the nodes drawn; -1: not drawn
  std::vector<int> nodes_;
};

}  // namespace

std::string turning_data(const Scene& scene) {
  const bool few = scene.faces.size() + scene.bars.size() <= max_drawn;
  return scene.dimension == 3 && few ? TurningData(scene).text() : std::string();
}

std::string turning_difference(const Scene& scene, const std::string& leading) {
  const auto other = ResultJson::parse(leading);
  const auto own = ResultJson::parse(turning_data(scene));
  auto different = ResultJson::object();
  for (const auto& [key, value] : own.items()) {
    const auto known = other.find(key);
    if (known == other.end() || *known != value) different[key] = value;
  }
  for (const auto& [key, value] : other.items()) {
    if (!own.contains(key)) different[key] = nullptr;
  }
  return different.dump();
}

}  // namespace kusabi::run
