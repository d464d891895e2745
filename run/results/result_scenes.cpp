// Scenes of each subcommand.
#include "run/results/result_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "run/output/rounded_within.hpp"
#include "run/output/wrong_input.hpp"
#include "run/results/drawn_structure.hpp"
#include "run/results/result_reader.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using pictures::ContactState;
using pictures::Scene;

/// Lists of names end there: three lines of a picture.
constexpr std::size_t longest_names = 330;
/// digits of a number in a picture.
constexpr int digits_of_picture = 6;
/// of a friction coefficient that is found: lower and upper bound differ.
constexpr int digits_of_coefficient = 10;

// "in contact: a b c", "in contact: a b and 7 more"; empty if there are none.
std::string listed_names(const std::string& what, const std::vector<std::string>& names) {
  if (names.empty()) return {};
  auto line = what + ':';
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (line.size() + names[i].size() > longest_names)
      return line + fmt::format(" and {} more", names.size() - i);
    line += ' ' + names[i];
  }
  return line;
}

void add_line(Scene& scene, std::string line) {
  if (!line.empty()) scene.lines.push_back(std::move(line));
}

class SceneReader {
 public:
  SceneReader(const ResultReader& reader, SceneChoice choice)
      : reader_(reader),
        choice_(std::move(choice)),
        result_(reader.at(reader.all(), "result")),
        structure_(drawn_structure(reader)),
        dimension_(structure_.scene.dimension) {}

  ResultScenes read() {
    ResultScenes all;
    const auto& problem = reader_.at(reader_.all(), "problem");
    const auto& units = reader_.at(problem, "units");
    all.picture = {reader_.text(problem, "name"),
                   {},
                   {reader_.text(units, "length"), reader_.text(units, "force")}};
    all.structure = structure_.scene;
    all.structure.name = "structure";
    const auto command = reader_.text(reader_.all(), "command");
    all.things = command == "rays"    ? "rays"
                 : command == "limit" ? "collapses"
                 : command == "hold"  ? "states"
                                      : "patterns";
    if (command == "patterns") {
      read_patterns(all);
    } else if (command == "rays") {
      read_rays(all);
    } else if (command == "critical") {
      read_critical(all);
    } else if (command == "limit") {
      read_collapses(all);
    } else if (command == "hold") {
      read_states(all);
    } else if (command != "sweep") {  // a sweep is a chart
      reader_.refuse(fmt::format("is a result of kusabi {}", command));
    }
    return all;
  }

 private:
  // Counts a scene. @return true if it is to be made
  [[nodiscard]] bool is_chosen(ResultScenes& all, std::size_t entry = 0) const {
    const std::size_t number = all.count++;
    if (!choice_.entries.empty()) return std::ranges::binary_search(choice_.entries, entry);
    return number >= choice_.first && number - choice_.first < choice_.maximum;
  }

  // A remark, once, if a configuration has the reactions of the candidates only.
  static void add_remark_on_whole(ResultScenes& all, const ResultJson& configuration,
                                  const char* command) {
    if (ResultReader::find(configuration, "all_displacements") != nullptr) return;
    auto text = fmt::format(
        "only contact candidates: kusabi {} --whole adds all displacements and the "
        "reactions of supports",
        command);
    if (all.picture.lines.back() != text) all.picture.lines.push_back(std::move(text));
  }

  [[nodiscard]] std::string friction_in_words(double coefficient) const {
    return answer::friction_words(fmt::format("{:.10g}", coefficient), has_own_friction(reader_));
  }

  // The structure with a friction coefficient.
  [[nodiscard]] Scene at_friction(double coefficient) const {
    auto scene = structure_.scene;
    for (auto& candidate : scene.candidates) candidate.friction *= coefficient;
    return scene;
  }

  // The load that the pattern holds while its normal reactions add up to 1, if it is known.
  void add_firmness(Scene& scene, const ResultJson& pattern) const {
    const auto* const firmness = ResultReader::find(pattern, "firmness");
    if (firmness == nullptr) return;
    const auto end = [&](const char* key, const char* without, const auto& rounded) {
      return ResultReader::find(*firmness, key) == nullptr
                 ? std::string(without)
                 : rounded(reader_.number(*firmness, key), digits_of_picture);
    };
    add_line(scene,
             fmt::format("load held at a sum of normal reactions of 1: factors from {} to {}",
                         end("low", "-∞", support::rounded_up),
                         end("high", "∞", support::rounded_down)));
  }

  void read_patterns(ResultScenes& all) {
    const double friction = reader_.number(result_, "friction");
    const auto& patterns = reader_.list(result_, "patterns");
    all.picture.lines = {answer::counted(patterns.size(), "sign pattern") + " at " +
                         friction_in_words(friction)};
    for (const auto& pattern : patterns) {
      if (!is_chosen(all, all.count)) continue;
      add_remark_on_whole(all, pattern, "patterns");
      auto scene = at_friction(friction);
      scene.name = fmt::format("pattern {}", all.count);
      const auto state = reader_.text(pattern, "state");
      const bool has_margin = ResultReader::find(pattern, "margin") != nullptr;
      scene.note = state != "feasible" ? state
                   : !has_margin
                       ? std::string()
                       : "t* " + support::rounded_down(reader_.number(pattern, "margin"), 3);
      if (state == "feasible" && has_margin)
        add_line(scene, "margin t* = " + support::rounded_down(reader_.number(pattern, "margin"),
                                                               digits_of_picture));
      add_firmness(scene, pattern);
      add_signs(scene, pattern);
      add_configuration(scene, pattern);
      all.entries.push_back(all.count - 1);
      all.scenes.push_back(std::move(scene));
    }
  }

  void read_critical(ResultScenes& all) {
    all.picture.lines = {reader_.sentence()};
    std::size_t entry = 0;
    for (const auto& pattern : reader_.list(result_, "patterns")) {
      ++entry;
      if (ResultReader::find(pattern, "reaction") == nullptr || !is_chosen(all, entry - 1))
        continue;
      const double friction = reader_.number(pattern, "upper");
      auto scene = at_friction(friction);
      scene.name = fmt::format("pattern {}", all.count);
      scene.note = "μ " + support::rounded_up(friction, digits_of_picture);
      add_signs(scene, pattern);
      add_configuration(scene, pattern);
      all.entries.push_back(entry - 1);
      all.scenes.push_back(std::move(scene));
    }
  }

  void read_rays(ResultScenes& all) {
    const double friction = reader_.number(result_, "friction");
    const auto& rays = reader_.list(result_, "rays");
    all.picture.lines = {answer::counted(rays.size(), "extremal ray") + " at " +
                         friction_in_words(friction)};
    if (!rays.empty()) add_remark_on_whole(all, rays.front(), "rays");
    for (const auto& ray : rays) {
      if (!is_chosen(all, all.count)) continue;
      auto scene = at_friction(friction);
      scene.name = fmt::format("ray {}", all.count);
      const auto states = reader_.names(ray, "state");
      if (states.size() != scene.candidates.size()) reader_.refuse("'state' has another length");
      std::vector<std::string> words;
      for (std::size_t i = 0; i < states.size(); ++i) {
        auto& candidate = scene.candidates[i];
        candidate.state = states[i] == "separates" ? ContactState::separated
                          : states[i] == "idle"    ? ContactState::inactive
                                                   : ContactState::contact;
        if (states[i] != "idle") words.push_back(candidate.name + ' ' + states[i] + ',');
      }
      if (!words.empty()) words.back().pop_back();
      add_line(scene, listed_names("candidates", words));
      add_configuration(scene, ray);
      all.entries.push_back(all.count - 1);
      all.scenes.push_back(std::move(scene));
    }
  }

  void read_states(ResultScenes& all) {
    for (const auto* const entry : held_states(reader_)) {
      if (!is_chosen(all, all.count)) continue;
      const auto given = given_friction(reader_);
      const double friction = given ? *given : reader_.bound(*entry, "upper").value_or(0);
      const auto coefficient = given ? fmt::format("{}", friction)
                                     : support::rounded_up(friction, digits_of_coefficient);
      auto scene = at_friction(friction);
      const auto& state = reader_.at(*entry, "state");
      const double factor = reader_.number(state, "factor");
      const auto [low, high] = held_range(reader_, *entry);
      const auto load = under_factor(factor, low, high);
      scene.name = fmt::format("state {} {}", all.count, load);
      scene.note = "μ " + coefficient;
      add_signs(scene, reader_.at(*entry, "pattern"));
      for (const auto& [name, force] : reader_.at(state, "reactions").items()) {
        const auto i = candidate_named(name);
        scene.candidates[i].reaction = structure_.frames[i] * reader_.vector(force, dimension_);
      }
      add_loads(scene, {.factor = factor,
                        .factor_text = rounded_within(factor, low, high, digits_of_picture)});
      add_line(scene, "held " + load + (factor == 0 ? "" : " of the reference load"));
      all.picture.lines = {"states of equilibrium at " +
                           answer::friction_words(coefficient, has_own_friction(reader_))};
      all.entries.push_back(all.count - 1);
      all.scenes.push_back(std::move(scene));
    }
  }

 public:
  // A motion on which a load does work that no reaction resists.
  [[nodiscard]] Scene exclusion_scene(const ResultJson& motion) const {
    const double factor = reader_.number(motion, "factor");
    auto scene = at_friction(reader_.number(motion, "friction"));
    const auto load = factor == 0 ? std::string("the dead load")
                                  : fmt::format("factor {:.{}g}", factor, digits_of_picture);
    scene.name = "motion under " + load;
    scene.note = "cannot be held";
    scene.collapse = true;
    scene.motion = "motion that no reaction resists";
    scene.displacements = moving(motion);
    for (const auto& body : reader_.list(motion, "bodies")) {
      add_line(scene, fmt::format("the body of node {} {}", reader_.text(body, "node"),
                                  reader_.text(body, "motion")));
    }
    add_line(scene, listed_names("contact slides at", reader_.names(motion, "sliding")));
    add_line(scene, listed_names("contact opens at", reader_.names(motion, "opening")));
    add_loads(scene, {.factor = factor});
    return scene;
  }

 private:
  void read_collapses(ResultScenes& all) {
    const auto* const nominal = ResultReader::find(result_, "nominal_mode");
    // In the middle of the ranges of its factors a combination of actions has no meaning of its own.
    const bool in_the_middle = ResultReader::find(result_, "critical_factors") != nullptr &&
                               ResultReader::find(result_, "collapse_mode") != nullptr;
    if (nominal != nullptr && !in_the_middle && is_chosen(all)) {
      const double factor = reader_.number(result_, "nominal");
      auto scene = collapse("nominal load", factor, *nominal);
      add_loads(scene, {.factor = factor});
      scene.support_reactions = by_node(result_, "nominal_support_reactions");
      all.scenes.push_back(std::move(scene));
    }
    read_loss(all);
    const auto* const worst_mode = ResultReader::find(result_, "collapse_mode");
    if (worst_mode != nullptr && is_chosen(all)) {
      // The reactions are those at the factor of the critical load, the upper bound up to rounding.
      const auto& interval = reader_.list(result_, "critical_interval", 2);
      const auto upper = reader_.bound(reader_.at(result_, "maximum"), "upper");
      const double factor = reader_.number_of(interval[1], "'critical_interval'");
      auto scene = collapse("worst case", upper.value_or(factor), *worst_mode);
      add_loads(scene, {.factor = factor, .critical = &result_});
      scene.support_reactions = by_node(result_, "support_reactions");
      const bool alike = ResultReader::find(result_, "alpha") != nullptr;
      add_line(scene, alike ? fmt::format("dead load uncertain up to α = {:.10g}",
                                          reader_.number(result_, "alpha"))
                            : std::string("dead load uncertain, with individual half-widths"));
      all.scenes.push_back(std::move(scene));
    }
  }

  // The collapse after the worst loss of members.
  void read_loss(ResultScenes& all) const {
    const auto* const loss = ResultReader::find(result_, "member_loss");
    if (loss == nullptr) return;
    const auto* const mode = ResultReader::find(*loss, "collapse_mode");
    // Earlier versions could write a loss in one load case beside an answer about another.
    if (ResultReader::find(result_, "lost") == nullptr) return;
    const auto lost = reader_.names(result_, "lost");
    if (mode == nullptr || lost.empty() || !is_chosen(all)) return;
    const auto upper = reader_.bound(reader_.at(result_, "factor"), "upper");
    const double factor = upper.value_or(-HUGE_VAL);
    auto scene = collapse("worst loss", factor, *mode);
    for (const auto& index : reader_.list(*loss, "lost_index", lost.size())) {
      const auto i = static_cast<std::size_t>(reader_.index(index, scene.bars.size()));
      scene.bars[i].state = pictures::BarState::lost;
    }
    add_line(scene, listed_names("lost", lost));
    const bool critical = ResultReader::find(*loss, "critical_load") != nullptr;
    add_loads(scene, {.factor = upper.value_or(0),
                      .sudden = ResultReader::find(result_, "sudden") == nullptr
                                    ? 1
                                    : reader_.number(result_, "sudden"),
                      .critical = critical ? loss : nullptr});
    all.scenes.push_back(std::move(scene));
  }

  Scene collapse(const std::string& name, double factor, const ResultJson& mode) const {
    auto scene = structure_.scene;
    scene.collapse = true;
    scene.name = name;
    const bool carried = factor > -HUGE_VAL;
    scene.note = carried ? fmt::format("λ = {:.6g}", factor) : "at any load factor";
    scene.lines = {carried ? fmt::format("collapses at load factor λ = {:.10g}", factor)
                           : "collapses at any load factor"};
    scene.displacements = moving(mode);
    for (const auto& yielding : reader_.list(mode, "yielding")) {
      const auto ends = reader_.names(yielding, "member");
      if (ends.size() != 2) reader_.refuse("a member does not have two nodes");
      const std::array<int, 2> nodes{node_named(ends[0]), node_named(ends[1])};
      for (auto& bar : scene.bars) {
        if (bar.nodes != nodes) continue;
        bar.state = reader_.text(yielding, "in") == "tension" ? pictures::BarState::tension
                                                              : pictures::BarState::compression;
      }
    }
    return scene;
  }

  // Velocities by node.
  [[nodiscard]] Eigen::Matrix3Xd moving(const ResultJson& motion) const {
    Eigen::Matrix3Xd velocities = Eigen::Matrix3Xd::Zero(3, structure_.scene.positions.cols());
    for (const auto& each : reader_.list(motion, "moving")) {
      velocities.col(node_named(reader_.text(each, "node"))) =
          reader_.vector(reader_.at(each, "velocity"), dimension_);
    }
    return velocities;
  }

  struct LoadsOfScene {
    double factor;              // of the reference load; 0: it does not act
    std::string factor_text{};  // empty: rounded to the nearest
    double sudden = 1;          // dynamic factor of all loads
    const ResultJson* critical =
        nullptr;  // has the dead load that acts in place of that of the file
  };

  // Loads as they act.
  void add_loads(Scene& scene, const LoadsOfScene& chosen) const {
    using Kind = pictures::DrawnLoad::Kind;
    const auto& structure = reader_.at(reader_.at(reader_.all(), "problem"), "structure");
    const auto each = [&](const char* key, auto&& add) {
      if (ResultReader::find(structure, key) == nullptr) return;
      for (const auto& load : reader_.list(structure, key))
        add(reader_.index(reader_.at(load, "node"), structure_.nodes.size()), force_of(load));
    };
    if (chosen.critical == nullptr) {
      each("dead_loads", [&](int node, const Eigen::Vector3d& force) {
        scene.loads.push_back({Kind::dead, node, chosen.sudden * force});
      });
    } else {
      for (const auto& load : reader_.list(*chosen.critical, "critical_load"))
        scene.loads.push_back(
            {Kind::dead, node_named(reader_.text(load, "node")), chosen.sudden * force_of(load)});
      // The critical load has no part on supported displacements.
      each("dead_loads", [&](int node, const Eigen::Vector3d& force) {
        const Eigen::Vector3d part = on_supports(node, force);
        if (!part.isZero(0)) scene.loads.push_back({Kind::dead, node, chosen.sudden * part});
      });
      scene.load_names.dead = "critical dead load";
    }
    if (chosen.factor != 0) {
      each("reference_loads", [&](int node, const Eigen::Vector3d& force) {
        scene.loads.push_back({Kind::reference, node, chosen.sudden * chosen.factor * force});
      });
    }
    if (chosen.sudden != 1) scene.load_names.dead += fmt::format(" × {:.6g}", chosen.sudden);
    scene.load_names.reference +=
        " × " + (chosen.factor_text.empty() ? fmt::format("{:.6g}", chosen.sudden * chosen.factor)
                                            : chosen.factor_text);
  }

  [[nodiscard]] Eigen::Vector3d force_of(const ResultJson& load) const {
    return reader_.vector(reader_.at(load, "force"), dimension_);
  }

  // The components along axes at which the node is supported.
  [[nodiscard]] Eigen::Vector3d on_supports(int node, Eigen::Vector3d force) const {
    const auto& supports = structure_.scene.supports;
    const auto found = std::ranges::find(supports, node, &pictures::DrawnSupport::node);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (found == supports.end() || !found->fixed[axis]) force[static_cast<int>(axis)] = 0;
    return force;
  }

  [[nodiscard]] int node_named(const std::string& name) const {
    const auto found = structure_.nodes.find(name);
    if (found == structure_.nodes.end()) reader_.refuse(fmt::format("there is no node '{}'", name));
    return found->second;
  }

  [[nodiscard]] std::size_t candidate_named(const std::string& name) const {
    const auto found = structure_.candidates.find(name);
    if (found == structure_.candidates.end())
      reader_.refuse(fmt::format("there is no candidate '{}'", name));
    return found->second;
  }

  // States of the candidates of a pattern.
  void add_signs(Scene& scene, const ResultJson& pattern) const {
    const auto set = [&](const char* key, const char* what, ContactState state) {
      if (ResultReader::find(pattern, key) == nullptr) return;
      const auto names = reader_.names(pattern, key);
      for (const auto& name : names) scene.candidates[candidate_named(name)].state = state;
      add_line(scene, listed_names(what, names));
    };
    set("contact", "in contact", ContactState::contact);
    set("separated", "separated", ContactState::separated);
    set("inactive", "inactive", ContactState::inactive);
  }

  // Reactions, from the frames of the candidates to global axes; displacements of nodes, support
  // reactions.
  void add_configuration(Scene& scene, const ResultJson& configuration) const {
    const auto& reactions = reader_.list(configuration, "reaction", scene.candidates.size());
    for (std::size_t i = 0; i < scene.candidates.size(); ++i) {
      scene.candidates[i].reaction =
          structure_.frames[i] * reader_.vector(reactions[i], dimension_);
    }
    scene.displacements = by_node(configuration, "all_displacements");
    scene.support_reactions = by_node(configuration, "support_reactions");
  }

  // Rows in the order of the nodes, or by their names. No columns if the key does not exist.
  [[nodiscard]] Eigen::Matrix3Xd by_node(const ResultJson& configuration, const char* key) const {
    Eigen::Matrix3Xd vectors(3, 0);
    const auto* const values = ResultReader::find(configuration, key);
    if (values == nullptr) return vectors;
    const auto count = structure_.scene.positions.cols();
    vectors = Eigen::Matrix3Xd::Zero(3, count);
    if (values->is_array()) {
      const auto& rows = reader_.list(configuration, key, static_cast<std::size_t>(count));
      for (Eigen::Index node = 0; node < count; ++node)
        vectors.col(node) = reader_.vector(rows[static_cast<std::size_t>(node)], dimension_);
      return vectors;
    }
    for (const auto& [name, value] : values->items())
      vectors.col(node_named(name)) = reader_.vector(value, dimension_);
    return vectors;
  }

  const ResultReader& reader_;
  SceneChoice choice_;
  const ResultJson& result_;
  DrawnStructure structure_;
  int dimension_;
};

}  // namespace

std::vector<const ResultJson*> held_states(const ResultReader& reader) {
  const auto& result = reader.at(reader.all(), "result");
  std::vector<const ResultJson*> states;
  const auto take = [&](const ResultJson& entry) {
    if (ResultReader::find(entry, "state") != nullptr &&
        ResultReader::find(entry, "pattern") != nullptr)
      states.push_back(&entry);
  };
  if (const auto* const holding = ResultReader::find(result, "holding_friction")) take(*holding);
  if (ResultReader::find(result, "intervals") != nullptr) {
    for (const auto& each : reader.list(result, "intervals")) take(each);
  }
  return states;
}

std::pair<const ResultJson*, const ResultJson*> held_ends(const ResultReader& reader,
                                                          const ResultJson& interval) {
  return {reader.bound_value(reader.at(interval, "below"), "upper"),
          reader.bound_value(reader.at(interval, "above"), "lower")};
}

std::pair<double, double> held_range(const ResultReader& reader, const ResultJson& entry) {
  const bool interval = ResultReader::find(entry, "below") != nullptr;
  const auto [low, high] =
      interval ? held_ends(reader, entry) : std::pair<const ResultJson*, const ResultJson*>{};
  return {low == nullptr ? -HUGE_VAL : low->get<double>(),
          high == nullptr ? HUGE_VAL : high->get<double>()};
}

std::optional<double> given_friction(const ResultReader& reader) {
  const auto* const points = ResultReader::find(reader.at(reader.all(), "options"), "mu");
  if (points == nullptr || points->empty()) return {};
  return reader.number_of(points->front(), "'mu'");
}

std::string under_factor(double factor, double low, double high) {
  if (factor == 0) return "under the dead load";
  return "at factor " + rounded_within(factor, low, high, digits_of_picture);
}

std::vector<Scene> exclusion_scenes(const ResultReader& reader) {
  const auto& result = reader.at(reader.all(), "result");
  std::vector<Scene> scenes;
  if (ResultReader::find(result, "excluding_motions") == nullptr) return scenes;
  const SceneReader own(reader, {.maximum = 0});
  for (const auto& motion : reader.list(result, "excluding_motions"))
    scenes.push_back(own.exclusion_scene(motion));
  return scenes;
}

ResultScenes chosen_scenes(const ResultReader& reader, SceneChoice choice) {
  return SceneReader(reader, std::move(choice)).read();
}

ResultScenes result_scenes(const ResultReader& reader, const std::string& file,
                           SceneChoice choice) {
  const auto [first, maximum] = std::pair{choice.first, choice.maximum};
  auto all = chosen_scenes(reader, std::move(choice));
  if (reader.text(reader.all(), "command") == "hold") {
    all.things = "states or motions";
    for (auto& scene : exclusion_scenes(reader)) {
      if (const auto number = all.count++; number >= first && number - first < maximum)
        all.scenes.push_back(std::move(scene));
      all.picture.lines = {reader.sentence()};
    }
    if (all.picture.lines.empty()) all.picture.lines = {reader.sentence()};
  }
  if (all.count == 0) {
    throw WrongInput(fmt::format("{}: has no {}; expected at least one", file, all.things));
  }
  return all;
}

}  // namespace kusabi::run
