// Head, materials, supports, pairs, loads and weight.
#include "problems/files/decks/deck_problem.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "problems/files/decks/deck_draft.hpp"
#include "problems/files/decks/deck_pairs.hpp"
#include "problems/files/toml/toml_text.hpp"

namespace kusabi::problems {
namespace {

std::string stem_of(const std::string& file) {
  std::string stem = std::filesystem::path(file).stem().string();
  std::ranges::replace_if(
      stem, [](unsigned char one) { return std::isalnum(one) == 0 && one != '-'; }, '_');
  constexpr std::size_t longest = 16;  // names of nodes and groups follow it
  return stem.empty() || stem.size() > longest ? "deck" : stem;
}

std::string vector_text(const DeckDraft& draft, const Eigen::Vector3d& vector) {
  return draft.dimension() == 2 ? fmt::format("[{}, {}]", vector.x(), vector.y())
                                : fmt::format("[{}, {}, {}]", vector.x(), vector.y(), vector.z());
}

/// The weight of a deck: one acceleration, and for each section whether its elements have it.
struct DeckWeight {
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  std::vector<bool> of_section;
};

/// Acceleration of the elements of a section: the sum of the gravity that acts on them.
struct SectionGravity {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  MeshPlace at{};  ///< of the last gravity
};

/// Number of elements of a section on which gravity acts.
std::ptrdiff_t loaded_elements(const DeckDraft& draft, const MeshGravity& load,
                               const MeshSection& section) {
  if (load.group.empty()) return std::ssize(section.elements);
  const MeshGroup* group = draft.group(load.group);
  const std::set<int> loaded(group->elements.begin(), group->elements.end());
  return std::ranges::count_if(section.elements,
                               [&](int element) { return loaded.contains(element); });
}

/// Adds gravity to the sections with a density that it covers. Gravity on a part of their elements,
/// and gravity on none of them, is left out with a warning.
void add_gravity(DeckDraft& draft, const MeshGravity& load, std::vector<SectionGravity>& all) {
  const auto& sections = draft.mesh().sections;
  bool used = false;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const auto& section = sections[i];
    const auto count = section.density == 0 ? 0 : loaded_elements(draft, load, section);
    if (count == 0) continue;
    used = true;
    if (count == std::ssize(section.elements)) {
      all[i].acceleration += load.acceleration;
      all[i].at = load.at;
    } else {
      draft.warn(load.at, fmt::format("gravity on a part of the elements of {} is left out",
                                      draft.line(section.at)));
    }
  }
  if (!used) draft.warn(load.at, "gravity on elements without *DENSITY is left out");
}

DeckWeight weight_of(DeckDraft& draft) {
  const MeshData& mesh = draft.mesh();
  std::vector<SectionGravity> all(mesh.sections.size());
  for (MeshGravity load : mesh.gravity) {
    if (draft.dimension() == 2 && load.acceleration.z() != 0) {
      draft.warn(load.at, "gravity across the plane is left out");
      load.acceleration.z() = 0;
    }
    if (!load.acceleration.isZero(0)) add_gravity(draft, load, all);
  }
  DeckWeight weight{Eigen::Vector3d::Zero(), std::vector<bool>(all.size(), false)};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].acceleration.isZero(0)) continue;
    if (weight.gravity.isZero(0)) weight.gravity = all[i].acceleration;
    weight.of_section[i] = weight.gravity == all[i].acceleration;
    if (weight.of_section[i]) continue;
    draft.warn(all[i].at, fmt::format("gravity of another size or direction on the elements of {} "
                                      "is left out",
                                      draft.line(mesh.sections[i].at)));
  }
  return weight;
}

// The heading without control characters, cut to the length of a name between two characters.
std::string name_of(std::string heading) {
  std::ranges::replace_if(heading, is_control, ' ');
  std::size_t end = std::min(heading.size(), longest_text);
  const auto continues = [&](std::size_t place) {
    return (static_cast<unsigned char>(heading[place]) & 0xC0U) == 0x80U;
  };
  while (end < heading.size() && continues(end)) --end;
  heading.resize(end);
  return heading;
}

void write_head(DeckDraft& draft, const DeckChoices& choices, const std::string& prefix,
                const Eigen::Vector3d& gravity) {
  const std::string& heading = draft.mesh().heading;
  const std::string file = std::filesystem::path(choices.file).filename().string();
  draft.write(fmt::format(
      "# Written by kusabi import from {0}: edit it as needed. The deck has no units.\n", file));
  if (const double friction = largest_friction(draft.mesh()); friction > 0) {
    draft.write(fmt::format("# Its largest friction coefficient is {0}: --mu {0}\n", friction));
  }
  draft.write(fmt::format("name = {}\ndimension = {}\nunits = {{ length = {}, force = {} }}\n",
                          toml_text(heading.empty() ? prefix : name_of(heading)), draft.dimension(),
                          toml_text(choices.length), toml_text(choices.force)));
  if (!gravity.isZero(0)) draft.write(fmt::format("gravity = {}\n", vector_text(draft, gravity)));
  draft.write(fmt::format(
      "\n[[mesh]]\nname = {}\nfile = {}\nsupports = false            # those below instead\n",
      toml_text(prefix), toml_text(choices.file)));
}

/// The plane state that all elements of a section have; nothing in space, or if they differ.
std::optional<PlaneState> state_of(const MeshData& mesh, const MeshSection& section) {
  std::optional<PlaneState> state;
  for (const int number : section.elements) {
    const auto& own = mesh.elements[static_cast<std::size_t>(number)].state;
    if (state && own != state) return std::nullopt;
    state = own;
  }
  return state;
}

void write_material(DeckDraft& draft, const MeshSection& section, bool with_density) {
  const auto shape = [&](int number) {
    return draft.mesh().elements[static_cast<std::size_t>(number)].shape;
  };
  const bool bars = std::ranges::all_of(section.elements,
                                        [&](int one) { return mesh_dimension(shape(one)) == 1; });
  const bool bodies = std::ranges::any_of(
      section.elements, [&](int one) { return mesh_dimension(shape(one)) == draft.dimension(); });
  if (section.elements.empty() || (!bars && !bodies)) return;
  draft.write(fmt::format("\n[[material]]               # {}\ngroups = {}\n", section.material,
                          toml_texts({draft.name(section.set)})));
  if (!section.fault.empty()) {
    draft.warn(section.at, fmt::format("{}: give E and nu in the problem file", section.fault));
    draft.write("# E and nu of an isotropic material\n");
  } else {
    draft.write(fmt::format("E = {}\n", section.modulus));
    draft.write(bars ? fmt::format("A = {}\n", section.measure)
                     : fmt::format("nu = {}\n", section.ratio));
  }
  if (with_density) draft.write(fmt::format("density = {}\n", section.density));
  if (draft.dimension() == 3 || bars) return;
  draft.write(fmt::format("thickness = {}\n", section.measure));
  if (const auto state = state_of(draft.mesh(), section)) {
    draft.write(
        fmt::format("plane = \"{}\"\n", *state == PlaneState::stress ? "stress" : "strain"));
  }
}

void write_support(DeckDraft& draft, const ChosenNodes& nodes, const std::array<bool, 3>& fixed) {
  std::vector<std::string> axes;
  for (int axis = 0; axis < draft.dimension(); ++axis)
    if (fixed[static_cast<std::size_t>(axis)]) axes.emplace_back(1, "xyz"[axis]);
  draft.write(fmt::format("\n[[supports]]\n{}", draft.lines(nodes)));
  if (static_cast<int>(axes.size()) < draft.dimension())
    draft.write(fmt::format("fixed = {}\n", toml_texts(axes)));
}

void write_load(DeckDraft& draft, const ChosenNodes& nodes, const std::array<double, 3>& force) {
  draft.write(fmt::format("\n[[loads]]\nkind = \"dead\"\n{}force = {}\n", draft.lines(nodes),
                          vector_text(draft, Eigen::Vector3d(force.data()))));
}

// Calls `write` with all nodes of each value. Sets whose nodes have the same value stand for their
// nodes, the largest first.
template <class Value, class Write>
void write_by_sets(DeckDraft& draft, std::map<Value, std::set<int>>& left, const Write& write) {
  std::vector<ChosenNodes> sets;
  for (const MeshGroup& group : draft.mesh().groups)
    if (!group.nodes.empty()) sets.push_back(draft.nodes_of(group));
  std::ranges::stable_sort(sets, std::greater(), [](const auto& set) { return set.all.size(); });
  for (auto& [value, nodes] : left) {
    for (const ChosenNodes& set : sets) {
      const auto is_left = [&nodes = nodes](int node) { return nodes.contains(node); };
      if (set.all.empty() || !std::ranges::all_of(set.all, is_left)) continue;
      for (const int node : set.all) nodes.erase(node);
      write(draft, set, value);
    }
    if (!nodes.empty()) write(draft, {"", {}, {nodes.begin(), nodes.end()}}, value);
  }
}

void warn_of_outside(DeckDraft& draft, const char* what, const auto& entries) {
  const auto outside =
      std::ranges::count_if(entries, [&](const auto& entry) { return !draft.is_used(entry.node); });
  if (outside == 0) return;
  draft.warn(entries.front().at,
             fmt::format("{} of {} nodes of no element are left out", what, outside));
}

void write_supports(DeckDraft& draft) {
  std::map<std::array<bool, 3>, std::set<int>> left;
  const auto& supports = draft.mesh().supports;
  for (const MeshSupport& support : supports) {
    auto fixed = support.fixed;
    if (draft.dimension() == 2) fixed[2] = false;
    if (draft.is_used(support.node) && (fixed[0] || fixed[1] || fixed[2]))
      left[fixed].insert(support.node);
  }
  warn_of_outside(draft, "supports", supports);
  write_by_sets(draft, left, write_support);
}

void write_loads(DeckDraft& draft) {
  std::map<std::array<double, 3>, std::set<int>> left;
  const auto& loads = draft.mesh().loads;
  for (const MeshLoad& load : loads) {
    const std::array<double, 3> force{load.force.x(), load.force.y(),
                                      draft.dimension() == 3 ? load.force.z() : 0.0};
    if (draft.is_used(load.node) && force != std::array<double, 3>{}) left[force].insert(load.node);
  }
  warn_of_outside(draft, "loads", loads);
  write_by_sets(draft, left, write_load);
}

}  // namespace

DeckProblem deck_problem(const MeshData& mesh, const DeckChoices& choices) {
  const std::string prefix = stem_of(choices.file);
  DeckDraft draft(mesh, prefix);
  const DeckWeight weight = weight_of(draft);
  write_head(draft, choices, prefix, weight.gravity);
  for (std::size_t i = 0; i < mesh.sections.size(); ++i)
    write_material(draft, mesh.sections[i], weight.of_section[i]);
  write_supports(draft);
  write_pairs(draft, choices.gap);
  write_loads(draft);
  DeckProblem result{draft.text(), mesh.warnings};
  result.warnings.insert(result.warnings.end(), draft.warnings().begin(), draft.warnings().end());
  return result;
}

}  // namespace kusabi::problems
