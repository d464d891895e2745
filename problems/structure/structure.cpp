// Errors that know where in its file a structure's entry stands.
#include "problems/structure/structure.hpp"

#include <algorithm>
#include <cstddef>

namespace kusabi::problems {

std::string candidate_name(const Structure& structure, const ContactCandidate& candidate) {
  const auto name = [&](int node) { return structure.node_names[static_cast<std::size_t>(node)]; };
  const auto& place = candidate.against;
  if (place.empty()) return name(candidate.node);
  const auto nearest = std::ranges::max_element(place, {}, &Share::weight);
  return name(candidate.node) + "|" + name(nearest->node) + (place.size() > 1 ? "+" : "");
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
