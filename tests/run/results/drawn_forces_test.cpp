// Forces of scenes: as drawn, with one scale, they are in equilibrium.
#include <cmath>
#include <fstream>
#include <string>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "run/results/result_scenes.hpp"
#include "tests/run/shell.hpp"

namespace kusabi::test {
namespace {

using pictures::Scene;

/// Resultant and moment about the origin, relative to the sum of all forces.
class DrawnForces : public Command {
 protected:
  run::ResultScenes scenes(const std::string& subcommand, const std::string& file,
                           const std::string& words) {
    const auto call = fmt::format("{} {} {} {} --output {}", command, subcommand, quoted(file),
                                  words, argument("result.json"));
    const auto run = shell(call);
    EXPECT_EQ(run.exit_code, 0) << run.output;
    reader_.emplace(content(in_folder("result.json")), "result.json");
    return run::chosen_scenes(*reader_, {.maximum = 100});
  }
  static std::string example(const std::string& name) {
    return std::string(KUSABI_SOURCE_DIR) + "/examples/" + name;
  }

  // Forces between two bodies cancel.
  static double imbalance(const Scene& scene) {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    double all = 0;
    const auto add = [&](int node, const Eigen::Vector3d& force) {
      const Eigen::Vector3d place = scene.positions.col(node);
      sum.head<3>() += force;
      sum.tail<3>() += place.cross(force);
      all += force.norm() * std::max(1.0, place.norm());
    };
    for (const auto& load : scene.loads) add(load.node, load.force);
    for (const auto& candidate : scene.candidates)
      if (candidate.rigid) add(candidate.node, candidate.reaction);
    for (Eigen::Index node = 0; node < scene.support_reactions.cols(); ++node)
      add(static_cast<int>(node), scene.support_reactions.col(node));
    EXPECT_GT(all, 0);
    return sum.norm() / all;
  }

  // Work of the loads of a collapse mode, and of its yielding members.
  [[nodiscard]] std::pair<double, double> power(const Scene& scene) const {
    double loads = 0, members = 0;
    for (const auto& load : scene.loads)
      loads += load.force.dot(scene.displacements.col(load.node));
    const auto& yields = reader_->list(
        reader_->at(reader_->at(reader_->all(), "problem"), "structure"), "yield_forces");
    for (std::size_t i = 0; i < scene.bars.size(); ++i) {
      const auto& [a, b] = scene.bars[i].nodes;
      const Eigen::Vector3d along = (scene.positions.col(b) - scene.positions.col(a)).normalized();
      const double rate = along.dot(scene.displacements.col(b) - scene.displacements.col(a));
      if (scene.bars[i].state == pictures::BarState::tension)
        members += rate * yields[i][0].get<double>();
      if (scene.bars[i].state == pictures::BarState::compression)
        members -= rate * yields[i][1].get<double>();
    }
    return {loads, members};
  }

 private:
  std::optional<run::ResultReader> reader_;
};

TEST_F(DrawnForces, AreInEquilibriumInStatesUnderLoad) {
  for (const auto& [file, words] : {std::pair{"ladder.toml", "--mu 0.4"},
                                    {"ladder.toml", ""},
                                    {"peg-under-load.toml", "--mu 0.5"},
                                    {"peg-under-two-loads.toml", "--mu 0.4 --case side"}}) {
    SCOPED_TRACE(fmt::format("{} {}", file, words));
    const auto drawn = scenes("hold", example(file), words);
    ASSERT_FALSE(drawn.scenes.empty());
    for (const auto& scene : drawn.scenes) EXPECT_LT(imbalance(scene), 1e-6) << scene.name;
  }
}

TEST_F(DrawnForces, AreInEquilibriumInConfigurations) {
  for (const auto& [subcommand, file, words] :
       {std::tuple{"patterns", "plane-truss.toml", "--mu 0.8 --whole"},
        {"patterns", "space-truss.toml", "--mu 0.6 --whole"},
        {"patterns", "wedge-in-groove.toml", "--mu 0.3"},
        {"critical", "plane-truss.toml", ""},
        {"rays", "plane-truss.toml", "--mu 0.6 --whole"}}) {
    SCOPED_TRACE(fmt::format("{} {}", file, words));
    const auto drawn = scenes(subcommand, example(file), words);
    ASSERT_FALSE(drawn.scenes.empty());
    for (const auto& scene : drawn.scenes) EXPECT_LT(imbalance(scene), 1e-6) << scene.name;
  }
}

TEST_F(DrawnForces, AreThoseOfTheCollapse) {
  for (const auto& [file, words] : {std::pair{"gust.toml", "--alpha 0.5"},
                                    {"truss-bridge.toml", "--alpha 2"},
                                    {"steel-mast.toml", ""},
                                    {"roof-truss.toml", ""}}) {
    SCOPED_TRACE(fmt::format("{} {}", file, words));
    const auto drawn = scenes("limit", example(file), words);
    ASSERT_FALSE(drawn.scenes.empty());
    for (const auto& scene : drawn.scenes) {
      EXPECT_LT(imbalance(scene), 1e-6) << scene.name;
      const auto [loads, members] = power(scene);
      EXPECT_GT(members, 0);
      EXPECT_NEAR(loads, members, 1e-6 * members) << scene.name;
    }
  }
}

TEST_F(DrawnForces, AreThoseOfTheCollapseAfterALoss) {
  const auto drawn = scenes("limit", example("gust.toml"), "--lose 1 --sudden 1.2");
  ASSERT_EQ(drawn.scenes.size(), 2U);
  const auto [loads, members] = power(drawn.scenes[1]);
  EXPECT_GT(members, 0);
  EXPECT_NEAR(loads, members, 1e-6 * members);
}

}  // namespace
}  // namespace kusabi::test
