// Names of candidates, and errors with the place of an entry in its file.
#include "problems/structure/model/structure.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace kusabi::problems {

namespace {

/// Suffix "@left" or "@2" of a candidate at a node with several; empty for a single one.
std::string which_at_node(const Structure& structure, std::size_t index) {
  std::set<std::string> surfaces;
  std::size_t count = 0;
  std::size_t place = 0;
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const ContactCandidate& other = structure.contact[i];
    if (other.node != structure.contact[index].node) continue;
    ++count;
    if (i <= index) ++place;
    if (!other.surface.empty()) surfaces.insert(other.surface);
  }
  if (count == 1) return {};
  return "@" +
         (surfaces.size() == count ? structure.contact[index].surface : std::to_string(place));
}

}  // namespace

bool has_struts(const Structure& structure) {
  return std::ranges::any_of(structure.members, [](const Member& member) {
    return member.yield && member.yield->residual;
  });
}

Structure after_buckling(Structure structure) {
  for (Member& member : structure.members) {
    if (member.yield && member.yield->residual)
      member.yield->compression = *std::exchange(member.yield->residual, std::nullopt);
  }
  return structure;
}

std::optional<int> node_named(const Structure& structure, const std::string& name) {
  const auto first = std::ranges::find(structure.node_names, name);
  if (first != structure.node_names.end())
    return static_cast<int>(first - structure.node_names.begin());
  const auto further = structure.more_names.find(name);
  return further == structure.more_names.end() ? std::nullopt : std::optional(further->second);
}

std::string quoted_name(const Structure& structure, int node) {
  return support::in_quotes(structure.node_names[static_cast<std::size_t>(node)]);
}

std::string candidate_name(const Structure& structure, std::size_t index) {
  const auto name = [&](int node) { return structure.node_names[static_cast<std::size_t>(node)]; };
  const ContactCandidate& candidate = structure.contact[index];
  const auto& place = candidate.against;
  const std::string own = name(candidate.node) + which_at_node(structure, index);
  if (place.empty()) return own;
  const auto nearest = std::ranges::max_element(place, {}, &WeightedNode::weight);
  return own + "|" + name(nearest->node) + (place.size() > 1 ? "+" : "");
}

int body_elements(const Structure& structure) {
  return static_cast<int>(structure.elements.size() + structure.outlines.size());
}

const Element& body_element(const Structure& structure, int index) {
  const auto place = static_cast<std::size_t>(index);
  const auto own = structure.elements.size();
  return place < own ? structure.elements[place] : structure.outlines[place - own];
}

std::string_view axis_name(int axis) {
  return std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1);
}

support::InputError structure_error(const Structure& structure, support::SourcePosition position,
                                    std::string_view message) {
  const Sources& sources = structure.sources;
  if (position.file > 0) {
    const auto index = static_cast<std::size_t>(position.file) - 1;
    return support::InputError(sources.more_files[index], position, message);
  }
  return support::InputError(sources.file.empty() ? structure.name : sources.file, position,
                             message);
}

support::SourcePosition position_of(const std::vector<support::SourcePosition>& positions,
                                    int index) {
  const auto place = static_cast<std::size_t>(index);
  return place < positions.size() ? positions[place] : support::SourcePosition{};
}

}  // namespace kusabi::problems
